/**
# 3.2 Static breathers of the DpS equation

Which breathers exist in the limit of small amplitude, and how good is the article's approximation of them? Section 3.2
of James, Kevrekidis and Cuevas (Physica D 251, 2013) has two of the form $v_n = u_n e^{i\mu t}$ with neighbours of
opposite sign: one around a site, $u_{-n} = u_n$, and one around a bond, $u_{1-n} = -u_n$. Newton's method finds both
from a dozen strains; beyond its few large sites a breather falls so fast that each modulus is the power 3/2 of the one
before. The quasi-continuum approximation is good where the breather is large, and wrong by more than half at its edge.
The surprise is that the norms of the two breathers differ by one part in a million only.

![Both breathers, their quasi-continuum approximation and tails, and the error of a short chain. Drawn by
x03_dps_profiles.py: `u` and `quasi_continuum` of `profile_site` and `profile_bond` against `n`, and `site` and `bond`
of `lengths` against `strains`.](fig:x03)

<!-- head -->
`build/bin/sec32_dps_profiles` computes this chapter in less than 1 s on two cores and writes 7 tables to
`build/data/sec32_dps_profiles`. Its figures: `make x03`. With your parameters: `profile`, one static DpS breather and
its quasi-continuum approximation.
<!-- /head --> */

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "commands/one_profile.hpp"
#include "lattice/algebra/dense.hpp"
#include "lattice/gsl/reference.hpp"
#include "lattice/model/sites.hpp"
#include "lattice/quadruple/extended.hpp"
#include "lattice/standing/stationary.hpp"
#include "report/program.hpp"

using Eigen::Index;
using namespace lattice;

/**
## The equation and Newton's method

In the rescaled time of Eq. (11) the DpS equation is $i\dot v_n = w_n - w_{n-1}$, where $w_n = d_n|d_n|^{1/2}$ is the
force of the strain $d_n = v_{n+1}-v_n$. With $v_n = u_n e^{i\mu t}$ and real $u_n$ it becomes Eq. (14), $\mu u_n =
w_{n-1} - w_n$. The ends are free: there the outer contact is missing. A breather of the chain with frequency
$\omega_b$ is then nearly $y_n = 2\epsilon\,u_n\cos\omega_b t$ with $\mu = 1$, Eq. (20).

The difference of the equations at neighbouring sites contains strains only, and by symmetry those of one half suffice:
$$w_{n+1} - 2w_n + w_{n-1} + \mu d_n = 0,\qquad n \ge 0,\qquad
  w_{-1} = -w_0 \text{ (site)},\quad w_{-1} = w_1 \text{ (bond)}.$$
The symmetry keeps the breather from sliding along the chain, a direction in which the equations are nearly
indifferent. The strains keep the tail accurate: there $d_n \approx -w_{n-1}/\mu$, without cancellation.

The article's approximation is the start. If the forces alternate, $w_n = (-1)^{n+1}g$ with a smooth envelope $g$
around the centre, Eq. (14) at $\mu = 1$ gives
$$u_n = (-1)^n[g(n+\tfrac12)+g(n-\tfrac12)] \text{ (site, Eq. (19))},\qquad
  u_n = (-1)^n[g(n)+g(n-1)] \text{ (bond, Eq. (18))},$$
with $g(x) = (\frac3{10})^3\cos^6(x/3)$ for $|x| \le 3\pi/2$ and zero elsewhere. A wrong tail would be fatal, since
its errors grow like the tail itself, so the start has the four strains inside the support. Each step of Newton's
method adds one more. */
constexpr double alpha = 1.5;  // exponent of the contacts, 3/2 for spheres
constexpr Index strains = 12;  // of the right half: 25 sites around a site, 24 around a bond
constexpr int newton_steps = 30;
constexpr double other_mu = 1.25;  // for the scaling; the same start must lead there
constexpr double m = 2 * alpha / (alpha - 1), edge = std::numbers::pi * m / 4;  // 6 and 3 pi/2
const double height = std::pow(m / (4 * (m - 1)), m / 2);                       // (3/10)^3

double g(double x) {
  return std::abs(x) < edge ? height * std::pow(std::cos(2 * x / m), m) : 0;
}

double approximation(Centre centre, long n) {
  const double x = double(n) + (centre == Centre::bond ? 0 : 0.5), u = g(x) + g(x - 1);
  return n % 2 == 0 ? u : 0 - u;  // never minus zero
}

template <class T>
struct Breather {
  Centre centre;
  Vector<T> d, u;  // of the right half: strains d_0, d_1, ... and displacements u_0, u_1, ...

  T at(long n) const {
    if (n >= 0) return u(n);
    return centre == Centre::site ? u(-n) : T(-u(1 - n));
  }
  /// N = sum u_n^2.
  T norm() const {
    const T right = u.tail(u.size() - 1).squaredNorm();
    return centre == Centre::site ? T(u(0) * u(0) + 2 * right) : T(2 * right);
  }
};

template <class T>
Breather<T> breather(Centre centre, T mu = 1, Index count = strains) {
  // The second differences as a matrix, with the symmetry in its first row and a free end in its last
  const Matrix<T> identity = Matrix<T>::Identity(count, count);
  Matrix<T> differences = T(-2) * identity;
  differences.diagonal(1).setOnes();
  differences.diagonal(-1).setOnes();
  if (centre == Centre::site) differences(0, 0) -= T(1);
  if (centre == Centre::bond) differences(0, 1) += T(1);

  // The start, and Newton's method for differences * w + mu * d = 0
  Vector<T> d = Vector<T>::Zero(count), root, step;
  for (Index n = 0; n < std::min(count, Index(edge)); ++n)
    d(n) = T(approximation(centre, n + 1) - approximation(centre, n));
  for (int k = 0; k < newton_steps; ++k) {
    root = d.unaryExpr([](const T& x) { return secant_stiffness(x, alpha); });  // |d|^(alpha-1)
    const Matrix<T> derivative = T(alpha) * differences * root.asDiagonal() + mu * identity;
    step = solve_square<T>(derivative, differences * d.cwiseProduct(root) + mu * d);
    d -= step;
  }
  const T last = step.cwiseQuotient(d).cwiseAbs().maxCoeff();  // relative to each strain
  if (!(last < T(1e4) * std::numeric_limits<T>::epsilon()))
    throw Failure("Newton's method does not converge, last correction " + short_text(double(last)));

  // Eq. (14) gives the displacements
  const Vector<T> w = d.cwiseProduct(root);
  Vector<T> u(count + 1);
  u(0) = (centre == Centre::site ? -2 * w(0) : w(1) - w(0)) / mu;
  for (Index n = 1; n < count; ++n) u(n) = (w(n - 1) - w(n)) / mu;
  u(count) = w(count - 1) / mu;
  return {centre, d, u};
}

/// A number that is read from a breather; its error is the difference of double and quadruple precision.
template <class Number>
Estimate known(Centre centre, Number number) {
  return compare(double(number(breather<double>(centre))),
                 double(number(breather<Quadruple>(centre))));
}
const char* const precisions = "difference of double and quadruple precision";

/**
Two precisions reveal rounding, but not a wrong equation. So the strains must agree to twelve digits with those of the
library, which iterates relative corrections on a chain that grows site by site (stationary.hpp); the tests insert its
$u_n$ into Eq. (14). */
void check(Centre centre) {
  const Vector<double> d = breather<double>(centre).d;
  const auto library = stationary<double>(centre, 1, sites_of(centre, alpha), alpha);
  for (Index n = 0; n < d.size(); ++n)
    if (!(std::abs(d(n) / library.strain[std::size_t(n)] - 1) < 1e-12))
      throw Failure("the library finds a different strain d_" + std::to_string(n));
}

/**
## Both breathers and their approximation (figure x03 a to c)

The article calls the agreement excellent and gives no number. Ours is the largest difference over the sites relative
to the largest displacement: [0.0575](cell:breathers/centre=site/difference) for the breather around a site and
[0.0614](cell:breathers/centre=bond/difference) around a bond. It occurs one or two sites from the centre, where the
approximation is too wide. This measure flatters. Relative to $u_n$ itself the approximation is more than half too
large at $n = 3$ or 4, and too small beyond, where its support ends:

| | $n = 1$ | 2 | 3 | 4 | 5 |
|---|---|---|---|---|---|
| approximation over $u_n$, site | [1.045](cell:by_site/centre=site/n=1/approximation) | [1.243](cell:by_site/centre=site/n=2/approximation) | [1.567](cell:by_site/centre=site/n=3/approximation) | [1.377](cell:by_site/centre=site/n=4/approximation) | [0.0054](cell:by_site/centre=site/n=5/approximation) |
| approximation over $u_n$, bond | [0.9998](cell:by_site/centre=bond/n=1/approximation) | [1.125](cell:by_site/centre=bond/n=2/approximation) | [1.398](cell:by_site/centre=bond/n=3/approximation) | [1.650](cell:by_site/centre=bond/n=4/approximation) | [0.533](cell:by_site/centre=bond/n=5/approximation) |
| $\ln\lvert u_{n+1}\rvert/\ln\lvert u_n\rvert$, site | [1.327](cell:by_site/centre=site/n=1/tail) | [1.446](cell:by_site/centre=site/n=2/tail) | [1.489](cell:by_site/centre=site/n=3/tail) | [1.499](cell:by_site/centre=site/n=4/tail) | [1.500](cell:by_site/centre=site/n=5/tail) |
| $\ln\lvert u_{n+1}\rvert/\ln\lvert u_n\rvert$, bond | [1.231](cell:by_site/centre=bond/n=1/tail) | [1.399](cell:by_site/centre=bond/n=2/tail) | [1.474](cell:by_site/centre=bond/n=3/tail) | [1.496](cell:by_site/centre=bond/n=4/tail) | [1.500](cell:by_site/centre=bond/n=5/tail) |

The article calls the decay super-exponential, and the last two rows say which law it is. Far from the centre $u_n$ is
small against $u_{n-1}$, so $\mu u_n \approx w_{n-1}$ and $|u_n| \approx |u_{n-1}|^{3/2}/\mu$. At $\mu = 1$ each
logarithm is 3/2 times the one before, to one part in a thousand as soon as the profile is invisible in a plot. */
void report_profile(Report& report, Table& by_site, Centre centre, const char* name) {
  Table& profile = report.table(std::string("profile_") + name);
  for (long n = centre == Centre::site ? -strains : 1 - strains; n <= strains; ++n)
    profile.add({{"n", "site", n, "site"},
                 {"u", "stationary DpS breather, mu = 1",
                  known(centre, [n](const auto& b) { return b.at(n); }), "", precisions},
                 {"quasi_continuum", "quasi-continuum profile", approximation(centre, n)}});

  // The approximation over u_n, and the power of the tail
  for (const long n : {1L, 2L, 3L, 4L, 5L}) {
    const auto ratio = [n](const auto& b) { return approximation(b.centre, n) / b.at(n); };
    const auto power = [n](const auto& b) {
      using std::abs, std::log;
      return log(abs(b.at(n + 1))) / log(abs(b.at(n)));
    };
    by_site.add({{"centre", "site or bond", name},
                 {"n", "site", n, "site"},
                 {"approximation", "quasi-continuum profile over u_n", known(centre, ratio), "",
                  precisions},
                 {"tail", "ln|u_(n+1)| over ln|u_n|", known(centre, power), "", precisions}});
  }
}

/**
## How many sites it takes (figure x03 d)

Each strain more makes the norm $N = \sum u_n^2$ more accurate, and its error falls double-exponentially, as the tail
does. With five strains in each half it is already a thousand times smaller than the difference of the two norms,
which is the most delicate number here, and beyond six it is below the machine epsilon of double precision. So 12 are
more than enough, and only rounding limits the numbers. */
void report_lengths(Report& report) {
  const auto error = [&](Centre centre, Index count) {
    const Quadruple all = breather<Quadruple>(centre).norm();
    return std::abs(double(breather<Quadruple>(centre, 1, count).norm() / all - 1));
  };
  Table& table = report.table("lengths");
  for (Index count = 2; count <= (report.quick ? 5 : 7); ++count)
    table.add({{"strains", "of the right half", count},
               {"site", "relative error of the norm, around a site", error(Centre::site, count)},
               {"bond", "relative error of the norm, around a bond", error(Centre::bond, count)}});
}

/**
## The approximation solves its equation

With $w_n = (-1)^{n+1}g$ the equation of the strains contains $g(x\pm1)$. Three terms of their Taylor series turn it
into Eq. (17), $F'' = -4F + F|F|^{-1/3}$. Its last term has an infinite slope at $F = 0$, which lets a solution reach
zero and stay there. Multiplied by $F'$ and integrated with $F = F' = 0$ at the edge it becomes
$F'^2 = \frac65F^{5/3} - 4F^2$. So $F$ is largest at $F^{1/3} = \frac3{10}$, and the half-width of the support is the
integral of $dF/|F'|$ from zero to there; with $F = z^3$
it is Euler's beta integral,
$$\int_0^{3/10}\frac{3\,dz}{\sqrt{z(\frac65-4z)}} = \frac32\,B(\tfrac12,\tfrac12) = \frac{3\pi}2.$$
This [4.712](statement:dps.qc_support) is algebra. As a test that $g$ is the solution we let GSL integrate Eq. (17)
from $F(0) = (\frac3{10})^3$, $F'(0) = 0$. Up to 95 per cent of the half-width it stays within $10^{-11}$ of $g$,
relative to the height; beyond, at the distance $y$ from the edge, an error grows like $y^{-4}$. From a start that is
1 per cent higher it departs by [0.12](cell:support/control). */
Estimate distance_from_solution(double factor) {
  const auto largest_difference = [&](double tolerance) {
    const auto equation = [](double, const double* x, double* rate) {
      rate[0] = x[1];
      rate[1] = -4 * x[0] + std::pow(std::abs(x[0]), 1 / alpha);
    };
    Reference method(equation, 2, {tolerance * height, tolerance, gsl_odeiv2_step_rk8pd});
    std::vector<double> F{factor * height, 0};
    double x = 0, most = 0;
    for (int k = 1; k <= 95; ++k) {
      method.advance(x, k * edge / 100, F);
      most = std::max(most, std::abs(F[0] / factor - g(x)) / height);
    }
    return most;
  };
  return compare(largest_difference(1e-11), largest_difference(1e-13));
}

void report_support(Report& report) {
  report.table("support").add(
      Row{{"half_width", "of the quasi-continuum profile",
           compare(m / 4 * std::beta(0.5, 0.5), double(m / 4 * std::beta(0.5L, 0.5L))), "",
           "difference of double and extended precision"},
          {"distance", "of g from the solution of Eq. (17) with its height, over it",
           distance_from_solution(1), "", "difference of two tolerances, relative to the height"},
          {"control", "the same from the solution that is one per cent higher, over that height",
           distance_from_solution(1.01), "", "difference of two tolerances"}});
}

/**
## Two norms that are almost equal, and the scaling with the frequency

The norm around a site is [0.005360](cell:breathers/centre=site/norm); that around a bond differs from it by the
fraction [-1.331e-6](cell:norms/gap). Why the two are so nearly equal, and why the one around a bond is the smaller,
we do not know. In the limit of small amplitude the energy of the chain's breather is $2\epsilon^2N$, so that at equal
frequency the energies of the two differ by the same fraction. What a step from site to site costs a moving breather
is another question, since it keeps its action and not its frequency (`sec32_barrier`).

If $u$ solves the equation at $\mu = 1$, $\mu^2u$ solves it at $\mu$, since $(\mu^2u)^{3/2} = \mu\cdot\mu^2u^{3/2}$:
the amplitude grows like $\mu^2$ at unchanged width. To test the method we solve at $\mu = 1.25$ from the same start,
not scaled, and compare site by site: the power is two to all digits (`exponent` of the table `breathers`). */
template <class T>
double exponent(const Breather<T>& one) {
  using std::abs, std::log;
  const Breather<T> other = breather<T>(one.centre, T(other_mu));
  const double expected = 1 / (alpha - 1);  // two for spheres
  double farthest = expected;
  for (long n = 0; n < strains && abs(one.at(n)) > T(1e-6); ++n) {
    const double power = double(T(log(abs(other.at(n) / one.at(n))) / log(T(other_mu))));
    if (std::abs(power - expected) > std::abs(farthest - expected)) farthest = power;
  }
  return farthest;
}

/// The largest difference from the quasi-continuum profile, over the largest displacement.
template <class T>
double difference(const Breather<T>& b) {
  double most = 0;
  for (long n = 0; n <= strains; ++n)
    most = std::max(most, std::abs(double(b.at(n)) - approximation(b.centre, n)));
  return most / double(b.u.cwiseAbs().maxCoeff());
}

void report_breathers(Table& table, Centre centre, const char* name) {
  table.add({{"centre", "site or bond", name},
             {"difference", "from the quasi-continuum profile, over the amplitude",
              known(centre, [](const auto& b) { return difference(b); }), "", precisions},
             {"norm", "sum of u_n^2", known(centre, [](const auto& b) { return b.norm(); }), "",
              precisions},
             {"exponent", "of the amplitude in mu, at the site where it is farthest from two",
              known(centre, [](const auto& b) { return exponent(b); }), "", precisions}});
}

/// The gap is six digits smaller than the norms, so extended precision is compared with quadruple.
template <class T>
double gap() {
  const T site = breather<T>(Centre::site).norm(), bond = breather<T>(Centre::bond).norm();
  return double(T((bond - site) / site));
}

void reproduce(Report& report) {
  report.output.note("tolerance", "last corrections of the strains below 1e4 machine epsilons");
  Table &breathers = report.table("breathers"), &by_site = report.table("by_site");
  for (const Centre centre : both_centres) {
    const char* name = centre == Centre::site ? "site" : "bond";
    check(centre);
    report_profile(report, by_site, centre, name);
    report_breathers(breathers, centre, name);
  }
  report_lengths(report);
  report_support(report);
  report.table("norms").add(Row{{"gap", "norm around the bond minus that around the site, over it",
                                 compare(gap<long double>(), gap<Quadruple>()), "",
                                 "difference of extended and quadruple precision"}});
}

/**
## Statement by statement

<!-- statements -->
| statement | printed | here | verdict |
|---|---|---|---|
| `dps.scaling`: breather amplitude is proportional to mu^2 at unchanged width | 2 | 2.000 | reproduced |
| `dps.qc_support`: half-width of the compact quasi-continuum profile g(x) = (3/10)^3 cos^6(x/3) | 3 pi/2 | 4.712 | reproduced |
| `dps.qc_solution`: g with the amplitude (3/10)^3 solves Eq. (17) |  | support.distance: 1.8e-12 < 1e-06 | holds |
| `dps.qc_site`: site-centred stationary DpS breather agrees with its quasi-continuum profile | excellent | 0.05745 share of the amplitude | quantified |
| `dps.qc_bond`: bond-centred stationary DpS breather agrees with its quasi-continuum profile | excellent | 0.06143 share of the amplitude | quantified |
<!-- /statements -->

## Try it

`sec32_dps_profiles profile` prints one profile beside its approximation, for any $\mu$ and any exponent of the
contacts (commands/one_profile.hpp).

**To change it.** `alpha` is the exponent of the contacts: approximation, equations and library follow it, and the tail
gets the power `alpha`. `strains` is the length of the chain. The last
strain must be a normal number: with `alpha = 2` take `strains = 9`, with 3/2 at most 14.

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
