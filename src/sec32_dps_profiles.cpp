/**
# 3.2 Static breathers of the DpS equation

How do the two static breathers look in the limit of small amplitude, and how good is the article's approximation?
Section 3.2 of James, Kevrekidis and Cuevas (Physica D 251, 2013) describes two, $v_n = u_n e^{i\mu t}$ with neighbours
of opposite sign: one around a site, $u_{-n} = u_n$, and one around a bond, $u_{1-n} = -u_n$. Newton's method finds both
on a chain with 12 strains in each half. Far from the centre each $|u_n|$ (at $\mu = 1$) tends to the 3/2 power of its
inner neighbour's. The quasi-continuum approximation is good where the breather is large, but half too large at
the third or fourth site. The surprise is that the norms of the two differ by only about one part in a million.

![Both breathers, their quasi-continuum approximation and tails, and the error of a short chain.](fig:x03)

<!-- head -->
`build/bin/sec32_dps_profiles` computes this chapter in less than 1 s on two cores and writes 7 tables to
`build/data/sec32_dps_profiles`. Its figures: `make x03`. With your parameters: `profile`, one static DpS breather and
its quasi-continuum approximation.
<!-- /head --> */

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "commands/one_profile.hpp"
#include "lattice/model/quasi_continuum.hpp"
#include "lattice/model/sites.hpp"
#include "lattice/numerics/estimate.hpp"
#include "lattice/quadruple/quadruple.hpp"
#include "lattice/standing/stationary.hpp"
#include "report/program.hpp"

using namespace lattice;
using namespace report;

/**
## The equation and its approximation

With $A_n(\tau) = v_n(\tau/2\tau_0)$ the DpS equation, Eq. (11), is $i\dot v_n = w_n - w_{n-1}$, where $w_n =
d_n|d_n|^{1/2}$ is the force of the strain $d_n = v_{n+1}-v_n$. With $v_n = u_n e^{i\mu t}$ and real $u_n$ it becomes Eq.
(14), $\mu u_n = w_{n-1} - w_n$. The ends are free: there the outer contact is missing. A breather of the chain with
frequency $\omega_b = 1 + \epsilon^{1/2}/(2\tau_0)$ is then nearly $y_n = 2\epsilon\,u_n\cos\omega_b t$ with $\mu = 1$,
Eq. (20).
The difference of the equations at neighbouring sites contains strains only, and by symmetry those of one half suffice:
$$w_{n+1} - 2w_n + w_{n-1} + \mu d_n = 0,\qquad n \ge 0,\qquad
  w_{-1} = -w_0 \text{ (site)},\quad w_{-1} = w_1 \text{ (bond)}.$$

The approximation assumes that the forces alternate, $w_n = (-1)^{n+1}g(x)$ with a smooth envelope $g$, at $x =
n+\frac12$ around a site and $x = n$ around a bond. At $\mu = 1$ the equation then contains $g(x\pm1)$, and three terms
of their Taylor series turn it into Eq. (17), $g'' = -4g + g|g|^{-1/3}$. Its last term has an infinite slope at $g = 0$,
so a solution can reach zero and stay there. Multiplied by $g'$ and integrated with $g = g' = 0$ at the edge it is
$g'^2 = \frac65g^{5/3} - 4g^2$, and
$$g(x) = (\tfrac3{10})^3\cos^6\tfrac x3 \text{ for } |x| \le \tfrac{3\pi}2,\qquad
  u_n = (-1)^n[g(n+\tfrac12)+g(n-\tfrac12)] \text{ (site, Eq. (19))},\quad
  u_n = (-1)^n[g(n)+g(n-1)] \text{ (bond, Eq. (18))}.$$
It keeps $g''$ and drops the fourth derivative, although the half-width, [4.712](statement:dps.qc_support), is less than
five sites: there is no small parameter. And compact support must fail at its edge, where the true tail falls faster
than exponentially but not to zero. For other exponents the power 6 of the cosine becomes $m = 2\alpha/(\alpha-1)$. */
constexpr double alpha = 1.5;        // exponent of the contacts, 3/2 for spheres
constexpr std::size_t strains = 12;  // of each half: 25 sites around a site, 24 around a bond
constexpr double other_mu = 1.25;    // for the scaling; the same start must lead there
constexpr double m = 2 * alpha / (alpha - 1);              // 6
constexpr double half_width = std::numbers::pi * m / 4;    // of g, 3 pi/2
const double height = std::pow(m / (4 * (m - 1)), m / 2);  // of g, (3/10)^3

double g(double x) {
  return std::abs(x) < half_width ? height * std::pow(std::cos(2 * x / m), m) : 0;
}

double approximation(Centre centre, long n) {
  return staggered<double>(centre, n, g);
}

/**
## Newton's method

`stationary` (lattice/standing/stationary.cpp) solves the equations of the strains. The symmetry keeps the breather from
sliding along the chain, and the strains keep the tail accurate: there $d_n \approx -w_{n-1}/\mu$, without cancellation.
A step corrects $d_n$ to $d_n(1+\eta_n)$. The first chain is as short as the support of the approximation, four strains
of each half for spheres; then it grows by one strain at a time, which this law of the tail predicts, and is solved
again. Small relative errors grow only by 3/2 a site, whereas the approximation has no tail at all.

The arithmetic has 34 digits. Equation (14) times $u_n$ and summed is $\sum|d_n|^{5/2} = \mu N$ with the norm $N = \sum
u_n^2$, which every breather must fulfil to 30 digits (tests/lattice/standing has the equation itself). A chain
longer by one strain in each half gives the same within the rounding of a double, the error of what is read from it. */
using Breather = Stationary<Quadruple>;

Breather breather(Centre centre, std::size_t count = strains) {
  const std::size_t sites = 2 * count + (centre == Centre::site);
  const Breather b = stationary<Quadruple>(centre, 1, sites, alpha);
  if (!(abs(b.contact_sum() / b.norm() - 1) < 1e-30)) throw Failure("Eq. (14) is not solved");
  return b;
}

Quadruple u(const Breather& b, long n) {
  return b.u[site_index(n, b.u.size())];
}

/**
## Both breathers and their approximation (figure x03 a to c)

The article calls the agreement excellent and gives no number. Ours is the largest difference over the sites relative to
the largest displacement: [0.0575](cell:breathers/centre=site/difference) for the breather around a site and
[0.0614](cell:breathers/centre=bond/difference) around a bond. It occurs at $n = 2$ in both, where the approximation is
too wide. This measure is lenient: relative to $u_n$ itself the approximation is more than half too large at $n = 3$
(site) and $n = 4$ (bond), and too small at $n = 5$, where its support ends.

| | $n = 1$ | 2 | 3 | 4 | 5 |
|---|---|---|---|---|---|
| approximation over $u_n$, site | [1.045](cell:by_site/centre=site/n=1/ratio) | [1.243](cell:by_site/centre=site/n=2/ratio) | [1.567](cell:by_site/centre=site/n=3/ratio) | [1.377](cell:by_site/centre=site/n=4/ratio) | [0.0054](cell:by_site/centre=site/n=5/ratio) |
| approximation over $u_n$, bond | [0.9998](cell:by_site/centre=bond/n=1/ratio) | [1.125](cell:by_site/centre=bond/n=2/ratio) | [1.398](cell:by_site/centre=bond/n=3/ratio) | [1.650](cell:by_site/centre=bond/n=4/ratio) | [0.533](cell:by_site/centre=bond/n=5/ratio) |
| $\ln\lvert u_{n+1}\rvert/\ln\lvert u_n\rvert$, site | [1.327](cell:by_site/centre=site/n=1/tail) | [1.446](cell:by_site/centre=site/n=2/tail) | [1.489](cell:by_site/centre=site/n=3/tail) | [1.499](cell:by_site/centre=site/n=4/tail) | [1.500](cell:by_site/centre=site/n=5/tail) |
| $\ln\lvert u_{n+1}\rvert/\ln\lvert u_n\rvert$, bond | [1.231](cell:by_site/centre=bond/n=1/tail) | [1.399](cell:by_site/centre=bond/n=2/tail) | [1.474](cell:by_site/centre=bond/n=3/tail) | [1.496](cell:by_site/centre=bond/n=4/tail) | [1.500](cell:by_site/centre=bond/n=5/tail) |

The article calls the decay super-exponential, and the last two rows say which law it is. Far from the centre $u_n$ is
small against $u_{n-1}$, so $\mu u_n \approx w_{n-1}$ and $|u_n| \approx |u_{n-1}|^{3/2}/\mu$. At $\mu = 1$ each
logarithm is 3/2 times the one before, to one part in a thousand from $n = 4$ (site) and 5 (bond) on. */
/// The largest difference from the quasi-continuum profile, over the largest displacement.
double difference(const Breather& b) {
  double most = 0, amplitude = 0;
  for (std::size_t i = 0; i < b.u.size(); ++i) {
    const double u_n(b.u[i]), off = u_n - approximation(b.centre, site_number(i, b.u.size()));
    most = std::max(most, std::abs(off));
    amplitude = std::max(amplitude, std::abs(u_n));
  }
  return most / amplitude;
}

void report_profile(Report& report, Table& by_site, const TwoRuns<Breather>& runs) {
  const std::string name = name_of(runs.fine.centre);
  Table& profile = report.table("profile_" + name);
  const std::size_t sites = runs.coarse.u.size();
  for (std::size_t i = 0; i < sites; ++i) {
    const long n = site_number(i, sites);
    profile.add({{"n", n},
                 {"u", runs.of([n](const Breather& b) { return double(u(b, n)); })},
                 {"quasi_continuum", approximation(runs.coarse.centre, n)}});
  }

  for (const long n : {1L, 2L, 3L, 4L, 5L}) {
    const auto ratio = [n](const Breather& b) {
      return approximation(b.centre, n) / double(u(b, n));
    };
    const auto tail = [n](const Breather& b) {
      return double(log(abs(u(b, n + 1))) / log(abs(u(b, n))));
    };
    by_site.add({{"centre", name}, {"n", n}, {"ratio", runs.of(ratio)}, {"tail", runs.of(tail)}});
  }
}

/**
## How many sites it takes (figure x03 d)

Each further strain makes the norm more accurate, and its error falls double-exponentially, as the tail does. With five
strains in each half it is already a thousand times smaller than the difference of the two norms, which is the most
delicate number here, and from six on it is below the machine epsilon of double precision. */
void report_lengths(Report& report) {
  const auto error = [](Centre centre, std::size_t count) {
    const double off(breather(centre, count).norm() / breather(centre).norm() - 1);
    return double(float(std::abs(off)));  // the last of the 34 digits hang on the compiler
  };
  Table& table = report.table("lengths");
  for (std::size_t count = 2; count <= (report.quick ? 5 : 6); ++count)
    table.add({{"strains", count},
               {"site", error(Centre::site, count)},
               {"bond", error(Centre::bond, count)}});
}

/**
## The approximation solves its equation

Does $g$ solve Eq. (17), and where does it end? In the integrated equation $x = \int dg/|g'|$, from the height of $g$
down. With $g$ = height $(1-r^2)^m$ the integrand is finite; the rules of Gauss and Kronrod give $x$ at each $g$, and
their difference the error. At $g = 0$ this is the half-width, before it we compare with the formula. From 0.99 of
the height it gives a shifted $g$, [0.08](cell:support/control) of the height away from $0.99\,g$. */
Estimate position(double factor, double end) {
  const auto integrand = [&](long double r) {  // extended precision: at the start two terms cancel
    const long double a = alpha, f = factor * height * std::pow(1 - r * r, m);
    const long double squared = 2 * a / (a + 1) * std::pow(f, 1 + 1 / a) - 4 * f * f;
    return double(2 * r * m * f / (1 - r * r) / std::sqrt(squared));
  };
  double error = 0;
  const double x = boost::math::quadrature::gauss_kronrod<double, 31>::integrate(integrand, 0, end,
                                                                                 0, 0, &error);
  return {x, error};
}

Estimate departure(double factor) {
  double most = 0, error = 0;
  for (int k = 1; k < 20; ++k) {
    const double r = k / 20.0, shape = std::pow(1 - r * r, m);
    const Estimate x = position(factor, r);
    most = std::max(most, factor * std::abs(shape - g(x.value) / height));
    error = std::max(error, x.error);
  }
  return {most, error};
}

/**
## Two norms that are almost equal, and the scaling with the frequency

The norm around a site is [0.005360](cell:breathers/centre=site/norm); the one around a bond differs from it by the
fraction [-1.331e-6](cell:norms/gap), bond minus site. Why the two are so nearly equal, and why the one around a bond is
the smaller, we do not know. In the limit of small amplitude the energy of the chain's breather is $2\epsilon^2N$, so
that at equal frequency the energies should differ by the same fraction; at the article's $\omega_b = 1.01$ it is only
a fifth (`equal_frequency` over `energy_site` in `key_pairs` of `sec32_barrier`).

If $u$ solves the equation at $\mu = 1$, $\mu^2u$ solves it at $\mu$, since $(\mu^2u)^{3/2} = \mu\cdot\mu^2u^{3/2}$:
the amplitude grows like $\mu^2$ at unchanged width. As a test we solve at $\mu = 1.25$ from the first four strains at
$\mu = 1$, not scaled, and compare site by site: the exponent of $\mu$ is 2 to all digits. */
double amplitude_exponent(const Breather& one) {
  const std::vector<Quadruple> start(one.strain.begin(),
                                     one.strain.begin() + long(short_chain(alpha)));
  const Breather other =
      stationary_from<Quadruple>(one.centre, other_mu, start, one.u.size(), alpha);
  const double expected = 1 / (alpha - 1);  // two for spheres
  double farthest = expected;
  for (std::size_t i = 0; i < one.u.size(); ++i) {
    const double found = double(log(other.u[i] / one.u[i])) / std::log(other_mu);
    if (std::abs(found - expected) > std::abs(farthest - expected)) farthest = found;
  }
  return farthest;
}

double gap(const Breather& site, const Breather& bond) {
  return double((bond.norm() - site.norm()) / site.norm());
}

void reproduce(Report& report) {
  Table &breathers = report.table("breathers"), &by_site = report.table("by_site");
  const TwoRuns<Breather> site{breather(Centre::site), breather(Centre::site, strains + 1)},
      bond{breather(Centre::bond), breather(Centre::bond, strains + 1)};
  for (const TwoRuns<Breather>& runs : {site, bond}) {
    report_profile(report, by_site, runs);
    breathers.add({{"centre", name_of(runs.fine.centre)},
                   {"difference", runs.of(difference)},
                   {"norm", runs.of([](const Breather& b) { return double(b.norm()); })},
                   {"amplitude_exponent", runs.of(amplitude_exponent)}});
  }
  report_lengths(report);
  report.table("support").add(Row{
      {"half_width", position(1, 1)}, {"residual", departure(1)}, {"control", departure(0.99)}});
  report.table("norms").add(
      Row{{"gap", with_error(gap(site.coarse, bond.coarse), gap(site.fine, bond.fine))}});
}

/**
## Statement by statement

<!-- statements -->
| statement | printed | here | verdict |
|---|---|---|---|
| `dps.scaling`: breather amplitude is proportional to mu^2 at unchanged width | 2 | 2.000 | reproduced |
| `dps.qc_support`: half-width of the compact quasi-continuum profile g(x) = (3/10)^3 cos^6(x/3) | 3 pi/2 | 4.712 | reproduced |
| `dps.qc_solution`: g with the amplitude (3/10)^3 solves Eq. (17) |  | support.residual: 4.112e-13 < 1e-06 | holds |
| `dps.qc_site`: site-centred stationary DpS breather agrees with its quasi-continuum profile | excellent | 0.05745 share of the amplitude | quantified |
| `dps.qc_bond`: bond-centred stationary DpS breather agrees with its quasi-continuum profile | excellent | 0.06143 share of the amplitude | quantified |
<!-- /statements -->

## Try it

**To change it.** `alpha` is the exponent of the contacts: approximation and equations follow it, and the tail gets the
power `alpha`. `strains`, 7 or more, is the length of the chain, whose last displacement must be a normal number of
double precision: with `alpha = 2` take `strains = 8`.

1. *Easy.* How good is $y_n = 2\epsilon u_n\cos\omega_bt$ for a small breather of the chain?
   `build/bin/sec32_newton_breathers breather --omega 1.001` gives `amplitude` = 9.63900e-7. Hint: Eq. (20) gives
   $\epsilon$, and `profile` gives $u_0$.
2. *Harder.* Are the two energies as close for contacts of another exponent? `build/bin/sec32_barrier barrier --omega
   1.0001 --contact power --alpha 2` gives `equal_frequency` = 6.16378e-12. Hint: divide by the energy that `breather`
   prints with the same options, and compare with `gap` for spheres (bond minus site; here site minus bond). */
int main(int argc, char** argv) {
  return run({"sec32_dps_profiles", "3.2", "Static breathers of the DpS equation (section 3.2)",
              reproduce, commands<OneProfile>()},
             argc, argv);
}
