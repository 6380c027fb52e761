/**
# 3.2 Static breathers of the DpS equation

How do the two static breathers look in the limit of small amplitude, and how good is the article's approximation?
Section 3.2 of James, Kevrekidis and Cuevas (Physica D 251, 2013) has two of the form $v_n = u_n e^{i\mu t}$ with
neighbours of opposite sign: one around a site, $u_{-n} = u_n$, and one around a bond, $u_{1-n} = -u_n$. Newton's method
finds both on a chain with a dozen strains in each half; beyond its few large sites a breather falls so fast that each
modulus is the power 3/2 of the one before. The quasi-continuum approximation is good where the breather is large, and
wrong by more than half at its edge. The surprise is that the norms of the two differ by only about one part in a
million.

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
#include <numbers>
#include <string>
#include <vector>

#include "commands/one_profile.hpp"
#include "lattice/algebra/dense.hpp"
#include "lattice/gsl/reference.hpp"
#include "lattice/model/sites.hpp"
#include "lattice/numerics/estimate.hpp"
#include "lattice/quadruple/extended.hpp"
#include "report/program.hpp"

using Eigen::Index;
using namespace lattice;

/**
## The equation and its approximation

In the rescaled time of Eq. (11) the DpS equation is $i\dot v_n = w_n - w_{n-1}$, where $w_n = d_n|d_n|^{1/2}$ is the
force of the strain $d_n = v_{n+1}-v_n$. With $v_n = u_n e^{i\mu t}$ and real $u_n$ it becomes Eq. (14), $\mu u_n =
w_{n-1} - w_n$. The ends are free: there the outer contact is missing. A breather of the chain with frequency
$\omega_b = 1 + \epsilon^{1/2}/(2\tau_0)$ is then nearly $y_n = 2\epsilon\,u_n\cos\omega_b t$ with $\mu = 1$, Eq. (20).
The difference of the equations at neighbouring sites contains strains only, and by symmetry those of one half suffice:
$$w_{n+1} - 2w_n + w_{n-1} + \mu d_n = 0,\qquad n \ge 0,\qquad
  w_{-1} = -w_0 \text{ (site)},\quad w_{-1} = w_1 \text{ (bond)}.$$

The approximation assumes that the forces alternate, $w_n = (-1)^{n+1}g$ with a smooth envelope $g$ around the centre.
At $\mu = 1$ the equation then contains $g(x\pm1)$, and three terms of their Taylor series turn it into Eq. (17), $g'' =
-4g + g|g|^{-1/3}$. Its last term has an infinite slope at $g = 0$, which lets a solution reach zero and stay there.
Multiplied by $g'$ and integrated with $g = g' = 0$ at the edge it is $g'^2 = \frac65g^{5/3} - 4g^2$, and
$$g(x) = (\tfrac3{10})^3\cos^6\tfrac x3 \text{ for } |x| \le \tfrac{3\pi}2,\qquad
  u_n = (-1)^n[g(n+\tfrac12)+g(n-\tfrac12)] \text{ (site, Eq. (19))},\quad
  u_n = (-1)^n[g(n)+g(n-1)] \text{ (bond, Eq. (18))}.$$
It keeps $g''$ and drops the fourth derivative, although the half-width, [4.712](statement:dps.qc_support), is less than
five sites: there is no small parameter. And compact support must fail at its edge, where the true tail falls faster
than exponentially but not to zero. For other exponents the power 6 becomes $2\alpha/(\alpha-1)$. */
constexpr double alpha = 1.5;      // exponent of the contacts, 3/2 for spheres
constexpr Index strains = 12;      // of the right half: 25 sites around a site, 24 around a bond
constexpr double other_mu = 1.25;  // for the scaling; the same start must lead there
constexpr double power = 2 * alpha / (alpha - 1), edge = std::numbers::pi * power / 4;  // 6, 3 pi/2
const double height = std::pow(power / (4 * (power - 1)), power / 2);                   // (3/10)^3

double g(double x) {
  return std::abs(x) < edge ? height * std::pow(std::cos(2 * x / power), power) : 0;
}

double approximation(Centre centre, long n) {
  const double x = double(n) + (centre == Centre::bond ? 0 : 0.5);
  const double u = g(x) + g(x - 1);
  return n % 2 == 0 || u == 0 ? u : -u;
}

/**
## Newton's method

The symmetry keeps the breather from sliding along the chain, a direction in which the equations are nearly indifferent.
The strains keep the tail accurate: there $d_n \approx -w_{n-1}/\mu$, without cancellation. A relative error of one
strain is multiplied by 3/2 from site to site outwards, while an absolute one would exceed the tail. So the start has
the strains inside the support of the approximation only, four for spheres, and each step of Newton's method adds one
more. The arithmetic has 34 digits. */
using Strains = Vector<Quadruple>;

struct Breather {
  Centre centre;
  Strains u;  // u_0, u_1, ... of the right half

  Quadruple at(long n) const {
    if (n >= 0) return u(n);
    return centre == Centre::site ? u(-n) : Quadruple(-u(1 - n));
  }
  /// N = sum u_n^2.
  Quadruple norm() const {
    const Quadruple right = u.tail(u.size() - 1).squaredNorm();
    return centre == Centre::site ? Quadruple(u(0) * u(0) + 2 * right) : Quadruple(2 * right);
  }
};

/// |x|^(alpha-1).
Quadruple root(const Quadruple& x) {
  return secant_stiffness(x, alpha);
}

Breather breather(Centre centre, Index count = strains, Quadruple mu = 1) {
  // The second differences as a matrix, with the symmetry in its first row and a free end in its last
  const Matrix<Quadruple> identity = Matrix<Quadruple>::Identity(count, count);
  Matrix<Quadruple> differences = -2 * identity;
  differences.diagonal(1).setOnes();
  differences.diagonal(-1).setOnes();
  if (centre == Centre::site) differences(0, 0) -= 1;
  if (centre == Centre::bond) differences(0, 1) += 1;

  // The start, and Newton's method for differences * w + mu * d = 0
  Strains d = Strains::Zero(count);
  const Index inside = std::min(count, Index(std::floor(edge)));
  for (Index n = 0; n < inside; ++n) d(n) = approximation(centre, n + 1) - approximation(centre, n);
  Quadruple correction = 1;  // relative to each strain
  for (int k = 0; correction > 1e-28; ++k) {
    if (k == 30) throw Failure("Newton's method does not converge");
    const Strains stiffness = d.unaryExpr(&root);
    const Matrix<Quadruple> derivative =
        alpha * differences * stiffness.asDiagonal() + mu * identity;
    const Strains step =
        solve_square<Quadruple>(derivative, differences * d.cwiseProduct(stiffness) + mu * d);
    d -= step;
    correction = step.cwiseQuotient(d).cwiseAbs().maxCoeff();
  }

  // Eq. (14) gives the displacements
  const Strains w = d.cwiseProduct(d.unaryExpr(&root));
  Strains u(count + 1);
  u(0) = (centre == Centre::site ? -2 * w(0) : w(1) - w(0)) / mu;
  for (Index n = 1; n < count; ++n) u(n) = (w(n - 1) - w(n)) / mu;
  u(count) = w(count - 1) / mu;
  return {centre, u};
}

/**
The displacements of the whole chain, with free ends, must satisfy Eq. (14) at every site, to 25 digits of $u_n$. The
error of what is read from a breather is its difference on a chain that is longer by one strain in each half. */
void check(const Breather& b, long first, long last) {
  Quadruple left = 0;
  for (long n = first; n <= last; ++n) {
    const Quadruple d = n < last ? Quadruple(b.at(n + 1) - b.at(n)) : Quadruple(0);
    const Quadruple right = d * root(d);
    if (abs(left - right - b.at(n)) > 1e-25 * abs(b.at(n)))
      throw Failure("Eq. (14) does not hold at site " + std::to_string(n));
    left = right;
  }
}

TwoRuns<Breather> two_lengths(Centre centre) {
  return {breather(centre), breather(centre, strains + 1)};
}
const char* const longer = "difference from a chain with one strain less in each half";

/**
## Both breathers and their approximation (figure x03 a to c)

The article calls the agreement excellent and gives no number. Ours is the largest difference over the sites relative to
the largest displacement: [0.0575](cell:breathers/centre=site/difference) for the breather around a site and
[0.0614](cell:breathers/centre=bond/difference) around a bond. It occurs at $n = 2$ in both, where the approximation is
too wide. This measure is lenient: relative to $u_n$ itself the approximation is more than half too large at $n = 3$
(site) and $n = 4$ (bond), and much too small at $n = 5$, where its support ends:

| | $n = 1$ | 2 | 3 | 4 | 5 |
|---|---|---|---|---|---|
| approximation over $u_n$, site | [1.045](cell:by_site/centre=site/n=1/approximation) | [1.243](cell:by_site/centre=site/n=2/approximation) | [1.567](cell:by_site/centre=site/n=3/approximation) | [1.377](cell:by_site/centre=site/n=4/approximation) | [0.0054](cell:by_site/centre=site/n=5/approximation) |
| approximation over $u_n$, bond | [0.9998](cell:by_site/centre=bond/n=1/approximation) | [1.125](cell:by_site/centre=bond/n=2/approximation) | [1.398](cell:by_site/centre=bond/n=3/approximation) | [1.650](cell:by_site/centre=bond/n=4/approximation) | [0.533](cell:by_site/centre=bond/n=5/approximation) |
| $\ln\lvert u_{n+1}\rvert/\ln\lvert u_n\rvert$, site | [1.327](cell:by_site/centre=site/n=1/tail) | [1.446](cell:by_site/centre=site/n=2/tail) | [1.489](cell:by_site/centre=site/n=3/tail) | [1.499](cell:by_site/centre=site/n=4/tail) | [1.500](cell:by_site/centre=site/n=5/tail) |
| $\ln\lvert u_{n+1}\rvert/\ln\lvert u_n\rvert$, bond | [1.231](cell:by_site/centre=bond/n=1/tail) | [1.399](cell:by_site/centre=bond/n=2/tail) | [1.474](cell:by_site/centre=bond/n=3/tail) | [1.496](cell:by_site/centre=bond/n=4/tail) | [1.500](cell:by_site/centre=bond/n=5/tail) |

The article calls the decay super-exponential, and the last two rows say which law it is. Far from the centre $u_n$ is
small against $u_{n-1}$, so $\mu u_n \approx w_{n-1}$ and $|u_n| \approx |u_{n-1}|^{3/2}/\mu$. At $\mu = 1$ each
logarithm is 3/2 times the one before, to one part in a thousand from $n = 4$ (site) and 5 (bond) on. */
void report_profile(Report& report, Table& by_site, const TwoRuns<Breather>& runs,
                    const char* name) {
  const Centre centre = runs.fine.centre;
  Table& profile = report.table(std::string("profile_") + name);
  const long first = centre == Centre::site ? -strains : 1 - strains;
  check(runs.coarse, first, strains);
  for (long n = first; n <= strains; ++n)
    profile.add({{"n", "site", n, "site"},
                 {"u", "stationary DpS breather, mu = 1",
                  runs.of([n](const Breather& b) { return double(b.at(n)); }), "", longer},
                 {"quasi_continuum", "quasi-continuum profile", approximation(centre, n)}});

  // The approximation over u_n, and the power of the tail
  for (const long n : {1L, 2L, 3L, 4L, 5L}) {
    const auto ratio = [n](const Breather& b) {
      return approximation(b.centre, n) / double(b.at(n));
    };
    const auto tail = [n](const Breather& b) {
      return double(log(abs(b.at(n + 1))) / log(abs(b.at(n))));
    };
    by_site.add({{"centre", "site or bond", name},
                 {"n", "site", n, "site"},
                 {"approximation", "quasi-continuum profile over u_n", runs.of(ratio), "", longer},
                 {"tail", "ln|u_(n+1)| over ln|u_n|", runs.of(tail), "", longer}});
  }
}

/**
## How many sites it takes (figure x03 d)

Each further strain makes the norm $N = \sum u_n^2$ more accurate, and its error falls double-exponentially, as the tail
does. With five strains in each half it is already a thousand times smaller than the difference of the two norms,
which is the most delicate number here, and from six on it is below the machine epsilon of double precision. */
void report_lengths(Report& report) {
  const auto error = [](Centre centre, Index count) {
    // In seven digits: the last ones of 34 hang on the compiler
    return double(
        float(std::abs(double(breather(centre, count).norm() / breather(centre).norm() - 1))));
  };
  Table& table = report.table("lengths");
  for (Index count = 2; count <= (report.quick ? 5 : 6); ++count)
    table.add({{"strains", "of the right half", count},
               {"site", "relative error of the norm, around a site", error(Centre::site, count)},
               {"bond", "relative error of the norm, around a bond", error(Centre::bond, count)}});
}

/**
## The approximation solves its equation

As a test that $g$ is the solution we let GSL integrate Eq. (17) from $g(0) = (\frac3{10})^3$, $g'(0) = 0$. Up to 95 per
cent of the half-width it stays within $10^{-11}$ of the formula, relative to the height; nearer to the edge an error
grows like the inverse fourth power of the distance from it. A solution that starts 1 per cent higher, divided by its
height, differs from $g$ by [0.12](cell:support/control). */
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
           compare(power / 4 * std::beta(0.5, 0.5), edge), "",
           "difference of two formulas, one with Euler's beta integral"},
          {"distance", "of g from the solution of Eq. (17) with its height, over it",
           distance_from_solution(1), "", "difference of two tolerances, relative to the height"},
          {"control", "the same from the solution that is one per cent higher, over that height",
           distance_from_solution(1.01), "", "difference of two tolerances"}});
}

/**
## Two norms that are almost equal, and the scaling with the frequency

The norm around a site is [0.005360](cell:breathers/centre=site/norm); the one around a bond differs from it by the
fraction [-1.331e-6](cell:norms/gap), bond minus site. Why the two are so nearly equal, and why the one around a bond is
the smaller, we do not know. In the limit of small amplitude the energy of the chain's breather is $2\epsilon^2N$, so
that at equal frequency the energies should differ by the same fraction; at the article's $\omega_b = 1.01$ the
difference is only a fifth of that (`sec32_barrier`).

If $u$ solves the equation at $\mu = 1$, $\mu^2u$ solves it at $\mu$, since $(\mu^2u)^{3/2} = \mu\cdot\mu^2u^{3/2}$:
the amplitude grows like $\mu^2$ at unchanged width. To test the method we solve at $\mu = 1.25$ from the same start,
not scaled, and compare site by site: the power is two to all digits (`exponent` of the table `breathers`). */
double exponent(const Breather& one) {
  const Breather other = breather(one.centre, one.u.size() - 1, other_mu);
  const double expected = 1 / (alpha - 1);  // two for spheres
  double farthest = expected;
  for (long n = one.centre == Centre::site ? 0 : 1; n <= strains; ++n) {
    const double found = double(log(abs(other.at(n) / one.at(n)))) / std::log(other_mu);
    if (std::abs(found - expected) > std::abs(farthest - expected)) farthest = found;
  }
  return farthest;
}

/// The largest difference from the quasi-continuum profile, over the largest displacement.
double difference(const Breather& b) {
  double most = 0;
  for (long n = 0; n <= strains; ++n)
    most = std::max(most, std::abs(double(b.at(n)) - approximation(b.centre, n)));
  return most / double(b.u.cwiseAbs().maxCoeff());
}

void report_breathers(Table& table, const TwoRuns<Breather>& runs, const char* name) {
  table.add({{"centre", "site or bond", name},
             {"difference", "from the quasi-continuum profile, over the amplitude",
              runs.of(difference), "", longer},
             {"norm", "sum of u_n^2", runs.of([](const Breather& b) { return double(b.norm()); }),
              "", longer},
             {"exponent", "of the amplitude in mu, at the site where it is farthest from two",
              runs.of(exponent), "", longer}});
}

void reproduce(Report& report) {
  report.output.note("tolerance", "last corrections of the strains below 1e-28");
  Table &breathers = report.table("breathers"), &by_site = report.table("by_site");
  const auto site = two_lengths(Centre::site), bond = two_lengths(Centre::bond);
  report_profile(report, by_site, site, "site");
  report_profile(report, by_site, bond, "bond");
  report_breathers(breathers, site, "site");
  report_breathers(breathers, bond, "bond");
  report_lengths(report);
  report_support(report);
  const auto gap = [](const Breather& s, const Breather& b) {
    return double((b.norm() - s.norm()) / s.norm());
  };
  report.table("norms").add(
      Row{{"gap", "norm around the bond minus that around the site, over it",
           compare(gap(site.coarse, bond.coarse), gap(site.fine, bond.fine)), "", longer}});
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

**To change it.** `alpha` is the exponent of the contacts: approximation and equations follow it, and the tail gets the
power `alpha`. `strains` is the length of the chain, whose last displacement must be a normal number of double
precision: with `alpha = 2` take `strains = 8`.

1. *Easy.* How good is $y_n = 2\epsilon u_n\cos\omega_bt$ for a small breather of the chain?
   `build/bin/sec32_newton_breathers breather --omega 1.001` gives `amplitude` = 9.63900e-7. Hint: Eq. (20) gives
   $\epsilon$, and `profile` gives $u_0$.
2. *Harder.* Are the two energies as close for contacts of another exponent? `build/bin/sec32_barrier barrier --omega
   1.0001 --contact power --alpha 2` gives `equal_frequency` = 6.16378e-12. Hint: divide by the energy that `breather`
   prints with the same options, and compare with the gap of the norms for spheres. */
int main(int argc, char** argv) {
  return run({"sec32_dps_profiles", "3.2", "Static breathers of the DpS equation (section 3.2)",
              reproduce, commands<OneProfile>()},
             argc, argv);
}
