/**
# 3.3 Floquet multipliers of the breathers of the chain

Which of the two breathers of the chain is stable, and in which wells? We compute their *Floquet multipliers* $\lambda$,
the eigenvalues of the matrix by which one period multiplies a small disturbance: a multiplier outside the unit circle
makes it grow. Section 3.3 of James, Kevrekidis and Cuevas (Physica D 251, 2013) finds four multipliers so close to $+1$
that the breathers are almost free to move. It says that

- in the linear well, at $\omega_b = 1.1$, the site-centred breather is weakly unstable and the bond-centred one stable;
- in wells of anharmonicity $s$ the bond-centred one loses its stability at $s_0^b \approx 0.26$ and the site-centred
  one gains it at $s_0^s \approx 0.05$, where a pair of multipliers collides at $+1$ (figures 11 and 12);
- all other multipliers lie on the unit circle and accumulate at $e^{\pm2\pi i/\omega_b}$;
- the *pinning mode*, which shifts the breather along the chain, is very close to its discrete gradient (figure 13);
- near $\omega_b = 1$ the instability is weaker than that of the DpS equation by a factor of $O(\epsilon^{1/2})$.

![Arguments and moduli of the four multipliers near one, bond-centred. Drawn by fig11_bond_quadruplet.gp: `argument`
and `excess`, and those of the partner, against `s`, from `bond_against_s`.](fig:11)

At $\omega_b = 1.1$ and in the linear well all of this holds except the two values of $s_0$: we find both at
$s = 0.1525$. These numbers are hard to compute. Two multipliers are exactly $+1$ for every breather, and share one
eigenvector, so an error $\delta$ of the matrix splits them by $\sqrt\delta$: an error of $10^{-8}$ becomes $10^{-4}$,
as large as the instability itself.

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
A pair is on the unit circle if $-1\le\kappa\le0$. If $\kappa > 0$ it is real, the breather is unstable, and next to
$+1$ we have $\ln\lambda \simeq 2\sqrt\kappa$. The pair that is always $+1$ belongs to a shift in time, which changes
the velocities along the accelerations $f$, and after half a period, where all beads are at rest again, no position:
$Bf = 0$. Hence $f^TK = 0$, and leaving out the direction of $f$ removes the pair exactly. The *pinning pair* belongs to
a shift along the chain; its $\kappa$ is now a simple eigenvalue, and an error $\delta$ moves it by $\delta$ instead of
$\sqrt\delta$. */
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <string>
#include <vector>

#include "commands/exchanges.hpp"
#include "commands/multipliers.hpp"
#include "lattice/algebra/eigenvalues.hpp"
#include "lattice/gsl/random.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "lattice/numerics/parallel.hpp"
#include "lattice/standing/spectrum.hpp"
#include "report/program.hpp"

using namespace lattice;

/**
## The experiment

We integrate half a period of the flow and of its derivative and compute the eigenvalues of $K$, first for one breather,
then along a line of wells or frequencies. `problem_at` is a chain in wells of anharmonicity `s` with the conditions on
a breather after a quarter (site) or half (bond) of its period; `find_breather` solves them by Newton's method from the
profile of Eqs. (18) to (20), `follow` from a neighbouring breather. The flow takes steps of variable length and order,
to a tolerance of 128 roundings of the number type, and ends one at every contact event. `pairs_of(K, f)` leaves out the
direction of `f` and calls Eigen. */
constexpr double omega_b = 1.1;

/// All pairs of multipliers of a breather except that of a shift in time, the nearest to +1 first.
template <class T>
Pairs<T> multiplier_pairs(const Chain& chain, const Orbit<T>& breather,
                          const EventTolerance<T>& tolerance) {
  // The derivative of the flow: one column for each of the 2N small changes
  const Matrix<T> F = monodromy(chain, breather.start, breather.period() / T(2), tolerance);
  const Eigen::Index N = F.rows() / 2;
  const Matrix<T> B = F.topRightCorner(N, N), C = F.bottomLeftCorner(N, N);
  const Matrix<T> K = B.transpose() * C;
  // The eigenvalues of K on all directions that are perpendicular to the accelerations
  const std::vector<T> f = accelerations(chain, breather.start.y);
  Pairs<T> pairs = pairs_of<T>(K, Eigen::Map<const Vector<T>>(f.data(), N));
  pairs.defect = symplectic_defect(F);  // an error of F, which counts
  return pairs;
}

/// The same with their errors: twice, with tolerances of the flow that differ by a factor of sixteen, and the coarser
/// run has to find the breather again, from a point beside it.
template <class T>
Spectrum stability(const Shooting<double>& problem, const Orbit<double>& breather) {
  return spectrum<T>(problem, breather, multiplier_pairs<T>);
}

struct StabilityAt : Spectrum {  // pairs of multipliers, with their errors
  Spot spot{};                   // omega_b and s
  Orbit<double> orbit{};
};

/// Both ways along a line of frequencies and wells, from the breather at its place `first`.
std::vector<StabilityAt> along(Centre centre, const std::vector<Spot>& line, std::size_t first,
                               const Orbit<double>& breather) {
  std::vector<StabilityAt> out(line.size());
  const auto find = [&](std::size_t k, const Orbit<double>& neighbour) {
    out[k].spot = line[k];
    out[k].orbit = follow(problem_at(centre, line[k]), neighbour);  // by Newton's method
  };
  out[first] = {{}, line[first], breather};
  for (std::size_t k = first + 1; k < line.size(); ++k) find(k, out[k - 1].orbit);
  for (std::size_t k = first; k-- > 0;) find(k, out[k + 1].orbit);
  parallel_for(line.size(), [&](std::size_t k) {
    static_cast<Spectrum&>(out[k]) = stability<double>(problem_at(centre, line[k]), out[k].orbit);
  });
  return out;
}

std::vector<StabilityAt> in_wells(Centre centre, const std::vector<double>& wells) {
  std::vector<Spot> line;
  for (double s : wells) line.push_back({omega_b, s});
  const std::size_t middle = line.size() / 2;
  return along(centre, line, middle, find_breather(problem_at(centre, line[middle])));
}

/**
The error of $\kappa$ is the difference of the two computations plus the symplectic defect of $F$. A pair counts as off
the circle if it leaves it by more than its error. The program stops with an error if Newton's method does not converge,
or if $F$ does not map a shift in time to a shift in time.

## Four multipliers near $+1$

On the article's chain of 31 sites, and on ten sites more for the error, four multipliers lie near $+1$; the fifth is a
thousand times farther away. (All else is computed on 21 and 22 sites; the force on the next bead beyond their ends
would be below rounding.)

| distance from $+1$ at $s = 0$ | article | around a site |
|---|---|---|
| fourth multiplier | close to it | [0.000214282 ± 1e-9](num:sec33_floquet.fourth_distance) |
| fifth multiplier | | [0.229543 ± 2e-12](num:sec33_floquet.fifth_distance) | */
void report_spectrum(Report& report) {
  const auto around_site = [](std::size_t more) {
    const auto problem = problem_at(Centre::site, {omega_b, 0, more});
    return stability<double>(problem, find_breather(problem)).pairs;
  };
  const std::vector<Pair> pairs = around_site(10), longer = around_site(20);
  const auto distance = [&](std::size_t k) {
    const Estimate here = from_one(pairs[k]), there = from_one(longer[k]);
    return Estimate{here.value, here.error + std::abs(there.value - here.value)};
  };
  report.facts.add("fourth_distance", distance(0));
  report.facts.add("fifth_distance", distance(1));
}

/**
## The four multipliers against $s$ (figures 11 and 12)

Each breather is found at an intermediate $s$ and continued from there to $s = -1$ and to $s = 1$. A pair on the circle
has modulus exactly one, a pair on the real axis argument zero. Near an exchange of stability the multipliers leave $+1$
like square roots, so the values of $s$ are denser there.

![The same around a site. The table is `site_against_s`.](fig:12) */
std::string name_of(Centre centre) {
  return centre == Centre::bond ? "bond" : "site";
}

constexpr const char* others_off_circle =
    "how many of the other pairs leave the unit circle by more than their error";

std::array<std::vector<StabilityAt>, 2> report_wells(Report& report) {
  std::vector<double> wells;
  for (int steps = report.quick ? 4 : 40, k = -steps; k <= steps; ++k)
    wells.push_back(double(k) / steps);
  for (double beside : {0.001, 0.004, 0.01})
    wells.insert(wells.end(), {0.1525 - beside, 0.1525 + beside});
  std::sort(wells.begin(), wells.end());

  // Pinning pair and largest modulus, well by well
  Estimate largest{};
  std::array<std::vector<StabilityAt>, 2> lines;
  for (Centre centre : both_centres) {
    Table& table = report.table(
        name_of(centre) + "_against_s",
        {number("s", "anharmonicity of the well"),
         estimate("kappa", "(lambda + 1/lambda - 2) / 4 of the pinning pair of multipliers", "",
                  "from two tolerances, against the neighbouring rows"),
         number("argument", "argument of the multiplier in the upper half plane", "rad"),
         number("argument_below", "argument of its partner", "rad"),
         number("excess", "modulus of the larger multiplier minus one"),
         number("excess_below", "modulus of the smaller multiplier minus one"),
         number("error_of_multiplier", "error of either multiplier of the pair"),
         estimate("largest_modulus", "largest modulus of all multipliers")});
    for (const StabilityAt& at : lines[centre == Centre::bond] = in_wells(centre, wells)) {
      // On the circle a pair has arguments, on the real axis it has moduli
      const double kappa = at.kappa().value;
      const double angle = 2 * std::asin(std::sqrt(std::max(0.0, -kappa)));
      const double rate = 2 * std::asinh(std::sqrt(std::max(0.0, kappa)));
      table.add({at.spot.s, at.kappa(), angle, -angle, std::expm1(rate), std::expm1(-rate),
                 at.pairs.front().multiplier_error(), at.largest_modulus()});
      largest = larger(largest, excess(at.pairs));
    }
  }
  report.facts.add("largest_excess", largest);
  return lines;
}

/**
## The exchange of stability

The zero of $\kappa$ in $s$ is found by regula falsi in double precision, with two last steps in extended precision (a
64-bit mantissa; exchange.hpp). Its error is that of $\kappa$ over the slope of $\kappa$, which is small: two digits of
$s_0$ need $\kappa$ to $10^{-9}$.

<!-- exchange.equal -->
At $\omega_b = 1.1$ the site- and bond-centred breathers exchange stability at almost the same anharmonicity, and not at
$s = 0.05$ and $0.26$: the stability of the former changes at $s =$ 0.152519, that of the latter at $s =$ 0.152520. The
two values are 3.22e-7 apart, and in between both breathers are stable. (computed)
<!-- /exchange.equal -->

Why do the two exchange their stability at all? Both are extrema of one potential of the breather's centre, which has
the period of the chain (`sec32_barrier`). If it is nearly a sine, they are its only extrema in a period, and one is
stable, the other unstable. Where its amplitude passes through zero as $s$ changes, the potential turns upside down, and
both change stability at almost the same $s$. Only there do higher harmonics matter; they decide what happens in between
(`sec33_between`). Exchanges as far apart as the printed ones would need a potential that is far from a sine at every
$s$ between them. */
std::array<Exchange, 2> report_exchange(Report& report) {
  // Around a site and around a bond; both lie between 0.1 and 0.2
  std::array<Exchange, 2> found;
  parallel_for(2, [&](std::size_t k) {
    const Orbit<double> near = find_breather(problem_at(both_centres[k], {}));
    found[k] = exchange<Wide>(both_centres[k], Cut{}, 0.1, 0.2, near);
  });
  const Estimate site = found[0].place, bond = found[1].place;
  report.facts.add("exchange_site", site);
  report.facts.add("exchange_bond", bond);
  report.facts.add("exchange_gap", {bond.value - site.value, site.error + bond.error});

  // The slope of kappa between two wells, h on either side of the exchange
  const auto slope = [&](double h) {
    const auto kappa = [&](double s) {
      const auto problem = problem_at(Centre::site, {omega_b, s});
      return stability<double>(problem, follow(problem, found[0].orbit)).kappa();
    };
    const Estimate below = kappa(site.value - h), above = kappa(site.value + h);
    return Estimate{std::abs(above.value - below.value) / (2 * h),
                    (above.error + below.error) / (2 * h)};
  };
  report.facts.add("exchange_slope", compare(slope(0.02), slope(0.01)));
  return found;
}

/**
Can one cause move the exchange around a site to 0.05 and that around a bond to 0.26? If a multiplier counts as off the
circle only beyond some threshold $\theta$, the instability seems to end too early around a site and to begin too late
around a bond, and a range of $\theta$ gives both printed numbers. The article names no threshold, so this is only a
possible cause. Errors of the matrix are another one.

| quantity | article | here |
|---|---|---|
| $s_0^b$, around a bond | 0.26 | [0.152520 ± 5e-10](num:floquet.s0_bond) |
| $s_0^s$, around a site | 0.05 | [0.152519 ± 8e-10](num:floquet.s0_site) |
| their distance | 0.21 | [3.22e-7 ± 1e-9](num:sec33_floquet.exchange_gap) |
| slope of $\kappa$ there, per unit of $s$ | | [7.5451e-8 ± 9e-12](num:sec33_floquet.exchange_slope) |
| $\lambda-1$ around a site, in the well $s = 0.05$ | | [0.000175756 ± 2e-9](num:sec33_floquet.excess_s_005_site) |
| $\lambda-1$ around a bond, in the well $s = 0.26$ | | [0.000180293 ± 1e-9](num:sec33_floquet.excess_s_026_bond) |
| least $\theta$ that gives both printed numbers | | [0.000176041 ± 9e-10](num:sec33_floquet.theta_from) |
| largest such $\theta$ | | [0.000179983 ± 1e-9](num:sec33_floquet.theta_to) | */
void report_threshold(Report& report, const std::array<Exchange, 2>& found) {
  const auto excess_at = [&](std::size_t k, double s) {
    const auto problem = problem_at(both_centres[k], {omega_b, s});
    const Orbit<double> orbit = follow(problem, found[k].orbit);
    return from_one(stability<double>(problem, orbit).pairs.front());
  };
  report.facts.add("excess_s_005_site", excess_at(0, 0.05));
  report.facts.add("excess_s_026_bond", excess_at(1, 0.26));
  // The instability falls with s around a site and rises around a bond
  report.facts.add("theta_from", larger(excess_at(0, 0.055), excess_at(1, 0.255)));
  report.facts.add("theta_to", smaller(excess_at(0, 0.045), excess_at(1, 0.265)));
}

/**
## Errors of the matrix

How accurate must $M$ be, if the four multipliers are its eigenvalues? In an inaccurate matrix one cannot tell which of
them belong together. But a symmetric function of the four,
$$\kappa \simeq \frac18\sum_{k=1}^4\frac{(\lambda_k-1)^2}{\lambda_k},$$
gives $\kappa$ without telling, and depends smoothly on the matrix. We add uniform noise of size $\delta$ to the matrix
of the stable, bond-centred breather in the linear well, with eight seeds. */
struct Displaced {
  double multipliers = 0;  ///< the farthest that one of the four is from where it belongs
  double excess = 0;       ///< their largest distance from the circle
  double kappa = 0;        ///< change of kappa
  double spread = 0;       ///< of a mean: its standard error, relative
};

Displaced displaced(const Matrix<double>& M, double kappa) {
  std::vector<std::complex<double>> all = eigenvalues_of(M);
  std::stable_sort(all.begin(), all.end(),
                   [](auto a, auto b) { return std::norm(a - 1.0) < std::norm(b - 1.0); });
  const auto up = multiplier(kappa, 1), down = multiplier(kappa, -1);
  Displaced out;
  std::complex<double> sum = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::complex<double> z = all[k];
    out.multipliers = std::max(out.multipliers,
                               std::min({std::abs(z - 1.0), std::abs(z - up), std::abs(z - down)}));
    out.excess = std::max(out.excess, std::abs(std::abs(z) - 1));
    sum += (z - 1.0) * (z - 1.0) / z;
  }
  out.kappa = std::abs(sum.real() / 8 - kappa);
  return out;
}

/// Geometric means over eight draws of noise, of the excess the largest.
Displaced by_noise(const Matrix<double>& M, double delta, double kappa) {
  Displaced out;
  double square = 0;
  for (unsigned long seed = 1; seed <= 8; ++seed) {
    Random random(seed);
    Matrix<double> noisy = M;
    for (Eigen::Index i = 0; i < M.size(); ++i) noisy.data()[i] += delta * random.uniform(-1, 1);
    const Displaced d = displaced(noisy, kappa);
    out.multipliers += std::log(d.multipliers) / 8, out.kappa += std::log(d.kappa) / 8;
    out.excess = std::max(out.excess, d.excess);
    square += std::pow(std::log(d.kappa), 2) / 8;
  }
  return {std::exp(out.multipliers), out.excess, std::exp(out.kappa),
          std::sqrt((square - out.kappa * out.kappa) / 7)};
}

/**
The four move by $\delta^{1/2}$ and $\kappa$ by $\delta$: the exponents are
[0.510](num:sec33_floquet.exponent_multipliers) and [0.9997](num:sec33_floquet.exponent_kappa). Matrices from a flow at
looser tolerances, with the largest error of an entry as $\delta$, follow both laws with factors that scatter (table
`matrix_errors`). At $\delta = 10^{-6}$ a modulus of the stable breather differs from one by up to
[0.000496](num:sec33_floquet.excess_of_noise), more than the [0.000214](num:sec33_floquet.excess_site) of the unstable
one. And $\delta =$ [2e-7](num:sec33_floquet.delta_of_tenth) changes $\kappa$ by as much as 0.1 in $s$ does, which is as
far as either printed exchange is from ours. Why one is too low and the other too high, we do not know: this is a
mechanism, not necessarily the cause. */
void report_matrix_errors(Report& report, double slope) {
  const auto problem = problem_at(Centre::bond, {});
  const Orbit<double> orbit = find_breather(problem);
  const double kappa = stability<double>(problem, orbit).kappa().value;
  const auto matrix = [&](const EventTolerance<double>& tolerance) {
    return monodromy(problem.chain, orbit.start, orbit.period(), tolerance);
  };
  const Matrix<double> M = matrix({}), coarser = matrix(rule<double>(1).events);
  Table& table = report.table(
      "matrix_errors",
      {label("source", "source of the error: noise, or a loosened tolerance"),
       number("delta", "size of the change of the matrix"),
       number("displacement", "largest displacement among the four multipliers next to +1"),
       number("excess", "largest distance of a modulus from one, among the four"),
       number("kappa_change", "change of kappa")});
  std::vector<double> sizes, moves, changes;
  for (int power = -5; power >= -11; --power) {
    const double delta = std::pow(10.0, power);
    const Displaced d = by_noise(M, delta, kappa);
    sizes.push_back(std::log(delta));
    moves.push_back(std::log(d.multipliers));
    changes.push_back(std::log(d.kappa));
    table.add({"noise", delta, d.multipliers, d.excess, d.kappa});
    if (power != -6) continue;
    const double tenth = delta * 0.1 * slope / d.kappa;
    report.facts.add("excess_of_noise", compare(by_noise(coarser, delta, kappa).excess, d.excess));
    report.facts.add("delta_of_tenth", {tenth, tenth * d.spread});
  }
  report.facts.add("exponent_multipliers", fit_line(sizes, moves).estimate());
  report.facts.add("exponent_kappa", fit_line(sizes, changes).estimate());
  for (int power = -4; power >= -12; --power) {
    EventTolerance<double> loose;
    loose.tolerance = std::pow(10.0, power);
    const Matrix<double> other = matrix(loose);
    const Displaced d = displaced(other, kappa);
    table.add({"tolerance", sup<double>((other - M).reshaped()), d.multipliers, d.excess, d.kappa});
  }
}

/**
## Stability in five wells

In the linear well the sign of $\kappa$ is taken in extended precision, where its error is eight orders of magnitude
below $\kappa$. An independent program with another integrator (`tests/second`) finds the same $\kappa$ to seven digits
and both $s_0$ to six. */
void report_harmonic(Report& report) {
  Table& table = report.table("harmonic");
  for (Centre centre : both_centres) {
    const auto problem = problem_at(centre, {});
    const Orbit<double> orbit = find_breather(problem);
    const Spectrum all = stability<Wide>(problem, orbit);
    table.add({{"centre", "site or bond", name_of(centre)},
               {"kappa", "of the pinning pair", all.kappa()},
               {"off_circle", others_off_circle, off_circle(all.pairs)}});
    report.facts.add("kappa_" + name_of(centre), all.kappa());
    if (centre == Centre::site) report.facts.add("excess_site", from_one(all.pairs.front()));
  }
}

/**
The article's conclusion says that the stability depends on the strength and the sign of the anharmonicity. It does:
strong anharmonicity reverses the stability found in the linear well if it is hard, but not if it is soft, down to
$s = -1$. At $s = 0$ the two values are opposite and nearly equal, like the curvatures of a sine at its maximum and
minimum. No multiplier of these breathers exceeds one by more than [0.000584](num:sec33_floquet.largest_excess), less
than the $10^{-3}$ of the article's conclusion.

| $\kappa$ of the pinning pair | around a site | around a bond |
|---|---|---|
| $s = -1$ | [8.51915e-8 ± 8e-14](num:sec33_floquet.kappa_s_minus_1_site) | [-8.51949e-8 ± 7e-14](num:sec33_floquet.kappa_s_minus_1_bond) |
| $s = -0.1$ | [1.89678e-8 ± 5e-14](num:sec33_floquet.kappa_s_minus_01_site) | [-1.89680e-8 ± 5e-14](num:sec33_floquet.kappa_s_minus_01_bond) |
| $s = 0$ | [1.14767e-8 ± 8e-17](num:sec33_floquet.kappa_site) | [-1.14768e-8 ± 3e-17](num:sec33_floquet.kappa_bond) |
| $s = 0.1$ | [3.95898e-9 ± 9e-14](num:sec33_floquet.kappa_s_01_site) | [-3.95900e-9 ± 5e-14](num:sec33_floquet.kappa_s_01_bond) |
| $s = 1$ | [-6.49051e-8 ± 7e-14](num:sec33_floquet.kappa_s_1_site) | [6.49031e-8 ± 7e-14](num:sec33_floquet.kappa_s_1_bond) | */
void report_strength(Report& report) {
  const std::vector<double> wells{-1, -0.5, -0.1, 0, 0.1, 0.5, 1};
  for (Centre centre : both_centres) {
    const auto all = in_wells(centre, wells);
    for (const auto& [k, well] : {std::pair(2, "minus_01"), {4, "01"}, {0, "minus_1"}, {6, "1"}})
      report.facts.add(std::string("kappa_s_") + well + "_" + name_of(centre), all[k].kappa());
  }
}

/**
## Four multipliers near $+1$, the others on the circle

The article always finds this structure, for values of $\omega_b$ in $(1,2]$ and of $s$ in $[-1,1]$ that it does not
list. We test $\omega_b = 1.1$ in all wells, and the frequencies from 1.01 to 2 in the linear well. On these two lines
it holds: the fourth multiplier is far nearer to $+1$ than the fifth, the others are on the circle, and ten more sites
add twenty multipliers at $e^{\pm2\pi i/\omega_b}$ (to $10^{-4}$ in $\kappa$, because the tail still reaches the first
new bead; tried in three wells and at every thirteenth frequency). Elsewhere it may fail: in the hard well $s = 1$ the
pinning pair of the bond-centred breather leaves $+1$ towards $\omega_b = 2$.

| distance from $+1$ | on the two lines | at $\omega_b = 2$, $s = 1$, around a bond |
|---|---|---|
| largest of the fourth multiplier | [0.000815379 ± 2e-10](num:sec33_floquet.spectrum_fourth) | [1.06121 ± 6e-13](num:sec33_floquet.fourth_in_hard_wells) |
| its largest ratio to the fifth | [0.00254445 ± 2e-9](num:sec33_floquet.spectrum_share_of_fifth) | | */
void report_lines(Report& report, std::array<std::vector<StabilityAt>, 2> lines) {
  const int frequencies = report.quick ? 34 : 80;
  Table &spectra = report.table("spectra"), &edges = report.table("edges");
  Estimate fourth{}, share{};
  for (std::size_t k : {0U, 1U}) {
    const Centre centre = both_centres[k];
    std::vector<StabilityAt>& seen = lines[centre == Centre::bond];
    std::vector<StabilityAt> ends;
    for (const StabilityAt& at : seen)
      if (const double s = at.spot.s; s == -1 || s == 0 || s == 1) ends.push_back(at);

    // The linear well from 1.01 to 2, and from there to the hard well s = 1
    std::vector<Spot> linear, corner;
    for (int i = 0; i < frequencies; ++i)
      linear.push_back({1.01 + 0.99 * double(i) / (frequencies - 1), 0});
    for (int i = 0; i <= 24; ++i) corner.push_back({2, double(i) / 24});
    const auto across = along(centre, linear, 0, find_breather(problem_at(centre, linear.front())));
    if (centre == Centre::bond)
      report.facts.add("fourth_in_hard_wells",
                       from_one(along(centre, corner, 0, across.back().orbit).back().pairs[0]));
    for (std::size_t i = 0; i < across.size(); i += 13) ends.push_back(across[i]);
    seen.insert(seen.end(), across.begin(), across.end());

    // How near the fourth, how far the others, how many at the point of accumulation
    for (const StabilityAt& at : seen) {
      const Estimate near = from_one(at.pairs[0]), next = from_one(at.pairs[1]);
      fourth = larger(fourth, near), share = larger(share, quotient(near, next));
      spectra.add({{"centre", "site or bond", name_of(centre)},
                   {"omega", "frequency", at.spot.omega_b},
                   {"s", "anharmonicity of the well", at.spot.s},
                   {"fourth", "distance of the fourth multiplier from +1", near},
                   {"fifth", "distance of the fifth multiplier from +1", next},
                   {"others", "largest modulus from the fifth multiplier on, minus one",
                    excess(at.pairs, 1), "", "difference of two resolutions, relative to one"},
                   {"off_circle", others_off_circle, off_circle(at.pairs)}});
    }
    for (const StabilityAt& at : ends)
      edges.add({{"centre", "site or bond", name_of(centre)},
                 {"omega", "frequency", at.spot.omega_b},
                 {"s", "anharmonicity of the well", at.spot.s},
                 {"added", "multipliers that ten more sites add at the point of accumulation",
                  added_at_edge(centre, at.spot, at.orbit, at.pairs)}});
  }
  report.facts.add("spectrum_fourth", fourth);
  report.facts.add("spectrum_share_of_fifth", share);
}

/**
## The pinning mode and the gradient (figure 13)

The breather starts from rest, so the eigenvectors of $\lambda$ and $1/\lambda$ have the same displacements at $t = 0$
and opposite velocities. We compare these displacements with $y_{n+1}(0)-y_{n-1}(0)$, both of length one. The article
calls the two very close; the angle between them is about ten degrees.

![Pinning mode and discrete gradient. Drawn by fig13_pinning_mode.gp: `mode` and `gradient` against `n`, from
`mode_bond` and `mode_site`.](fig:13)

| cosine of the angle | around a bond | around a site |
|---|---|---|
| of mode and gradient | [0.979741 ± 5e-15](num:sec33_floquet.cosine_bond) | [0.987389 ± 3e-15](num:sec33_floquet.cosine_site) | */
void report_mode(Report& report) {
  for (Centre centre : both_centres) {
    const auto problem = problem_at(centre, {});
    const Orbit<double> orbit = find_breather(problem);
    Vector<double> g = gradient(orbit.start.y);
    g /= g.norm();

    // The angle, in two precisions; the sign of an eigenvector is arbitrary and is chosen as that of the gradient
    Vector<double> mode = stability<Wide>(problem, orbit).mode;
    const double coarse = alignment(stability<double>(problem, orbit).mode, g);
    report.facts.add("cosine_" + name_of(centre), compare(coarse, alignment(mode, g)));
    if (mode.dot(g) < 0) mode = -mode;

    // Both vectors, bead by bead
    Table& table =
        report.table("mode_" + name_of(centre),
                     {count("n", "site"), number("mode", "pinning mode, positions at t = 0"),
                      number("gradient", "discrete gradient of the breather, normalised"),
                      number("difference", "mode minus gradient")});
    for (Eigen::Index i = 0; i < g.size(); ++i)
      table.add(
          {site_number(std::size_t(i), std::size_t(g.size())), mode[i], g[i], mode[i] - g[i]});
  }
}

/**
## Towards $\omega_b = 1$

The site-centred breather of the DpS equation, of frequency $\mu$, is unstable at a rate of $0.00156\,\mu$ in slow time
(`sec33_dps_stability`). By Eq. (20) a breather of the chain of size $\epsilon$ has
$\omega_b-1 = \epsilon^{1/2}/(2\tau_0)$. So if the same holds for the chain, $\ln\lambda/T_b = 0.00156\,(\omega_b-1)$:
weaker by $O(\epsilon^{1/2})$, as the article says. The exponent is taken between $\omega_b-1 = 2\cdot10^{-4}$ and
$10^{-4}$ in extended precision, with the change from the pair before as its error. The limit is approached slowly: at
$\omega_b = 1.1$ the rate is only a quarter of its limit.

| quantity | article | here |
|---|---|---|
| rate $\propto\epsilon^p$, exponent $p$ | 1/2 | [0.497 ± 0.004](num:floquet.weaker) |
| limit of rate over $\omega_b-1$ | | [0.00155770 ± 3e-8](num:sec33_floquet.slow_rate_limit) |
| the same by the DpS equation | | [0.00155771 ± 9e-15](num:sec33_floquet.dps_rate) | */
Estimate site_growth_rate(double beyond_one) {
  // ln(lambda) / T_b, since sinh(ln(lambda) / 2) is the root of kappa
  const auto problem = problem_at(Centre::site, {1 + beyond_one, 0});
  const Orbit<double> orbit = find_breather(problem);
  const Estimate kappa = stability<Wide>(problem, orbit).kappa();
  const double root = std::sqrt(kappa.value);
  return {2 * std::asinh(root) / orbit.period(), kappa.error / root / orbit.period()};
}

void report_slow(Report& report) {
  const double beyond[] = {4e-4, 2e-4, 1e-4};
  std::array<Estimate, 3> rate;
  parallel_for(rate.size(), [&](std::size_t k) { rate[k] = site_growth_rate(beyond[k]); });

  // The exponent in eps, and what the rate over omega_b - 1 tends to, linearly
  const auto exponent = [&](std::size_t k) {
    const double ratio = std::log(breather_eps(1 + beyond[k]) / breather_eps(1 + beyond[k + 1]));
    return Estimate{
        std::log(rate[k].value / rate[k + 1].value) / ratio,
        (rate[k].error / rate[k].value + rate[k + 1].error / rate[k + 1].value) / ratio};
  };
  const auto limit = [&](std::size_t k) {
    return 2 * rate[k + 1].value / beyond[k + 1] - rate[k].value / beyond[k];
  };
  report.facts.add("rate_exponent", compare(exponent(0), exponent(1)));
  report.facts.add("slow_rate_limit", compare(limit(0), limit(1)));
  report.facts.add("dps_rate",
                   margin_of<long double>(Centre::site, 1, sites_of(Centre::site)).exponent);
}

/**
## Differences and limits

We do not reproduce the printed exchanges; the article's result at $s = 0$ is confirmed. All this holds at
$\omega_b = 1.1$ in quartic wells and is no general rule: in the linear well the two breathers exchange their stability
six times between $\omega_b = 1.003$ and 2, and next to an exchange a third breather, centred on neither site nor bond,
may exist (`sec33_between`). Why the potential turns upside down just there is not known. */
void reproduce(Report& report) {
  report.output.note("tolerance",
                     "flow to 128 and 2048 roundings of the type, unless a table says else");
  report.output.note("seed", "1 to 8 for the noise on the matrix");
  report_spectrum(report);
  report_lines(report, report_wells(report));
  report_harmonic(report);
  const std::array<Exchange, 2> found = report_exchange(report);
  report_threshold(report, found);
  report_matrix_errors(report, std::abs(found[0].slope));
  report_strength(report);
  report_slow(report);
  report_mode(report);
}

/**
## Statement by statement

<!-- statements -->
| statement | printed | here | verdict |
|---|---|---|---|
| `floquet.spectrum`: four multipliers near +1 and the rest on the unit circle accumulating at exp(+-2 pi i/omega_b) | structure | spectra.fourth (centre = bond, omega = 1.975): 0.0008154 < 0.01 (the closest of 1028) | holds |
| `floquet.s0_bond`: anharmonicity at which the bond-centred breather loses stability (omega_b = 1.1) | 0.26 | 0.1525 | discrepant |
| `floquet.s0_site`: anharmonicity above which the site-centred breather is stable (omega_b = 1.1) | 0.05 | 0.1525 | discrepant |
| `floquet.harmonic`: at s = 0 and omega_b = 1.1 the site-centred breather is weakly unstable and the bond-centred one stable | verdict | harmonic.kappa (centre = site): 0 < 1.148e-08 (the closest of 4) | holds |
| `floquet.instability_size`: unstable multipliers of section 3.3 (omega_b = 1.1) exceed 1 by less than | 1e-3 | site_against_s.largest_modulus (s = -1): 0.0005839 < 0.001 (the closest of 174) | holds |
| `pinning.gradient`: pinning mode is close to the discrete gradient for both breathers | very close | 0.9797 | quantified |
| `outlook.sign_of_s`: stability depends on the strength (and sign) of the anharmonicity | depends | site_against_s.kappa (s = 0.1): 0 < 3.959e-09 (the closest of 180) | holds |
| `floquet.weaker`: the instability is O(epsilon^(1/2)) times weaker in the chain than in the DpS equation | 0.5 | 0.50 | reproduced |
<!-- /statements -->

## Try it

**To change it.** Another line through frequencies and wells is a vector of `Spot` for `along`; another well, contact or
mass is set where `problem_at` makes the chain (exchange.hpp), whose tests then fail. `report_exchange` seeks the
exchange between $s = 0.1$ and 0.2 and stops if there is none.

1. *Easy.* At a slightly higher frequency the exchange lies elsewhere:
   `build/bin/sec33_floquet exchange --centre bond --omega 1.15` gives `s0` = 0.018781. Hint: the curves of exchange
   (`sec33_between`) are slanted, and cross $s = 0$ at six frequencies. To which of them does this curve lead?
2. *Harder.* Which breather is stable can be decided without multipliers.
   `build/bin/sec32_barrier barrier --omega 1.1 --s 0.05` gives `equal_area` = -1.58248e-13, and
   `build/bin/sec32_barrier barrier --omega 1.1 --s 0.26` gives `equal_area` = 1.66492e-13. Hint: at equal action the
   breather of higher energy is the stable one here, because the effective mass is negative (`sec33_mobility`). Does
   this agree with $\kappa$, and with the printed exchanges?
`sec33_floquet multipliers` prints all multipliers of one breather (multipliers.hpp), `sec33_floquet exchange` the wells
in which its pinning pair passes $+1$ (exchanges.hpp). */
int main(int argc, char** argv) {
  return run({"sec33_floquet", "3.3", "Stability of the breathers (section 3.3)", reproduce,
              commands<Multipliers, Exchanges>()},
             argc, argv);
}
