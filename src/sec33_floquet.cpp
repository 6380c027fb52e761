/**
# 3.3 Stability of the breathers

A breather is stable if small changes stay small. Section 3.3 of James, Kevrekidis and Cuevas
(Physica D 251, 2013) computes the Floquet multipliers of both breathers and finds four of them so
close to $+1$ that the breathers are almost free to move. Which of the two is stable depends on the
anharmonicity $s$ of the well: at some $s_0$ they change places.

        |lambda|                                  argument
           |  \\  unstable                             |        _____  stable
         1 |    \\____________                       0 |_______/
           |    /                                      |       \\_____
           +-------|---------- s                       +------|------ s
                  s_0                                        s_0

The article prints $s_0 \approx 0.26$ around a bond and $0.05$ around a site. We find one number for
both, up to the seventh digit, and between the two a breather that sits nowhere in particular. */

/**
What is claimed, with the identifiers under which the answers are recorded:

- four multipliers near $+1$, the others on the unit circle, accumulating at
  $e^{\pm 2\pi i/\omega_b}$ (`floquet.spectrum`);
- the exchange at $\omega_b = 1.1$ (`floquet.s0_bond`, `floquet.s0_site`);
- at $s = 0$ and $\omega_b = 1.1$ the site-centred breather is weakly unstable, the bond-centred one
  stable (`floquet.harmonic`);
- unstable multipliers exceed one by less than $10^{-3}$ (`floquet.instability_size`);
- the pinning mode is very close to the discrete gradient (`pinning.gradient`). */
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "lattice/numbers/line_fit.hpp"
#include "lattice/numbers/parallel.hpp"
#include "lattice/numbers/random.hpp"
#include "lattice/orbits/exchange.hpp"
#include "lattice/report/program.hpp"
#include "lattice/stepping/integrate.hpp"
#include "lattice/stepping/reference.hpp"

using namespace lattice;

/**
## Model and method

The chain is that of Eqs. (6) and (10), the breathers those of section 3.2. A pair of multipliers
$\lambda, 1/\lambda$ is one number
$$\kappa = \tfrac14\Bigl(\lambda+\frac1\lambda-2\Bigr),$$
an eigenvalue of an $N\times N$ matrix made of half a period of the linearised flow, from which the pair
of the phase is removed (floquet.hpp). The pair is unstable where $\kappa > 0$, and
$\ln\lambda \simeq 2\sqrt\kappa$ there.

| article | program | meaning |
|---|---|---|
| $\omega_b$, $s$ | `omega`, `s` | frequency and anharmonicity |
| $\lambda$ | `multiplier` | Floquet multiplier |
| $s_0^b$, $s_0^s$ | `exchange` | where $\kappa$ of the pinning pair changes its sign |
| $g_n$ | `gradient` | discrete gradient, here of length one |

Chains are long enough when the missing bead would be pushed less than rounding: 21 or 22 sites. The
article's 31 and 32 are used for the whole spectrum. */
constexpr double omega_main = 1.1;

/**
## All multipliers at $\omega_b = 1.1$

Of the whole spectrum we ask three things. Four multipliers lie near $+1$: the fourth is at a distance
of [](num:sec33_floquet.fourth_distance), the fifth at [](num:sec33_floquet.fifth_distance). No other pair
leaves the unit circle by more than its error. And the others accumulate at $e^{\pm2\pi i/\omega_b}$:
ten more sites add twenty multipliers there, within $10^{-9}$, and nowhere else. */
struct Census {
  double fourth = 0, fifth = 0;
  bool others_stable = true;
  int at_edge = 0;
};

Census census(const Spectrum& all, double omega) {
  Census c{std::abs(multiplier(all.pairs[0].kappa, 1) - 1.0),
           std::abs(multiplier(all.pairs[1].kappa, 1) - 1.0)};
  const double edge = -std::pow(std::sin(circle_ratio<double>() / omega), 2);
  for (std::size_t k = 1; k < all.pairs.size(); ++k) {
    c.others_stable = c.others_stable && !all.pairs[k].is_unstable();
    c.at_edge += std::abs(all.pairs[k].kappa - edge) < 1e-9 ? 2 : 0;
  }
  return c;
}

/**
The table holds the multipliers of both breathers on the article's chains, with the two of the phase,
which are exact. */
void add_multipliers(Table& table, std::int64_t bond, const Spectrum& all) {
  const auto add = [&](std::complex<double> z, double error) {
    table.add({bond, z.real(), z.imag(), std::abs(z), std::arg(z), error});
  };
  for (int k = 0; k < 2; ++k) add(1, 0);
  for (const Pair& pair : all.pairs)
    for (int sign : {1, -1}) add(multiplier(pair.kappa, sign), pair.multiplier_error());
}

void report_spectrum(Report& report) {
  Table table{{count("bond", "1 around a bond, 0 around a site"), number("real", "real part"),
               number("imag", "imaginary part"), number("modulus", "its modulus"),
               number("argument", "its argument", "rad"),
               number("error", "of the multiplier, from two tolerances")}};
  bool holds = true;
  for (Centre centre : both_centres) {
    std::array<Census, 2> found;
    for (std::size_t more : {0U, 10U}) {
      const auto problem = problem_at(centre, {}, 10 + more);
      const Spectrum all = spectrum<double>(problem, find_breather(problem));
      found[more / 10] = census(all, omega_main);
      if (more == 0) add_multipliers(table, centre == Centre::bond, all);
    }
    const Census &a = found[0], &b = found[1];
    holds = holds && a.fourth < 0.01 && a.fifth > 0.1 && a.others_stable && b.others_stable &&
            b.at_edge - a.at_edge == 20;
    if (centre == Centre::bond) continue;
    report.facts.add("fourth_distance", compare(b.fourth, a.fourth));
    report.facts.add("fifth_distance", compare(b.fifth, a.fifth));
    report.facts.add("at_edge", exact(a.at_edge));
  }
  report.output.add("multipliers", std::move(table));
  report.results.claim("floquet.spectrum", holds);
}

/**
## What a defective $+1$ does to a verdict

Suppose that we had read the multipliers off the monodromy matrix $M$ of the bond-centred breather,
which is stable. We add noise of size $\delta$ to an accurate $M$ and look at the four eigenvalues next
to $+1$. Their moduli leave one like $\delta^{1/2}$: the fitted exponent is
[](num:sec33_floquet.defect_slope). Only at $\delta$ below
[](num:sec33_floquet.harmless_noise) do all eight samples call it stable to the digits of the pair itself,
$|\lambda-1|\simeq 2\sqrt{-\kappa}$. The symmetric function of the four from which we take $\kappa$ moves
with the exponent [](num:sec33_floquet.kappa_slope). */
struct Damage {
  double spread = 0;  ///< largest | |lambda| - 1 | of the four
  double kappa = 0;   ///< change of kappa
};

Damage damage(const Matrix<double>& map, double kappa) {
  const Eigen::EigenSolver<Matrix<double>> solver(map, false);
  Damage d;
  for (Eigen::Index i = 0; i < map.rows(); ++i)
    if (const std::complex<double> z = solver.eigenvalues()[i]; std::abs(z - 1.0) < 0.1)
      d.spread = std::max(d.spread, std::abs(std::abs(z) - 1));
  d.kappa = std::abs(quadruplet_kappa(map) - kappa);
  return d;
}

Matrix<double> noisy(Matrix<double> map, double delta, unsigned long seed) {
  Random random(seed);
  for (Eigen::Index i = 0; i < map.size(); ++i) map.data()[i] += delta * random.uniform(-1, 1);
  return map;
}

/**
The noise has recorded seeds, 1 to 8, and we take geometric means. A second series is no model: the
same matrix from our integrator with its tolerance loosened, and the largest change of an entry for
$\delta$. */
void report_defect(Report& report) {
  const auto problem = problem_at(Centre::bond, {});
  const Orbit<double> orbit = find_breather(problem);
  const double kappa = spectrum<double>(problem, orbit).kappa().value;
  const Matrix<double> map = monodromy(problem.chain, orbit.start, orbit.period());
  Table table{{label("source", "noise, or a loosened tolerance"),
               number("delta", "size of the change of the matrix"),
               number("spread", "largest distance of a modulus from one, among the four"),
               number("kappa_change", "change of kappa")}};
  std::vector<double> sizes, spreads, changes;
  double harmless = 0;
  for (double delta = 1e-5; delta > 5e-12; delta /= 10) {
    double spread = 0, change = 0, worst = 0;
    for (unsigned long seed = 1; seed <= 8; ++seed) {
      const Damage d = damage(noisy(map, delta, seed), kappa);
      spread += std::log(d.spread) / 8, change += std::log(d.kappa) / 8;
      worst = std::max(worst, d.spread);
    }
    sizes.push_back(std::log(delta)), spreads.push_back(spread), changes.push_back(change);
    if (worst < 0.01 * 2 * std::sqrt(-kappa)) harmless = std::max(harmless, delta);
    table.add({std::string("noise"), delta, std::exp(spread), std::exp(change)});
  }
  report.facts.add("defect_slope", fit_line(sizes, spreads).estimate());
  report.facts.add("kappa_slope", fit_line(sizes, changes).estimate());
  report.facts.add("harmless_noise", exact(harmless));
  /**
  The loosened tolerances follow in the same table. */
  for (double tolerance = 1e-4; tolerance > 1e-13; tolerance /= 10) {
    Landing<double> loose;
    loose.tolerance = tolerance;
    const Matrix<double> other = monodromy(problem.chain, orbit.start, orbit.period(), loose);
    const Damage d = damage(other, kappa);
    table.add({std::string("tolerance"), sup<double>((other - map).reshaped()), d.spread, d.kappa});
  }
  report.output.add("defect", std::move(table));
}

/**
## The quadruplet against $s$ (figures 11 and 12)

We follow each breather from the linear well to both ends of $-1 \le s \le 1$.

![Arguments and moduli of the four multipliers near one, bond-centred.](fig:11)
![The same around a site.](fig:12) */
std::vector<Spectrum> along_wells(Centre centre, const std::vector<double>& wells) {
  std::vector<Orbit<double>> orbits(wells.size());
  std::vector<Spectrum> out(wells.size());
  const std::size_t middle = wells.size() / 2;
  orbits[middle] = find_breather(problem_at(centre, {omega_main, wells[middle]}));
  for (std::size_t k = middle + 1; k < wells.size(); ++k)
    orbits[k] = follow(problem_at(centre, {omega_main, wells[k]}), orbits[k - 1]);
  for (std::size_t k = middle; k-- > 0;)
    orbits[k] = follow(problem_at(centre, {omega_main, wells[k]}), orbits[k + 1]);
  parallel_for(wells.size(), [&](std::size_t k) {
    out[k] = spectrum<double>(problem_at(centre, {omega_main, wells[k]}), orbits[k]);
  });
  return out;
}

/**
A pair on the circle has modulus one exactly, and one on the axis the argument zero: which of the two it
is, is the sign of $\kappa$. The columns are written with formulas that keep all digits of a small
$\kappa$. */
Table quadruplet_table(const std::vector<double>& wells, const std::vector<Spectrum>& all) {
  Table table{{number("s", "anharmonicity of the well"),
               number("kappa", "(lambda + 1/lambda - 2) / 4 of the pinning pair"),
               number("kappa_error", "from two tolerances, against the neighbouring rows"),
               number("argument", "of the multiplier in the upper half plane", "rad"),
               number("argument_below", "of its partner", "rad"),
               number("excess", "modulus of the larger multiplier minus one"),
               number("excess_below", "modulus of the smaller multiplier minus one"),
               number("multiplier_error", "of either multiplier")}};
  for (std::size_t k = 0; k < wells.size(); ++k) {
    const Estimate kappa = all[k].kappa();
    const double angle = 2 * std::asin(std::sqrt(std::max(0.0, -kappa.value)));
    const double rate = 2 * std::asinh(std::sqrt(std::max(0.0, kappa.value)));
    table.add({wells[k], kappa.value, kappa.error, angle, -angle, std::expm1(rate),
               std::expm1(-rate), all[k].pairs.front().multiplier_error()});
  }
  return table;
}

/**
The largest instability of the sweep answers the article's closing remark; around a site it is
[](num:sec33_floquet.largest_excess). The error bar decides what may be said at $s = 0$: $\kappa$ is
[](num:sec33_floquet.kappa_site) around a site and [](num:sec33_floquet.kappa_bond) around a bond, so that
the article's verdict stands, with a multiplier that exceeds one by
[](num:sec33_floquet.excess_site). */
void report_wells(Report& report) {
  std::vector<double> wells;
  for (int steps = report.quick ? 4 : 40, k = -steps; k <= steps; ++k)
    wells.push_back(double(k) / steps);
  Estimate largest{};
  bool others_stable = true;
  for (Centre centre : both_centres) {
    const auto all = along_wells(centre, wells);
    for (const Spectrum& one : all) {
      const Pair& pair = one.pairs.front();
      others_stable = others_stable && census(one, omega_main).others_stable;
      if (const double excess = std::abs(multiplier(pair.kappa, 1)) - 1; excess > largest.value)
        largest = {excess, pair.multiplier_error()};
    }
    report.output.add(centre == Centre::bond ? "bond_against_s" : "site_against_s",
                      quadruplet_table(wells, all));
  }
  report.facts.add("largest_excess", largest);
  report.facts.add("others_stable", exact(others_stable));
  report.results.claim("floquet.instability_size", largest.value + largest.error < 1e-3);
}

/**
The verdict at $s = 0$ is taken in the wider type, where an error of $\kappa$ is ten orders below the
effect. As a check by another route the pair is also taken from the block of a symmetry. */
void report_harmonic(Report& report) {
  std::array<Estimate, 2> kappa;
  for (std::size_t k : {0U, 1U}) {
    const auto problem = problem_at(both_centres[k], {});
    const Orbit<double> orbit = find_breather(problem);
    kappa[k] = spectrum<Wide>(problem, orbit).kappa();
    const std::string name = k ? "bond" : "site";
    report.facts.add("kappa_" + name, kappa[k]);
    const Matrix<double> half = monodromy(problem.chain, orbit.start, orbit.period() / 2);
    report.facts.add("kappa_by_symmetry_" + name,
                     compare(kappa[k].value, pinning_by_symmetry(half, both_centres[k])));
  }
  const Pair site{{kappa[0].value, 0}, kappa[0].error};
  report.facts.add("excess_site", {multiplier(site.kappa, 1).real() - 1, site.multiplier_error()});
  report.facts.add("angle_bond", {2 * std::asin(std::sqrt(-kappa[1].value)),
                                  kappa[1].error / std::sqrt(-kappa[1].value)});
  report.results.claim("floquet.harmonic",
                       kappa[0].value > kappa[0].error && kappa[1].value < -kappa[1].error);
}

/**
At $\omega_b = 1.1$ the two exchanges are [](num:floquet.s0_site) around a site and
[](num:floquet.s0_bond) around a bond. They differ by [](num:sec33_floquet.exchange_gap), and in
between both breathers are stable. */
void report_exchange(Report& report) {
  std::array<Exchange, 2> found;
  parallel_for(2, [&](std::size_t k) {
    const Orbit<double> near = find_breather(problem_at(both_centres[k], {}));
    found[k] = exchange<Wide>(both_centres[k], Cut{}, 0.1, 0.2, near);
  });
  report.results.add("floquet.s0_site", found[0].place);
  report.results.add("floquet.s0_bond", found[1].place);
  report.facts.add("exchange_gap", {found[1].place.value - found[0].place.value,
                                    found[0].place.error + found[1].place.error});
  report.facts.add("exchange_slope", compare(std::abs(found[0].slope), std::abs(found[1].slope)));
}

/**
## What prints 0.26 and 0.05

Near the exchange $\kappa$ grows by [](num:sec33_floquet.exchange_slope) per unit of $s$. An error of
$10^{-8}$ in the monodromy matrix is then as good as a change of $s$ by a tenth. We compute the matrix as
one usually does, by an adaptive Runge-Kutta method that knows of no switchings, for the variational
equations or for difference quotients, around accurate breathers, and look where the
quadruplet says that the stability changes. */
struct Trial {
  std::string method;
  double setting;  ///< tolerance, relative increment or steps a period
  std::function<Matrix<double>(const BreatherProblem<double>&, const Orbit<double>&)> map;
};

Matrix<double> variational(const BreatherProblem<double>& problem, const Orbit<double>& orbit,
                           const Tolerance& tolerance) {
  const std::size_t n = problem.chain.sites, m = 2 * n;
  std::vector<double> z(orbit.start.y);
  z.resize(m + m * m, 0);
  for (std::size_t i = 0; i < m; ++i) z[m + i * m + i] = 1;
  const auto rhs = [&](double, const double* x, double* dx) {
    Window all{0, n};
    accelerate(problem.chain, x, dx + n, all);
    const Hessian<double> h = linearise(problem.chain, std::vector<double>(x, x + n));
    for (std::size_t c = 0; c <= m; ++c) std::copy_n(x + c * m + n, n, dx + c * m);
    for (std::size_t c = 1; c <= m; ++c)
      for (std::size_t i = 0; i < n; ++i) {
        const double* y = x + c * m;
        dx[c * m + n + i] = -h.diagonal[i] * y[i] - (i > 0 ? h.off[i - 1] * y[i - 1] : 0) -
                            (i + 1 < n ? h.off[i] * y[i + 1] : 0);
      }
  };
  Reference reference(rhs, m + m * m, tolerance);
  double t = 0;
  reference.advance(t, orbit.period(), z);
  return Eigen::Map<Matrix<double>>(z.data() + m, Eigen::Index(m), Eigen::Index(m));
}

/**
Difference quotients need nothing but the flow. They are central, with an increment relative to the
amplitude. */
Matrix<double> differences(const Orbit<double>& orbit, double increment,
                           const std::function<void(State<double>&)>& carry) {
  const std::size_t m = 2 * orbit.start.y.size();
  const double h = increment * orbit.amplitude;
  Matrix<double> map(m, m);
  for (std::size_t k = 0; k < m; ++k) {
    State<double> up = orbit.start, down = orbit.start;
    entry(up, k) += h;
    entry(down, k) -= h;
    carry(up);
    carry(down);
    for (std::size_t i = 0; i < m; ++i)
      map(Eigen::Index(i), Eigen::Index(k)) = (entry(up, i) - entry(down, i)) / (2 * h);
  }
  return map;
}

/**
Three families of trials: a tolerance for the variational equations, an increment for the differences of
a well resolved flow, and the steps of a symplectic integrator of order four. */
std::vector<Trial> all_trials() {
  using P = BreatherProblem<double>;
  using O = Orbit<double>;
  std::vector<Trial> out;
  for (double tolerance : {1e-7, 1e-8, 1e-9, 1e-10, 1e-11})
    out.push_back({"variational, rk8pd, tolerance", tolerance, [=](const P& p, const O& o) {
                     return variational(p, o, {tolerance, tolerance, gsl_odeiv2_step_rk8pd});
                   }});
  for (double increment : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6})
    out.push_back({"differences, rk8pd, increment", increment, [=](const P& p, const O& o) {
                     return differences(o, increment, [&](State<double>& z) {
                       evolve_reference(p.chain, z, o.period(), Tolerance(1e-13));
                     });
                   }});
  for (std::size_t steps : {50U, 100U, 200U, 400U})
    out.push_back({"differences, symplectic, steps", double(steps), [=](const P& p, const O& o) {
                     return differences(o, 1e-5, [&](State<double>& z) {
                       Window all{0, p.chain.sites};
                       Splitting{blanes_moan_4(), 1}.advance(p.chain, z, all,
                                                             o.period() / double(steps), steps);
                     });
                   }});
  return out;
}

/**
In each trial $\kappa$ is computed on a few wells, and its zero is read off between them. Where there
is no zero between $s=-1$ and $1$ the entry is empty. The printed pair belongs to errors of some
$10^{-8}$: the trials with a tolerance of $10^{-8}$ to $10^{-9}$ scatter over the whole range. */
void report_printed(Report& report) {
  std::vector<Trial> trials = all_trials();
  if (report.quick) trials.resize(3);
  const int steps = report.quick ? 2 : 5;
  std::array<std::vector<Orbit<double>>, 2> orbits;
  const auto spot = [&](int k) { return Spot{omega_main, double(k) / steps - 1}; };
  const auto short_chain = [&](std::size_t c, int k) {
    return breather_problem(both_centres[c], omega_main, spot(k).s, c ? 16 : 15);
  };
  for (std::size_t c : {0U, 1U})
    for (int k = 0; k <= 2 * steps; ++k) orbits[c].push_back(find_breather(short_chain(c, k)));
  std::vector<std::array<double, 2>> zero(trials.size()), error(trials.size());
  parallel_for(2 * trials.size(), [&](std::size_t i) {
    const std::size_t c = i % 2, t = i / 2;
    double last = 0, found = std::numeric_limits<double>::quiet_NaN();
    for (int k = 0; k <= 2 * steps; ++k) {
      const auto problem = short_chain(c, k);
      const Matrix<double> map = trials[t].map(problem, orbits[c][std::size_t(k)]);
      const double kappa = quadruplet_kappa(map);
      if (k > 0 && last * kappa < 0 && std::isnan(found))
        found = spot(k).s - kappa / (kappa - last) / steps;
      last = kappa;
      if (k == steps)
        error[t][c] = sup<double>((map - monodromy(problem.chain, orbits[c][std::size_t(k)].start,
                                                   orbits[c][std::size_t(k)].period()))
                                      .reshaped());
    }
    zero[t][c] = found;
  });
  /**
  One row for each trial. */
  Table table{{label("method", "how the matrix is computed, and what the setting means"),
               number("setting", "tolerance, increment or number of steps"),
               number("matrix_error", "largest error of an entry at s = 0, either centre"),
               number("s0_site", "exchange that it gives around a site; nan where none in [-1, 1]"),
               number("s0_bond", "the same around a bond")}};
  for (std::size_t t = 0; t < trials.size(); ++t)
    table.add({trials[t].method, trials[t].setting, std::max(error[t][0], error[t][1]), zero[t][0],
               zero[t][1]});
  report.output.add("printed_trials", std::move(table));
}

/**
## The pinning mode is the gradient (figure 13)

The eigenvector of the pinning pair, with vanishing velocities, against $y_{n+1}(0)-y_{n-1}(0)$, both of
length one: the article's $g_n$ divides by the sum of the squares, but an energy of $c^2/2$ needs its
square root. The cosine of the angle between them is [](num:sec33_floquet.cosine_bond) around a bond and
[](num:sec33_floquet.cosine_site) around a site.

![Pinning mode and discrete gradient.](fig:13) */
void report_mode(Report& report) {
  std::array<Estimate, 2> cosine;
  for (std::size_t k : {0U, 1U}) {
    const auto problem = problem_at(both_centres[k], {});
    const Orbit<double> orbit = find_breather(problem);
    Vector<double> g = gradient(orbit.start.y);
    g /= g.norm();
    Vector<double> mode = spectrum<Wide>(problem, orbit).mode;
    const double coarse = alignment(spectrum<double>(problem, orbit).mode, g);
    cosine[k] = compare(coarse, alignment(mode, g));
    if (mode.dot(g) < 0) mode = -mode;
    Table table{{count("n", "site"), number("mode", "pinning mode, positions at t = 0"),
                 number("gradient", "discrete gradient, of length one"),
                 number("difference", "mode minus gradient")}};
    for (Eigen::Index i = 0; i < mode.size(); ++i)
      table.add({std::int64_t(site_number(std::size_t(i), std::size_t(mode.size()))), mode[i], g[i],
                 mode[i] - g[i]});
    report.output.add(k ? "mode_bond" : "mode_site", std::move(table));
    report.facts.add(k ? "cosine_bond" : "cosine_site", cosine[k]);
  }
  report.results.add("pinning.gradient", cosine[0].value < cosine[1].value ? cosine[0] : cosine[1]);
}

/**
## Your own breather

`sec33_floquet multipliers --centre site --omega 1.1` prints all multipliers with their errors, those
next to $+1$ first, and `sec33_floquet exchange --centre bond` where the stability changes. */
struct Options {
  std::string centre = "site";
  double omega = omega_main, s = 0;
  std::size_t sites = 0;
  Centre kind() const { return centre == "site" ? Centre::site : Centre::bond; }
};

Table multipliers_command(const Options& options) {
  if (options.sites && !fits(options.kind(), options.sites))
    throw UsageError("--sites: " + std::to_string(options.sites) + " does not fit --centre " +
                     options.centre + " (allowed: " + (options.centre == "site" ? "odd" : "even") +
                     " numbers)");
  Table raw{{count("bond", ""), number("real", "real part"), number("imag", "imaginary part"),
             number("modulus", "its modulus"), number("argument", "its argument", "rad"),
             number("error", "of the multiplier, from two tolerances")}};
  try {
    const Fitted found = fit_chain(options.kind(), options.omega, options.s, options.sites,
                                   sites_of(options.kind()), 1e-17, Phase::compressed);
    add_multipliers(raw, 0, spectrum<Wide>(found.problem, found.orbit));
  } catch (const ShortChain& error) {
    throw UsageError("--sites: " + std::to_string(options.sites) +
                     " cannot hold this breather's tail (allowed: " + std::to_string(error.needed) +
                     " or more)");
  }
  Table table{{raw.columns.begin() + 1, raw.columns.end()}};
  for (auto& row : raw.rows) table.add({row.begin() + 1, row.end()});
  return table;
}

/**
All exchanges between $s=-1$ and $1$ are printed, the one nearest to the linear well first. */
Table exchange_command(const Options& options) {
  const Centre centre = options.kind();
  const auto start = problem_at(centre, {options.omega, 0});
  std::vector<Estimate> found;
  for (int side : {1, -1}) {
    Orbit<double> orbit = find_breather(start);
    double last = quick_kappa(centre, {options.omega, 0}, orbit);
    for (int k = 1; k <= 20; ++k) {
      const double s = side * k / 20.0, before = side * (k - 1) / 20.0;
      const Orbit<double> near = orbit;
      double kappa = 0;
      try {
        kappa = quick_kappa(centre, {options.omega, s}, orbit);
      } catch (const NoConvergence&) {
        break;  // the family ends
      }
      if (last * kappa < 0)
        found.push_back(exchange<Wide>(centre, {true, options.omega}, std::min(s, before),
                                       std::max(s, before), near)
                            .place);
      last = kappa;
    }
  }
  if (found.empty())
    throw Failure("no exchange of stability between s = -1 and 1 at omega_b = " +
                  std::to_string(options.omega));
  std::sort(found.begin(), found.end(),
            [](auto a, auto b) { return std::abs(a.value) < std::abs(b.value); });
  Quantities q;
  for (std::size_t k = 0; k < found.size(); ++k)
    q.add(k ? "s0_" + std::to_string(k + 1) : "s0", found[k]);
  return q.table;
}

/**
## Differences and limits

The printed exchanges, 0.26 and 0.05, are discrepant, and the table `printed_trials` shows how matrices
that are wrong in the eighth digit produce anything of the kind. The verdict at $s = 0$ survives,
because there $\kappa$ is far enough from zero, but not as a rule: the two breathers change places
six times between $\omega_b = 1$ and 2. The chart follows each family in $s$ only until Newton's method
fails, which for soft wells is near the fold of the family.

## Extensions

- Follow the breather in between through the whole plane: where is it stable?
- The pairs beyond the first: is there a collision on the unit circle at higher frequencies?
- Does a kicked breather stop at the stable breather in between? */
int main(int argc, char** argv) {
  Program program({"sec33_floquet", "3.3", "Stability of the breathers (section 3.3)"}, argc, argv);
  Options options;
  const auto add_common = [&](CLI::App* app) {
    app->add_option("--centre", options.centre, "site or bond")
        ->check(CLI::IsMember({"site", "bond"}));
    app->add_option("--omega", options.omega, "frequency omega_b > 1")->check(in_range(1.0001, 3));
  };
  CLI::App* one = program.command("multipliers", "all Floquet multipliers of one breather",
                                  [&] { return multipliers_command(options); });
  add_common(one);
  one->add_option("--s", options.s, "anharmonicity of the well")->check(in_range(-10, 10));
  one->add_option("--sites", options.sites, "sites (default: as many as needed)")
      ->check(in_range(3, 1000));
  add_common(program.command("exchange", "anharmonicity at which the stability changes",
                             [&] { return exchange_command(options); }));
  program.everything = [&](Output& output) {
    output.note("tolerance", "flow to 128 and 2048 roundings of the type");
    output.note("seed", "1 to 8 for the noise on the matrix");
    Report report{output, program.quick};
    report_spectrum(report);
    report_defect(report);
    report_wells(report);
    report_harmonic(report);
    report_exchange(report);
    report_printed(report);
    report_mode(report);
    output.add("facts", report.facts.table);
    return report.results;
  };
  return program.run(argc, argv);
}
