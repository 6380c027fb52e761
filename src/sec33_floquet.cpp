/**
# 3.3 Floquet multipliers of the breathers of the chain

Which of the two breathers of the chain is stable, and in which wells? We compute their *Floquet multipliers* $\lambda$,
the eigenvalues of the matrix $M$ by which one period multiplies a small disturbance: a multiplier outside the unit
circle makes it grow. Section 3.3 of James, Kevrekidis and Cuevas (Physica D 251, 2013) finds four multipliers so close
to $+1$ that the breathers are almost free to move. At $\omega_b = 1.1$, in the linear well, the site-centred breather
is weakly unstable and the bond-centred one stable; in wells of anharmonicity $s$ the latter loses its stability at
$s_0^b \approx 0.26$ and the former gains it at $s_0^s \approx 0.05$, where a pair of multipliers collides at $+1$
(figures 11 and 12).

![Arguments and moduli of the four multipliers near one, bond-centred.](fig:11)

We find the same but for the two values of $s_0$: both breathers change their stability at almost the same
anharmonicity, $s_0 =$ [0.1525](cell:exchange/site). Nearly everywhere one of the two is stable and the other one not:
in wells of $s \ge \frac14$ the site-centred one, but at the lowest frequencies; in the linear and soft wells they take
turns. In hard wells the instability does not stay weak; in most soft ones other multipliers leave the circle.

The multipliers are hard to compute because two are exactly $+1$ and share one eigenvector: an error $\eta$ of $M$ can
split such a pair by as much as $\sqrt\eta$. We compute a quantity that has no such pair.

<!-- head -->
`build/bin/sec33_floquet` computes this chapter in 4 s on two cores and writes 10 tables to `build/data/sec33_floquet`.
Its figures: `make fig11`, `make fig12`, `make fig13`, `make x47`, `make x64`. With your parameters: `multipliers`, all
Floquet multipliers of one breather; `exchange`, exchange of stability: the anharmonicity s at which the pinning
(translational) pair of multipliers passes +1.
<!-- /head -->

## Model

The chain is that of Eqs. (6) and (10), with free ends,
$$\ddot y_n + y_n + s\,y_n^3 = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2},$$
and the breathers are those of section 3.2, with the period $T_b = 2\pi/\omega_b$. They start from rest and are at rest
again after half a period. Let $F$ be the derivative of the flow over this half with respect to displacements and
velocities, with blocks $A, B, C, D$. The second half of the period is the first one run backwards. With
$R = \mathrm{diag}(1,-1)$, which reverses velocities, the whole period has the matrix $M = RF^{-1}RF$, and as $F$ is
symplectic, $M+M^{-1} = 2+4\,\mathrm{diag}(K, K^T)$ with $K = B^TC$. So one number describes each pair of multipliers
$\lambda, 1/\lambda$:
$$\kappa = \tfrac14\Bigl(\lambda+\frac1\lambda-2\Bigr),\qquad\text{an eigenvalue of } K.$$
A pair is on the unit circle if and only if $\kappa$ is real and $-1\le\kappa\le0$. If $\kappa > 0$, the pair is real
and $\ln\lambda = 2\,\mathrm{arsinh}\sqrt\kappa$.

The pair that is always $+1$ belongs to a shift in time. It changes the velocities along the accelerations $f$, and
after half a period, where all beads are at rest again, no position: $Bf = 0$. Hence $f^TK = 0$, and leaving out the
direction of $f$ removes this pair exactly. The *pinning pair* is the one next to $+1$, and its mode shifts the breather
along the chain; such modes are how breathers in other lattices were set in motion (Chen, Aubry and Tsironis 1996; Aubry
and Cretegny 1998). Its $\kappa$ is now a simple eigenvalue: an error $\eta$ of $F$ moves it by $O(\eta)$. */
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "commands/exchanges.hpp"
#include "commands/multipliers.hpp"
#include "lattice/algebra/dense.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "lattice/numerics/parallel.hpp"
#include "lattice/standing/spectrum.hpp"
#include "report/program.hpp"
#include "sec3/article_chains.hpp"
#include "sec3/breather_pairs.hpp"
#include "sec3/exchange.hpp"
#include "sec3/resolutions.hpp"

using namespace lattice;
using namespace report;

/**
## The experiment

We continue the breather from the linear well to $s = 1$ and to $s = -1$ and compute all pairs of multipliers for each
$s$. `find_breather` solves the conditions on a breather by Newton's method from the profile of Eqs. (18) to (20) in the
chain of `problem_at`, of 21 or 22 sites (the force on a bead beyond its ends would be below machine precision), and
`newton_from` starts from a neighbouring breather. `spectrum` (exchange.hpp) integrates $F$, ending a step at every
contact event, and takes the eigenvalues of $K$ perpendicular to $f$ (`floquet_pairs`), the smallest $|\kappa|$ first.
The error of $\kappa$ is the difference from a tolerance 16 times as large, plus the symplectic error of $F$. */
constexpr double omega_b = 1.1;   // figures 11 to 13
constexpr int steps_to_one = 20;  // values of s between 0 and 1

/// A breather at a place of the plane of omega_b and s, with its pairs.
struct BreatherAt {
  PlanePoint spot;
  Orbit<double> orbit{};
  Spectrum spectrum{};
};

/// The breathers of a centre for s from -1 to 1, with all pairs.
std::vector<BreatherAt> over_s(Centre centre, int steps) {
  std::vector<BreatherAt> family;
  for (int k = -steps; k <= steps; ++k) family.push_back({{omega_b, double(k) / steps}});
  const auto problem = [&](std::size_t k) { return problem_at(centre, family[k].spot); };
  // From the linear well, which is in the middle, to both ends
  const auto linear = std::size_t(steps);
  family[linear].orbit = find_breather(problem(linear));
  for (std::size_t k = linear + 1; k < family.size(); ++k)
    family[k].orbit = newton_from(problem(k), family[k - 1].orbit);
  for (std::size_t k = linear; k > 0; --k)
    family[k - 1].orbit = newton_from(problem(k - 1), family[k].orbit);
  parallel_for(family.size(), [&](std::size_t k) {
    family[k].spectrum = spectrum<double>(problem(k), family[k].orbit);
  });
  return family;
}

/**
## How accurate is it?

How accurate must $M$ be if the four multipliers are computed directly as its eigenvalues? They cannot be assigned to
pairs, but the symmetric function
$$\kappa \simeq \frac18\sum_{k=1}^4\frac{(\lambda_k-1)^2}{\lambda_k}$$
needs no assignment. For the stable, bond-centred breather in the linear well we loosen the tolerance of the flow and
compare with extended precision (`Wide`, a mantissa of 64 bits). */
void report_tolerances(Report& report) {
  const auto problem = problem_at(Centre::bond, {omega_b, 0});
  const Orbit<double> breather = find_breather(problem);
  const double kappa = spectrum<Wide>(problem, breather).kappa().value;
  Table& table = report.table("tolerances");
  for (int power = -4; power >= -13; --power) {
    EventTolerance<double> rule;
    rule.tolerance = std::pow(10.0, power);
    const double from_K =
        floquet_pairs(problem.chain, breather.start, breather.period(), rule).pinning();

    // The four eigenvalues of M next to +1: their error, and kappa from all of them
    auto all = eigenvalues_of(monodromy(problem.chain, breather.start, breather.period(), rule));
    std::stable_sort(all.begin(), all.end(),
                     [](auto a, auto b) { return std::norm(a - 1.0) < std::norm(b - 1.0); });
    double off = 0, sum = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const std::complex<double> z = all[k];
      off = std::max(off, std::min({std::abs(z - 1.0), std::abs(z - multiplier(kappa, 1)),
                                    std::abs(z - multiplier(kappa, -1))}));
      sum += ((z - 1.0) * (z - 1.0) / z).real();
    }
    table.add({{"tolerance", rule.tolerance},
               {"multipliers", off},
               {"symmetric", std::abs(sum / 8 - kappa)},
               {"kappa", std::abs(from_K - kappa)}});
  }
}

/**
![Errors of the multipliers next to $+1$ and of $\kappa$.](fig:x47)

On average, though in jumps, both ways to $\kappa$ gain 0.9 digits with each digit of the tolerance, the eigenvalues of
$M$ half as many. An error that splits a pair off the circle makes a stable breather seem unstable.

## The four multipliers against $s$ (figures 11 and 12)

Where does the pinning pair pass through $+1$? We follow $\kappa$ over $s$. A pair on the circle has modulus one, a pair
on the real axis argument zero. Near an exchange of stability the multipliers leave $+1$ like square roots, so we take
six more values of $s$ there. We find the exchange first: between two neighbours with opposite signs of $\kappa$ the
zero is improved by regula falsi and two last steps in extended precision (`exchange`). Its error is that of $\kappa$
over its slope in $s$, plus the last correction.

![Arguments and moduli of the four multipliers near one, site-centred.](fig:12) */
/// A breather over s, its exchange of stability, and by how much kappa falls with s there.
struct Family {
  Centre centre;
  std::vector<BreatherAt> breathers;
  Exchange exchange{};
  Estimate slope{};
};

/// Adds the breathers at s_0 - beside and s_0 + beside; the slope between the two.
Estimate add_beside(Family& family, double beside) {
  const auto add = [&](double s) {
    const auto problem = problem_at(family.centre, {omega_b, s});
    const Orbit<double> orbit = newton_from(problem, family.exchange.orbit);
    family.breathers.push_back({{omega_b, s}, orbit, spectrum<double>(problem, orbit)});
    return family.breathers.back().spectrum.kappa();
  };
  const double s_0 = family.exchange.place.value;
  const Estimate below = add(s_0 - beside), above = add(s_0 + beside);
  return quotient({below.value - above.value, below.error + above.error}, exact(2 * beside));
}

Family family_of(Centre centre, int steps) {
  Family family{centre, over_s(centre, steps)};
  std::vector<BreatherAt>& all = family.breathers;
  const auto low = std::adjacent_find(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return a.spectrum.kappa().value * b.spectrum.kappa().value < 0;
  });
  if (low == all.end()) throw NoBranch("kappa has one sign in all these wells");
  const Cut over_wells{.along_s = true, .fixed = omega_b};
  family.exchange =
      exchange<Wide>(centre, over_wells, low->spot.s, std::next(low)->spot.s, low->orbit);

  // Six more breathers
  add_beside(family, 0.001);
  const Estimate narrow = add_beside(family, 0.004), wide = add_beside(family, 0.01);
  family.slope = with_error(narrow, wide);
  std::sort(all.begin(), all.end(),
            [](const auto& a, const auto& b) { return a.spot.s < b.spot.s; });
  return family;
}

void report_over_s(Report& report, const Family& family) {
  Table& table = report.table(name_of(family.centre) + "_against_s");
  for (const BreatherAt& at : family.breathers) {
    const double kappa = at.spectrum.kappa().value;
    const double on_circle = std::sqrt(std::max(0.0, -kappa));
    const double on_axis = std::sqrt(std::max(0.0, kappa));
    table.add({{"s", at.spot.s},
               {"kappa", at.spectrum.kappa()},
               {"argument", 2 * std::asin(on_circle)},
               {"growth", 2 * std::asinh(on_axis)},
               {"largest_modulus", at.spectrum.largest_modulus()}});
  }
}

/**
At $\omega_b = 1.1$ strong anharmonicity reverses the stability found in the linear well if it is hard, but not if it is
soft. So the stability depends on the strength and the sign of the anharmonicity, and all moduli are below 1.001, as the
article's conclusion says. Away from the exchange the two values of $\kappa$ are opposite, and equal in size to a
relative $10^{-4}$.

| | $\kappa$ around a site | around a bond | largest modulus of the unstable one |
|---|---|---|---|
| $s = 0$ | [1.148e-8](cell:site_against_s/s=0/kappa) | [-1.148e-8](cell:bond_against_s/s=0/kappa) | [1.000214](cell:site_against_s/s=0/largest_modulus) |
| $s = 1$ | [-6.491e-8](cell:site_against_s/s=1/kappa) | [6.490e-8](cell:bond_against_s/s=1/kappa) | [1.000510](cell:bond_against_s/s=1/largest_modulus) |

## The exchange of stability

The zeros of $\kappa$ are far from the printed values and next to each other. A program that shares no line with this
one (`tests/second`) finds both to $10^{-7}$, a third of their distance (`paper/second.ecsv`).

<!-- exchange.equal -->
At $\omega_b = 1.1$ the site- and bond-centred breathers exchange stability at almost the same anharmonicity, and not at
$s = 0.05$ and $0.26$: the stability of the former changes at $s =$ 0.1525195, that of the latter at $s =$ 0.1525198.
The two values are 3.2e-7 apart, and in between both breathers are stable. (computed)
<!-- /exchange.equal -->

Both are known to $10^{-9}$. Why together? A picture: the centre of the breather moves in a potential $V_1\cos2\pi X +
V_2\cos4\pi X + \dots$, and the two breathers are its extrema. If it is nearly a sine, one is stable and the other not;
where $V_1$ passes through zero they change places, and $V_2$ decides what happens in between (`sec33_between`). Why it
vanishes at this $s$ we do not know. If the printed values were right, both breathers would be stable for all $s$
between them: the potential would be far from a sine there, with a third breather between the two. */
void report_exchange(Report& report, const Family& around_site, const Family& around_bond) {
  const Estimate site = around_site.exchange.place, bond = around_bond.exchange.place;
  report.table("exchange")
      .add({{"site", site},
            {"bond", bond},
            {"gap", Estimate{bond.value - site.value, site.error + bond.error}},
            {"slope", around_site.slope}});
}

/**
## What may have moved the printed exchanges

Can one cause move the exchange around a site to 0.05 and that around a bond to 0.26? At these $s$ we find $\kappa =$
[7.72e-9](cell:beside_printed/centre=site/s=0.05/kappa) around a site and
[8.12e-9](cell:beside_printed/centre=bond/s=0.26/kappa) around a bond. So one and the same error of $\kappa$,
$-8\cdot10^{-9}$, moves both. An error of the flow can be as large (we did not compare signs): at a tolerance of
$10^{-6}$ the four eigenvalues give the $\kappa$ of figure x47 to $1.2\cdot10^{-8}$. Or a threshold: that a
multiplier counts as off the circle only beyond $1+\theta$ acts like the error $-\theta^2/4$. If each $s$ is rounded as
printed, all $\theta$ from [0.00017604](cell:beside_printed/centre=bond/s=0.255/beyond_one) to
[0.00017998](cell:beside_printed/centre=site/s=0.045/beyond_one) give both. We cannot tell which. */
constexpr double omega_printed = 1.1;
constexpr std::pair<Centre, double> printed_exchanges[] = {{Centre::site, 0.05},
                                                           {Centre::bond, 0.26}};

void report_printed_exchanges(Report& report) {
  Table& table = report.table("beside_printed");
  for (const auto& [centre, printed] : printed_exchanges)
    for (const double rounding : {-0.005, 0.0, 0.005}) {
      const auto problem = problem_at(centre, {omega_printed, printed + rounding});
      const MultiplierPair pinning =
          spectrum<double>(problem, find_breather(problem)).pairs.front();
      table.add({{"centre", name_of(centre)},
                 {"s", printed + rounding},
                 {"kappa", Estimate{pinning.kappa.real(), pinning.error}},
                 {"beyond_one", distance_from_one(pinning)}});
    }
}

/**
## The pinning mode (figure 13)

The breather starts from rest, so the eigenvectors of $\lambda$ and $1/\lambda$ have the same displacements at $t = 0$
and opposite velocities. We compare these displacements, in the linear well, with the discrete gradient
$y_{n+1}(0)-y_{n-1}(0)$, both of length one.

![Pinning mode and discrete gradient.](fig:13)

The article calls the two very close. Both shift the breather along the chain; the mode is more concentrated. The angle
is [9.1](cell:harmonic/centre=site/angle) degrees around a site and [11.6](cell:harmonic/centre=bond/angle) around a
bond, where its cosine is [0.980](cell:harmonic/centre=bond/cosine). For a kick see `sec33_mobility`. */
void report_pinning_mode(Report& report, Table& harmonic, Centre centre) {
  const auto problem = problem_at(centre, {omega_b, 0});
  const Orbit<double> orbit = find_breather(problem);
  const Spectrum all = spectrum<Wide>(problem, orbit);
  const Vector<double> g = discrete_gradient(orbit.start.y).normalized();
  const double in_double = alignment(spectrum<double>(problem, orbit).mode, g);
  const double cosine = alignment(all.mode, g);
  const auto degrees = [](double x) { return std::acos(x) * 180 / std::numbers::pi; };
  harmonic.add({{"centre", name_of(centre)},
                {"kappa", all.kappa()},
                {"others", excess(all.pairs, 1)},
                {"cosine", with_error(in_double, cosine)},
                {"angle", with_error(degrees(in_double), degrees(cosine))}});

  // Both vectors, bead by bead; the sign of an eigenvector is chosen as that of the gradient
  const Vector<double> mode = all.mode.dot(g) < 0 ? -all.mode : all.mode;
  Table& table = report.table("mode_" + name_of(centre));
  for (Eigen::Index i = 0; i < g.size(); ++i)
    table.add({{"n", site_number(std::size_t(i), std::size_t(g.size()))},
               {"mode", mode[i]},
               {"gradient", g[i]}});
}

/**
## Towards $\omega_b = 1$

Is the instability of the DpS equation that of the chain? There the site-centred breather of frequency $\mu$ is unstable
at the rate $\sigma = 0.00156\,\mu$ per unit of $\tau/(2\tau_0)$ (`sec33_dps_stability`), with the slow time $\tau$ of
section 3.1. By Eq. (20), where $\mu = 1$, a breather of the chain of size $\epsilon$ has $\delta = \omega_b-1 =
\epsilon^{1/2}/(2\tau_0)$. So if the same holds for the chain, its rate $\ln\lambda/T_b$ tends to $0.00156\,\delta$:
weaker by $O(\epsilon^{1/2})$, as the article says. We compute breathers near $\omega_b = 1$ in extended precision. The
rate over $\delta$, and the exponent of the rate in $\epsilon\propto\delta^2$, are extrapolated linearly in $\delta$.
The error is the difference from the extrapolation one breather earlier, plus what the errors of the rates contribute.

| quantity | article | here |
|---|---|---|
| rate over $\delta$, at $\omega_b = 1.1$ | | [0.00038](cell:slow_limit/here) |
| its limit | | [0.0015577 ± 3e-7](cell:slow_limit/relative_rate) |
| the same by the DpS equation | | [0.0015577](cell:slow_limit/dps) |
| rate $\propto\epsilon^p$, exponent $p$ | 1/2 | [0.500](cell:slow_limit/exponent) |

The limit is approached slowly: at $\omega_b = 1.1$ the instability of the chain is four times weaker than the DpS
equation suggests. */
constexpr double deltas[] = {8e-4, 4e-4, 2e-4, 1e-4};  // each half of the one before

/// ln(lambda) / T_b / delta of the site-centred breather in the linear well, where lambda is real.
Estimate relative_rate(double delta) {
  const auto problem = problem_at(Centre::site, {1 + delta, 0});
  const Orbit<double> orbit = find_breather(problem);
  const Estimate kappa = spectrum<Wide>(problem, orbit).kappa();
  if (kappa.value <= 0) throw NoBranch("this breather is stable: it has no growth rate");
  const double root = std::sqrt(kappa.value), per = 1 / (orbit.period() * delta);
  return {2 * std::asinh(root) * per, kappa.error / root * per};
}

void report_slow(Report& report) {
  // The rate is delta times these, and eps goes like delta^2
  std::vector<Estimate> rates, exponents;
  for (const double delta : deltas) rates.push_back(relative_rate(delta));
  for (std::size_t k = 1; k < rates.size(); ++k) {
    const Estimate fall = quotient(rates[k - 1], rates[k]);
    exponents.push_back(
        {(1 + std::log2(fall.value)) / 2, fall.error / fall.value / (2 * std::numbers::ln2)});
  }
  report.table("slow_limit")
      .add({{"exponent", limit_by_halving(exponents)},
            {"relative_rate", limit_by_halving(rates)},
            {"here", relative_rate(omega_b - 1)},
            {"dps", margin_of<long double>(Centre::site, 1, sites_of(Centre::site)).exponent}});
}

/**
## Over the plane of $\omega_b$ and $s$

Do four multipliers stay near $+1$, and the breathers weakly unstable, for all $\omega_b$ in $(1,2]$ and $s$ in
$[-1,1]$? In ten wells we follow both families to higher frequencies, as far as they reach. *Near* is our
choice: within 0.01. A bead at rest far out has the frequency one and thus its pair at $e^{\pm2\pi i/\omega_b}$, so that
every further site adds two multipliers there; on these chains at least 4 are within $10^{-4}$ in $\kappa$.

![Distance of the fourth multiplier from $+1$, bond-centred breathers. Dots: the pinning pair is real, so the
site-centred breather is the stable one; triangles: other multipliers have left the circle.](fig:x64)

Which breather is stable where? As long as the other multipliers are on the circle, one of the two is, and the other one
is not, everywhere on this grid. At $\omega_b = 1.01$ it is the bond-centred one in all wells. In hard wells of $s \ge
\frac14$ it is the site-centred one from 1.1 on. In the linear and in soft wells the two take turns: at $s = 0$ the
bond-centred one is unstable at 1.2 and 1.4, stable at 1.3 and from 1.5 on.

For $s \le 0$ the four stay near $+1$, to [0.0021](cell:spectra/centre=bond/omega=1.5/s=-1/fourth). In hard wells the
pinning pair leaves it as the frequency grows, around a site along the circle, around a bond along the real axis. There
the instability passes the article's $10^{-3}$ at $\omega_b = 1.2$ if $s \ge \frac12$, and at $\omega_b = 2$ and $s = 1$
the multiplier exceeds one by [1.061](cell:spectra/centre=bond/omega=2/s=1/largest): a disturbance doubles in each
period. At the last frequency in four of the five soft wells other multipliers leave the circle, by
[0.286](cell:spectra/centre=bond/omega=1.9/s=-1/6/others) at $\omega_b = 1.9$ and $s = -\frac16$. */
const std::vector<double> wells{1, 0.75, 0.5, 0.25, 0, -1.0 / 6, -0.25, -0.5, -0.75, -1};

const std::vector<double> frequencies{1.01, 1.2, 1.3, 1.4, 1.5,
                                      1.6,  1.7, 1.8, 1.9, 2};  // 1.1: see above

/// The family in one well, from the lowest frequency on, with its pairs.
std::vector<BreatherAt> over_omega(Centre centre, double s, const std::vector<double>& omegas) {
  std::vector<BreatherAt> family;
  for (const auto& orbit : breathers_at(problem_at(centre, {omegas.front(), s}), omegas))
    family.push_back({{omegas[family.size()], s}, orbit});
  for (BreatherAt& at : family) {
    // Where the tail reaches the ends of the chain, it gets ten more sites
    if (sites_needed(at.orbit, 1e-17) == at.orbit.start.y.size()) {
      at.spot.more = 10;
      at.orbit = lengthened(problem_at(centre, at.spot), at.orbit);
    }
    at.spectrum = spectrum<double>(problem_at(centre, at.spot), at.orbit);
  }
  return family;
}

void report_plane(Report& report, Table& table, const Family& near) {
  const auto omegas = report.quick ? std::vector{1.01} : frequencies;
  std::vector<std::vector<BreatherAt>> families(wells.size());
  parallel_for("wells", families.size(),
               [&](std::size_t k) { families[k] = over_omega(near.centre, wells[k], omegas); });
  families.push_back(near.breathers);

  for (const auto& family : families)
    for (const auto& [spot, orbit, all] : family)
      table.add({{"centre", name_of(near.centre)},
                 {"omega", spot.omega_b},
                 {"s", spot.s},
                 {"fourth", distance_from_one(all.pairs[0])},
                 {"fifth", distance_from_one(all.pairs[1])},
                 {"others", excess(all.pairs, 1)},
                 {"largest", excess(all.pairs)},
                 {"at_edge", at_edge(all.pairs, spot.omega_b)}});
}

void reproduce(Report& report) {
  report.output.note("tolerance", "128 and 2048 machine epsilons, unless a table says otherwise");
  report_tolerances(report);
  const int steps = report.quick ? 2 : steps_to_one;
  const Family site = family_of(Centre::site, steps), bond = family_of(Centre::bond, steps);
  for (const Family& family : {site, bond}) report_over_s(report, family);
  report_exchange(report, site, bond);
  report_printed_exchanges(report);
  Table& harmonic = report.table("harmonic");
  for (Centre centre : both_centres) report_pinning_mode(report, harmonic, centre);
  report_slow(report);
  Table& spectra = report.table("spectra");
  for (const Family& family : {site, bond}) report_plane(report, spectra, family);
}

/**
## Statement by statement

<!-- statements -->
| statement | printed | here | verdict |
|---|---|---|---|
| `floquet.spectrum`: the spectrum always includes four multipliers in the immediate vicinity of +1, and others accumulate on the circle at exp(+-2 pi i/omega_b) | structure | fails 42 of 532 comparisons; first spectra.fourth (centre = site, omega = 1.5, s = 1): 0.0205 < 0.01; by most spectra.fourth (centre = bond, omega = 2, s = 1): 1.061 < 0.01 | in part |
| `floquet.s0_bond`: anharmonicity at which the bond-centred breather loses stability (omega_b = 1.1) | 0.26 | 0.1525 | discrepant |
| `floquet.s0_site`: anharmonicity above which the site-centred breather is stable (omega_b = 1.1) | 0.05 | 0.1525 | discrepant |
| `floquet.collision`: a pair of multipliers leaves the circle at +1 for larger s around a bond, and one with lambda > 1 enters it there for larger s around a site | above; below | spectra.fourth (centre = site, omega = 1.1, s = 0.1515): 1.737e-05 < 0.0001 (the closest of 98) | holds |
| `floquet.harmonic`: at s = 0 and omega_b = 1.1 the site-centred breather is weakly unstable and the bond-centred one stable | verdict | site_against_s.largest_modulus (s = 0): 0.0002143 < 0.001 (the closest of 5) | holds |
| `floquet.instability_size`: unstable multipliers of section 3.3 (omega_b = 1.1) exceed 1 by less than | 1e-3 | site_against_s.largest_modulus (s = -1): 0.0005839 < 0.001 (the closest of 94) | holds, assuming |
| `pinning.gradient`: pinning mode is close to the discrete gradient for both breathers | very close | 0.9797 | quantified |
| `outlook.sign_of_s`: stability depends on the strength (and sign) of the anharmonicity | depends | site_against_s.kappa (s = 0.1): 0 < 3.959e-09 (the closest of 100) | holds |
| `floquet.weaker`: the instability is O(epsilon^(1/2)) times weaker in the chain than in the DpS equation | 0.5 | 0.500 | reproduced |
<!-- /statements -->

## Try it

**To change it.** `omega_b` is the frequency of figures 11 to 13 (with 1.15 the exchange moves to 0.0188; the run stops
if there is none between $s = -1$ and 1, or, as with 1.2, if the site-centred breather is stable at $s = 0$), `wells`
and `frequencies` span the plane, `deltas` leads to $\omega_b = 1$. Another well or contact is set in `problem_at`
(exchange.hpp), or by `multipliers --well`, `--contact`, `--mass-ratio`.

1. *Easy.* At a slightly higher frequency the exchange lies elsewhere:
   `build/bin/sec33_floquet exchange --centre bond --omega 1.15` gives `s0` = 0.018781. Hint: follow it on. Where
   does the curve of exchange reach the linear well?
2. *Harder.* Which breather is stable can be decided without multipliers.
   `build/bin/sec32_barrier barrier --omega 1.1 --s 0.05` gives `equal_area` = -1.58248e-13, and
   `build/bin/sec32_barrier barrier --omega 1.1 --s 0.26` gives `equal_area` = 1.66492e-13. Hint: at equal action the
   breather of higher energy is the stable one here, because the effective mass is negative (`sec33_mobility`). Does
   this agree with $\kappa$, and with the printed exchanges? */
int main(int argc, char** argv) {
  return run({"sec33_floquet", "3.3", "Stability of the breathers (section 3.3)", reproduce,
              commands<Multipliers, Exchanges>()},
             argc, argv);
}
