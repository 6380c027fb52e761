/**
# 3.2 Static breathers of the DpS equation

Which breathers exist in the limit of small amplitude, and how good is the article's approximation of them? Section 3.2
of James, Kevrekidis and Cuevas (Physica D 251, 2013) has two of the form $v_n = u_n e^{i\mu t}$, both narrow, with
neighbours of opposite sign: one around a site, $u_{-n} = u_n$, and one around a bond, $u_{1-n} = -u_n$. We compute both
by Newton's method, to the last digit and far into their tails.

![Both breathers, their quasi-continuum approximation and their tails. Drawn by x03_dps_profiles.py from `profile_site`
and `profile_bond`: `u` and `quasi_continuum`, their logarithms, `double_log` and `tail_line` against `n`.](fig:x03)

The article states that their amplitude is proportional to $\mu^2$ at unchanged width, and that a quasi-continuum
approximation with support $|x| \le 3\pi/2$ is in excellent agreement with them. We also find that the two have almost
the same norm, which suggests that a small breather moves at little cost (section 3.3). The breathers of the chain
itself follow in `sec32_newton_breathers`. */

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "commands/one_profile.hpp"
#include "lattice/gsl/reference.hpp"
#include "lattice/quadruple/extended.hpp"
#include "report/program.hpp"
#include "sec3/continuum.hpp"

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;
using namespace lattice;

/**
## The equations and Newton's method

In the rescaled time of Eq. (11) the DpS equation is $i\dot v_n = w_n - w_{n-1}$, where $w_n = d_n|d_n|^{1/2}$ is the
force of the strain $d_n = v_{n+1}-v_n$. With $v_n = u_n e^{i\mu t}$ and real $u_n$ it becomes Eq. (14),
$-\mu u_n = w_n - w_{n-1}$. The ends are free: there the outer contact is missing. A breather of the chain with
frequency $\omega_b$ is then nearly $y_n = 2\epsilon\,u_n\cos\omega_b t$ with $\mu = 1$, Eq. (20).

The difference of the equations at neighbouring sites contains strains only, and by symmetry those of one half suffice:
$$w_{n+1} - 2w_n + w_{n-1} + \mu d_n = 0,\qquad n \ge 0,\qquad
  w_{-1} = -w_0 \text{ (site)},\quad w_{-1} = w_1 \text{ (bond)}.$$
This removes the only direction in which Newton's method could drift, a shift along the chain. It also keeps the tail
accurate: there $d_n \approx -w_{n-1}/\mu$, so each strain follows from the one before without cancellation. Newton's
method starts from the article's approximation, and every step adds one more strain of the tail. With
$g(x) = (\frac3{10})^3\cos^6(x/3)$ for $|x| \le 3\pi/2$ and zero elsewhere, the approximation is
$$u_n = (-1)^n[g(n+\tfrac12)+g(n-\tfrac12)] \text{ (site, Eq. (19))},\qquad
  u_n = (-1)^n[g(n)+g(n-1)] \text{ (bond, Eq. (18))}.$$ */
constexpr double top = 0.027, edge = 3 * std::numbers::pi / 2;  // (3/10)^3, and where g ends

double g(double x) {
  const double c = std::abs(x) < edge ? std::cos(x / 3) : 0, c3 = c * c * c;
  return top * c3 * c3;
}

double approximate(Centre centre, long n) {
  const double x = double(n) + (centre == Centre::bond ? 0 : 0.5), u = g(x) + g(x - 1);
  return n % 2 == 0 ? u : 0 - u;
}

/// The strains d_0, ..., d_9 of the right half at mu = 1.
VectorXd newton(Centre centre) {
  // The second differences as a matrix, with the symmetry in its first row and a free end in its last
  const MatrixXd identity = MatrixXd::Identity(10, 10);
  MatrixXd differences = -2 * identity;
  differences.diagonal(1).setOnes();
  differences.diagonal(-1).setOnes();
  if (centre == Centre::site) differences(0, 0) -= 1;
  if (centre == Centre::bond) differences(0, 1) += 1;
  // The start, zero in the tail
  VectorXd d = VectorXd::Zero(10);
  for (Index n = 0; n < 4; ++n) d[n] = approximate(centre, n + 1) - approximate(centre, n);
  std::string history;
  for (int k = 0; k < 20; ++k) {
    const VectorXd root = d.cwiseAbs().cwiseSqrt();
    const VectorXd residual = differences * d.cwiseProduct(root) + d;
    const MatrixXd derivative = differences * (1.5 * root).asDiagonal() + identity;
    const VectorXd step = derivative.partialPivLu().solve(residual);
    d -= step;
    // Relative to each strain: those of the tail, zero at first, come in one step after the other
    const double correction =
        (d.array() != 0).all() ? step.cwiseQuotient(d).cwiseAbs().maxCoeff() : 1;
    if (correction < 1e-12) return d;
    history += " " + short_text(correction);
  }
  throw Failure("Newton's method does not converge, relative corrections" + history);
}

/**
The library has the same method for any $\mu$, exponent and precision (stationary.hpp). It iterates the relative
corrections and lengthens the chain site by site, down to the last strain that the number format can represent. The
tables need those tails and more digits, so they are made with it, on 31 sites around a site and 32 around a bond, in
double and in quadruple precision; the difference is the error. The iteration on this page is the check of the library:
both routes must agree, or the run stops. */
template <class T>
double rounded(const T& x) {
  return static_cast<double>(x);
}

/**
## Both breathers and their approximation (figure x03)

The article calls the agreement excellent and gives no number. Ours is the largest difference over the sites relative to
the largest displacement (`continuum_difference` of continuum.hpp): six per cent for both breathers. It occurs one or
two sites from the largest displacement, where the approximation is too wide. At the size of the article's figure the
difference is easily overlooked, and the approximation is a good first guess for Newton's method.

| | article | around a site | around a bond |
|---|---|---|---|
| difference over the amplitude | excellent | [0.0575](cell:breathers/centre=site/difference) | [0.0614](cell:centre=bond/difference) |

The article calls the decay super-exponential. Far from the centre $u_n$ is small against $u_{n-1}$, so
$-\mu u_n \approx -w_{n-1}$ and $|u_n| \approx |u_{n-1}|^{3/2}/\mu$. At $\mu = 1$ the ratio $\ln|u_{n+1}|/\ln|u_n|$
therefore tends to 3/2, and $\ln(-\ln|u_n|)$ in the figure to a straight line of slope $\ln\frac32$. It does so very
fast: at $n = 4$, where the profile has just become invisible in a plot, the ratio is 3/2 to one part in a thousand. */
void report_profile(Report& report, Centre centre, const std::string& name) {
  // Some moduli are far below the smallest double, so their logarithms are taken in quadruple precision
  const auto u = stationary<double>(centre, 1, sites_of(centre)).u;
  const auto wide = stationary<Quadruple>(centre, 1, u.size()).u;
  const auto double_log = [&](std::size_t i) {
    return rounded(Quadruple(log(-log(abs(wide[i])))));
  };
  Table& table = report.table(
      "profile_" + name, {count("n", "site", "site"),
                          estimate("u", "stationary DpS breather, mu = 1", "",
                                   "difference of double and quadruple precision"),
                          number("quasi_continuum", "quasi-continuum profile"),
                          number("log10_u", "decimal logarithm of |u_n|"),
                          number("log10_quasi_continuum",
                                 "decimal logarithm of |quasi_continuum|; nan where it is zero"),
                          number("double_log", "ln(-ln|u_n|)"),
                          number("tail_line", "line of slope ln(3/2) through the last point")});
  for (std::size_t i = 0; i < u.size(); ++i) {
    const long n = site_number(i, u.size()), last = site_number(u.size() - 1, u.size());
    const long distance = centre == Centre::bond && n < 1 ? 1 - n : std::abs(n);
    const double near = approximate(centre, n);
    table.add({n, compare(u[i], rounded(wide[i])), near, rounded(Quadruple(log10(abs(wide[i])))),
               near != 0 ? std::log10(std::abs(near)) : std::nan(""), double_log(i),
               double_log(u.size() - 1) + double(distance - last) * std::log(1.5)});
  }
}

/**
## The approximation solves its equation

The forces of both breathers alternate in sign with a smooth envelope, $w_n = (-1)^n f(n)$. Replacing $f(n\pm1)$ by
three terms of a Taylor series gives Eq. (17), $F'' = -4F + F|F|^{-1/3}$. Its last term has an infinite slope at
$F = 0$, which lets a solution reach zero and stay there. Multiplied by $F'$ and integrated with $F = F' = 0$ at the
edge it becomes $F'^2 = \frac65F^{5/3} - 4F^2$. So $F$ is largest at $F^{1/3} = \frac3{10}$, and the half-width of the
support is the integral of $dF/|F'|$ from zero to there.

With $F = z^3$ this is Euler's beta integral,
$$\int_0^{3/10}\frac{3\,dz}{\sqrt{z(\frac65-4z)}} = \frac32\,B(\tfrac12,\tfrac12) = \frac{3\pi}2.$$

Substitution shows that the printed $g$ is that solution. We let GSL integrate Eq. (17) from $F(0) = (\frac3{10})^3$,
$F'(0) = 0$, and record the largest difference from $g$, over the height of it, up to a twentieth before the edge.
(There $F$ is nearly zero, and an error grows with the inverse fourth power of what is left.) The same with a height
that is one per cent larger tells how sharp that is. */
Estimate distance_from_solution(double factor) {
  const auto apart = [&](double tolerance) {
    const auto equation = [](double, const double* x, double* rate) {
      rate[0] = x[1];
      rate[1] = -4 * x[0] + std::cbrt(x[0] * x[0]);
    };
    Reference method(equation, 2, {tolerance * top, tolerance, gsl_odeiv2_step_rk8pd});
    std::vector<double> F{factor * top, 0};
    double x = 0, most = 0;
    for (int k = 1; k <= 95; ++k) {
      method.advance(x, k * edge / 100, F);
      most = std::max(most, std::abs(F[0] / factor - g(x)) / top);
    }
    return most;
  };
  return compare(apart(1e-11), apart(1e-13));
}

void report_support(Report& report) {
  const auto half_width = []<class T>(T half) { return double(T(1.5) * std::beta(half, half)); };
  report.table("support").add(Row{
      {"half_width", "of the quasi-continuum profile", compare(half_width(0.5), half_width(0.5L)),
       "", "difference of double and extended precision"},
      {"distance", "of g from the solution of Eq. (17) with its height, over it",
       distance_from_solution(1), "", "difference of two tolerances, relative to the height"},
      {"control", "the same from the solution that is one per cent higher, over that height",
       distance_from_solution(1.01), "", "difference of two tolerances"}});
}

/**
## Two norms that are almost equal

In the limit of small amplitude the energy of the chain's breather is $2\epsilon^2 N$ with the norm $N = \sum u_n^2$, so
at equal frequency the energies of the two breathers differ by the same fraction as the two norms, about one in a
million. So it is plausible that a slight push sets a small breather in motion. (A moving breather keeps its action, not
its frequency; sec32_barrier.cpp computes the energy that a step from site to site then costs.) Why the norms are so
nearly equal, and why the one around a bond is the smaller, we do not know. The norm around a site is
[0.005360](cell:breathers/centre=site/norm); that around a bond differs from it by the fraction
[-1.331e-6](cell:norms/gap). */
void report_norms(Report& report) {
  // The gap is six digits smaller than the norms, so extended precision is compared with quadruple
  const auto gap = []<class T>(T one) {
    return rounded(T(stationary<T>(Centre::bond, one, 32).norm() -
                     stationary<T>(Centre::site, one, 31).norm()));
  };
  const double site = rounded(stationary<Quadruple>(Centre::site, 1, 31).norm());
  const Estimate difference = compare(gap(1.0L), gap(Quadruple(1)));
  report.table("norms").add(Row{{"gap", "norm around the bond minus that around the site, over it",
                                 Estimate{difference.value / site, difference.error / site}, "",
                                 "difference of extended and quadruple precision"}});
}

/**
## Scaling with the frequency

If $u$ solves the equation at $\mu = 1$, $\mu^2u$ solves it at $\mu$: the amplitude grows like $\mu^2$ at unchanged
width. To test the computation by this law, we continue the branch from $\mu = 1$ to 64 and to 1/64 in steps of an
eighth of an octave, and each time start Newton's method from the *unscaled* strains of the neighbour, the four around
its centre. At either end and at every site that carries the breather $\ln|u_n/u_n(1)|$ over $\ln\mu$ must be two. None
differs from it by more than rounding (`exponent` of the table `breathers`). */
template <class T>
double exponent_farthest_from_two(Centre centre, int steps) {
  using std::exp2, std::log, std::abs;
  const auto one = stationary<T>(centre, T(1), sites_of(centre));
  double farthest = 2;
  for (int direction : {1, -1}) {
    auto state = one;
    for (int k = 1; k <= steps; ++k)
      state =
          stationary_from<T>(centre, exp2(T(direction * k) / T(8)),
                             {state.strain.begin(), state.strain.begin() + 4}, sites_of(centre));
    for (std::size_t i = 0; i < one.u.size(); ++i) {
      if (!(abs(one.u[i]) > T(1e-6))) continue;  // the sites that carry the breather
      const double exponent = rounded<T>(log(abs(state.u[i] / one.u[i])) / log(state.mu));
      if (std::abs(exponent - 2) > std::abs(farthest - 2)) farthest = exponent;
    }
  }
  return farthest;
}

void report_breathers(Report& report) {
  const int steps = report.quick ? 16 : 48;  // a quick run goes two octaves each way
  Table& table = report.table("breathers");
  for (const Centre centre : both_centres) {
    const auto narrow = stationary<double>(centre, 1, sites_of(centre));
    const auto wide = stationary<Quadruple>(centre, 1, sites_of(centre));
    const char* precisions = "difference of double and quadruple precision";
    table.add(
        {{"centre", "site or bond", centre == Centre::site ? "site" : "bond"},
         {"difference", "from the quasi-continuum profile, over the amplitude",
          compare(continuum_difference(narrow), rounded(continuum_difference(wide))), "",
          precisions},
         {"norm", "sum of u_n^2", compare(narrow.norm(), rounded(wide.norm())), "", precisions},
         {"exponent", "of the amplitude in mu, at the site where it is farthest from two",
          compare(exponent_farthest_from_two<double>(centre, steps),
                  exponent_farthest_from_two<long double>(centre, steps)),
          "", "difference of double and extended precision"}});
  }
}

/**
## Accuracy and checks

Two precisions reveal rounding, but no error of the method. So three more checks stop the run if they fail. The ten
strains of the first listing agree with the library's to twelve digits, over 25 decades and more; as the two chains
differ in length, the free ends hardly matter. Eq. (14) holds when the $u_n$ are inserted, relative to $\mu u_n$ at each
site, so that the tail is tested as sharply as the centre. Multiplied by $u_n$ and summed by parts it also gives
$\sum|u_{n+1}-u_n|^{5/2} = \mu N$, which Newton's method does not use. The last two hold to ten roundings in double and
to twenty in quadruple precision.

Tails end where the number format does; beyond that the tables contain zeros. */
template <class T>
void assert_solution(const Stationary<T>& state, T bound) {
  using std::abs, std::sqrt;
  const auto& u = state.u;
  const auto w = [&](std::size_t i) {  // the force between the sites i - 1 and i
    if (i == 0 || i == u.size()) return T(0);
    const T d = u[i] - u[i - 1];
    return T(d * sqrt(abs(d)));
  };
  for (std::size_t i = 0; i < u.size(); ++i)
    if (abs(u[i]) > least_exact<T>() && !(abs(1 + (w(i + 1) - w(i)) / (state.mu * u[i])) < bound))
      throw Failure("Eq. (14) does not hold at site " + std::to_string(site_number(i, u.size())));
  if (!(abs(state.contact_sum() / (state.mu * state.norm()) - 1) < bound))
    throw Failure("contact sum and norm differ");
}

void check(Centre centre) {
  const VectorXd d = newton(centre);
  const auto library = stationary<double>(centre, 1, sites_of(centre));
  for (Index n = 0; n < d.size(); ++n)
    if (!(std::abs(d[n] / library.strain[std::size_t(n)] - 1) < 1e-12))
      throw Failure("the library finds a different strain d_" + std::to_string(n));
  assert_solution(library, 2e-15);
  assert_solution(stationary<Quadruple>(centre, 1, sites_of(centre)), Quadruple(4e-33));
}

void reproduce(Report& report) {
  report.output.note("tolerance", "relative corrections of the strains below a hundred roundings");
  for (const Centre centre : both_centres) check(centre);
  report_norms(report);
  report_support(report);
  report_profile(report, Centre::site, "site");
  report_profile(report, Centre::bond, "bond");
  report_breathers(report);
}

/**
## Statement by statement

<!-- statements -->
| statement | printed | here | verdict |
|---|---|---|---|
| `dps.scaling`: breather amplitude is proportional to mu^2 at unchanged width | 2 | 2.000 | reproduced |
| `dps.qc_support`: half-width of the compact quasi-continuum profile g(x) = (3/10)^3 cos^6(x/3) | 3 pi/2 | 4.712 | reproduced |
| `dps.qc_solution`: g with the amplitude (3/10)^3 solves Eq. (17) |  | support.distance: 1.06e-12 < 1e-06 | holds |
| `dps.qc_site`: site-centred stationary DpS breather agrees with its quasi-continuum profile | excellent | 0.05745 share of the amplitude | quantified |
| `dps.qc_bond`: bond-centred stationary DpS breather agrees with its quasi-continuum profile | excellent | 0.06143 share of the amplitude | quantified |
<!-- /statements -->

## Try it

`sec32_dps_profiles profile` prints one profile beside its approximation, for any $\mu$ and any exponent of the contacts
(commands/one_profile.hpp).

**To change it.** The first listing takes another exponent $\alpha$ of the contacts (the other sections compare with
formulas for spheres): `root` is $|d|^{\alpha-1}$ in `newton`, $\alpha$ stands for 1.5 in its derivative and in
`tail_line`, the force `w` of `assert_solution` has the power $\alpha$, `approximate` is `quasi_continuum(centre, n,
alpha)` (model/quasi_continuum.hpp), and $\alpha$ is the last argument of `stationary` and `stationary_from`.

1. *Easy.* How good is $y_n = 2\epsilon u_n\cos\omega_bt$ for a small breather of the chain?
   `build/bin/sec32_newton_breathers breather --omega 1.001` gives `amplitude` = 9.63900e-7. Hint: Eq. (20) gives
   $\epsilon$, and `profile` gives $u_0$.
2. *Harder.* Are the two energies as close for contacts of another exponent? `build/bin/sec32_barrier barrier --omega
   1.01 --contact power --alpha 2` gives `equal_frequency` = 3.79482e-8. Hint: divide by the energy that `breather`
   prints with the same options, and compare with the gap of the norms for spheres. */
int main(int argc, char** argv) {
  return run({"sec32_dps_profiles", "3.2", "Static breathers of the DpS equation (section 3.2)",
              reproduce, commands<OneProfile>()},
             argc, argv);
}
