/**
# 3.2 Static breathers of the chain

Does the chain have static breathers, and how accurately can they be computed? Section 3.2 of James, Kevrekidis and
Cuevas (Physica D 251, 2013) finds two families by Newton's method. We compute both with an event-driven integrator, to
rounding, and test each of the article's statements about them.

A breather is a time-periodic motion in which a few beads carry nearly all the energy and neighbours oscillate out of
phase, either around a *site*, one bead against both of its neighbours, or around a *bond*, two neighbours against each
other. The article says that an approximate profile is excellent at small amplitude; that the tails fall off
super-exponentially; that a breather looks the same after a hundred periods; that amplitude, energy and asymmetry grow
with the frequency; and that the energies of both kinds are indistinguishable.

![Bond-centred breathers, of the DpS equation and of the chain, and their quasi-continuum approximation. Drawn by
fig02_bond_centred.gp: the columns of `bond_profiles` against `n`.](fig:02)

## Model

The beads sit in the wells of Eq. (10), mostly linear ones ($s = 0$), and push on their neighbours, Eqs. (6) and (9):
$$\ddot y_n + y_n + s\,y_n^3 = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2},
  \qquad y_n(t+T_b) = y_n(t),\quad T_b = 2\pi/\omega_b,$$
with free ends, dimensionless. A breather starts from rest, so the positions $y_n(0)$ are the unknowns, and it is at
rest again after half a period. A reflection of the chain must also change the sign of all positions, $y_n \to -y_{-n}$:
contacts only push, and a reflection alone would turn every overlap into a gap. Around a bond the breather is its own
image, so the right half of the chain suffices, and its velocities must vanish after half a period. Around a site the
image is the breather half a period later. By time reversal image and breather meet at a quarter:
$$\dot y_n(T_b/2) = 0 \quad\text{(bond)},\qquad
  y_n+y_{-n} = 0,\quad \dot y_n-\dot y_{-n} = 0 \quad\text{at } t = T_b/4 \quad\text{(site)}.$$ */
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "commands/one_breather.hpp"
#include "lattice/diagnostics/observe.hpp"
#include "lattice/gsl/random.hpp"
#include "lattice/model/dps.hpp"
#include "lattice/numerics/parallel.hpp"
#include "lattice/standing/stationary.hpp"
#include "report/program.hpp"
#include "sec3/branches.hpp"

using namespace lattice;

/**
## The experiment

There are as many conditions $R(y) = 0$ as unknowns. The code computes the breather around a site at $\omega_b = 1.1$,
on 31 beads as in the article: a guess, a quarter of a period, and Newton's method, $y \leftarrow y - DR(y)^{-1}R(y)$.
The linearised equations of motion give $DR$: each column of `change` is the evolution of a small change of one
$y_k(0)$. `flow` takes steps of variable length and order, to a tolerance of 128 roundings relative to the largest bead,
and ends one at every *contact event*, the opening or closing of a contact (event_driven.hpp). */
using Index = Eigen::Index;
constexpr Index N = 31;
constexpr double omega_b = 1.1, T_b = 2 * std::numbers::pi / omega_b;
constexpr double s = 0;  // the linear well
const Chain chain{
    .sites = N, .well = Quartic{s}, .contact = Hertz{.floor = 0}};  // no faint contact is left out

/// The continuum limit of small breathers, Eqs. (18) to (20).
Vector<double> guess() {
  const double eps = std::pow(2 * tau_0() * (omega_b - 1), 2);  // tau_0 = 1.545, below Eq. (12)
  const auto g = [](double x) {
    const double c = std::cos(x / 3), c3 = c * c * c;
    return std::abs(x) < 1.5 * std::numbers::pi ? 0.027 * c3 * c3 : 0.0;  // (3/10)^3 cos^6(x/3)
  };
  Vector<double> y(N);
  for (Index i = 0; i < N; ++i) {
    const Index n = i - N / 2;
    y[i] = 2 * eps * (n % 2 == 0 ? 1 : -1) * (g(double(n) + 0.5) + g(double(n) - 0.5));
  }
  return y;
}

template <class T>
State<T> at_rest(const Vector<double>& y) {
  State<T> state{std::size_t(y.size())};
  for (std::size_t n = 0; n < state.y.size(); ++n) state.y[n] += T(y[Index(n)]);
  return state;
}

/// R(y), what must vanish after a quarter of the period, and DR(y).
std::pair<Vector<double>, Matrix<double>> conditions(const Vector<double>& y,
                                                     const EventTolerance<double>& tolerance) {
  State<double> state = at_rest<double>(y);
  Tangent<double> change(N, N);  // the changes of N positions, then of N velocities
  flow(chain, state, T_b / 4, tolerance, &change);  // throws unless it is accurate
  Vector<double> R(N);
  Matrix<double> DR(N, N);
  for (Index n = 0, image = N - 1; n < N; ++n, --image) {
    const bool right = n >= N / 2;
    R[n] = right ? state.y[n] + state.y[image] : state.v[n] - state.v[image];
    for (Index k = 0; k < N; ++k)
      DR(n, k) = right ? change(n, k) + change(image, k) : change(N + n, k) - change(N + image, k);
  }
  return {R, DR};
}

struct Breather {
  Vector<double> y;  // positions at t = 0
  History history;   // residual and step of each iteration, relative to the largest position
};

/// Newton's method, until rounding keeps the residual from falling further.
Breather breather(const EventTolerance<double>& tolerance) {
  Vector<double> y = guess(), before = y;
  History history;
  for (double last = HUGE_VAL; history.size() < 30;) {
    const auto [R, DR] = conditions(y, tolerance);
    const double residual = sup(R) / sup(y);
    // At rounding, once the residual no longer falls by a factor of four: return the better of the last two points
    const bool done = last <= 64 * tolerance.tolerance && residual >= last / 4;
    if (done && residual >= last) return {before, history};
    history.push_back({residual, 0});
    if (done) return {y, history};
    // DR step = R, each bead measured in its own size, since the tail falls double-exponentially
    const Sizes<double> sizes = problem_of(Centre::site, omega_b, s).sizes(y, true);
    const Vector<double> step = solve_scaled<double>(DR, R, sizes, 0);
    history.back().step = sup(step) / sup(y);
    before = y, last = residual, y -= step;
  }
  throw NewtonFailed("no breather at omega_b = 1.1", history);
}

/**
Everything is computed at two tolerances, 128 and 2048 roundings, or in two precisions, and the difference is the error.
The library's `newton` does the same operations for any chain, symmetry and precision; the run stops if the two
breathers differ by more than $10^{-13}$. It finds all other breathers of this chapter (`find_breather`), from the same
guess up to $\omega_b = 1.1$ and by continuation in the frequency beyond, and rejects a motion in which neighbours
oscillate in phase. An independent program (`tests/second`), with another integrator, finds the same breathers at 1.1,
and so does the Verlet method of sec1_the_chain.cpp, to four digits.

## Convergence of Newton's method

The article measures the change after a whole period, relative to the start, without using symmetry. For our breather,
found on a quarter of a period, this is [4e-14](statement:newton.residual).

Why are the article's numbers larger? We also solve its equations, the return of all positions and velocities after the
whole period: twice as many equations as unknowns, solved by least squares. They are ill-conditioned. Their least
singular vector is nearly a shift along the chain, the *pinning mode* of section 3.3, along which the method still steps
to and fro when the residual is at rounding. If steps along this mode are forbidden, the method cannot correct a
slightly shifted guess, and stops at a larger residual with a small last step. The printed residual lies between those
of these two iterations, which differ by a factor below six. So does the printed step, but there this says nothing: the
two are more than nine orders apart. The article does not say how it treated this mode, or how accurately it integrated.

| at $\omega_b = 1.1$, relative to the amplitude | residual | last step | next step | condition of $DR$ |
|---|---|---|---|---|
| article, after five steps | $1.5\cdot10^{-9}$ | $1.7\cdot10^{-11}$ | | |
| a quarter of the period, [4](cell:convergence/equations=quarter_period/steps) steps | [4e-14](statement:newton.residual) | [1.90e-9](cell:convergence/equations=quarter_period/step) | [7e-14](statement:newton.variation) | [22.3](cell:convergence/equations=quarter_period/condition) |
| the whole period, five steps | [3.61e-10](cell:convergence/equations=whole_period/steps=5/residual) | [5.64e-5](cell:step) | [1.00e-5](cell:next_step) | [1.75e6](cell:condition) |
| five steps, none along the pinning mode | [2.01e-9](cell:convergence/equations=without_pinning_mode/residual) | rounding | rounding | [1.77e6](cell:condition) |
| the whole period, ten steps | rounding | [2e-8](cell:convergence/equations=whole_period/steps=10/step) | [8e-9](cell:next_step) | [1.75e6](cell:condition) |

On a quarter of the period the next step, the last one that the code makes, is rounding: it lowers the residual no more.
*/
const auto tolerance_of = [](int coarser) { return rule<double>(coarser).events; };

/// What is known after some steps of Newton's method.
struct Iterate {
  double residual, step, next_step, condition;
};

/// The article's equations. Directions are left alone whose singular value is below `rank`, relative to the largest.
Iterate by_least_squares(int steps, double rank = 0, int coarser = 0) {
  Shooting<double> problem = problem_of(Centre::site, omega_b, s);
  problem.symmetry = returning(problem.chain.sites);
  Vector<double> y = guess();
  double last = std::nan("");
  for (int k = 0;; ++k) {
    const auto here = problem.evaluate(y, tolerance_of(coarser));
    const Vector<double> step =
        solve_scaled<double>(here.jacobian, here.residual, problem.sizes(y, false), rank);
    const double next = sup(step) / sup(y);
    if (k == steps)
      return {sup(here.residual) / sup(y), last, next, condition_of(here.jacobian).condition};
    last = next, y -= step;
  }
}

/// The article's residual, in precision T.
template <class T>
double distance_after_period(const Vector<double>& y) {
  const State<T> start = at_rest<T>(y);
  State<T> end = start;
  flow(chain, end, T(2) * pi<T>() / T(omega_b));
  return double(largest_difference(end, start) / largest(start));
}

Breather report_convergence(Report& report) {
  Table& table = report.table("convergence");
  const auto add = [&](const char* equations, std::size_t steps, const TwoRuns<Iterate>& runs) {
    const char* size = "of two resolutions, against the largest: the others are rounding";
    table.add({{"equations", "the time after which they are imposed, and how", equations},
               {"steps", "steps of Newton's method", steps},
               {"residual", "what is left over the amplitude",
                runs.of([](const Iterate& k) { return k.residual; }), "", size},
               {"step", "the last of these steps over the amplitude",
                runs.of([](const Iterate& k) { return k.step; }), "", size},
               {"next_step", "the step after them over the amplitude",
                runs.of([](const Iterate& k) { return k.next_step; }), "", size},
               {"condition", "condition number of the equations",
                runs.of([](const Iterate& k) { return k.condition; })}});
  };

  // A quarter of the period, at two tolerances and beside the library, and what a whole period leaves
  const Breather fine = breather(tolerance_of(0)), coarse = breather(tolerance_of(1));
  const Vector<double> other = find_breather(problem_of(Centre::site, omega_b, s)).x;
  if (!(sup<double>(fine.y - other) < 1e-13 * sup(fine.y)))
    throw Failure("the library finds a different breather");
  const std::size_t steps = fine.history.size() - 1;
  const auto iterate = [&](const Breather& b, double residual) {
    const std::size_t k = std::min(steps, b.history.size() - 1);
    return Iterate{residual, b.history.at(k - 1).step, b.history[k].step,
                   condition_of(conditions(b.y, {}).second).condition};
  };
  add("quarter_period", steps,
      {iterate(coarse, distance_after_period<double>(fine.y)),
       iterate(fine, distance_after_period<Wide>(fine.y))});

  // The whole period: five steps as in the article, with and without the pinning mode, and ten beside nine
  add("whole_period", 5, {by_least_squares(5, 0, 1), by_least_squares(5)});
  add("without_pinning_mode", 5, {by_least_squares(5, 1e-5, 1), by_least_squares(5, 1e-5)});
  add("whole_period", 10, {by_least_squares(9), by_least_squares(10)});
  return fine;
}

/**
## Profiles (figures 2 and 3)

How good is the approximation of Eqs. (18) to (20)? Both figures show the stationary DpS breather, the small-amplitude
limit, and the breathers of the chain at $\omega_b = 1.01$ and $1.1$, each with its approximation.

![Site-centred breathers and their quasi-continuum approximation. Drawn by fig03_site_centred.gp: the columns of
`site_profiles` against `n`.](fig:03)

There are two errors. The quasi-continuum profile differs from the DpS breather even in the limit, and the DpS equation
differs from the chain. At 1.01 the second reduces the first; at 1.1 the sum is twice the first around a site and more
than one and a half times the first around a bond. So the approximation is accurate to about a twentieth where the
article calls it excellent (`newton.qc_small`), and worse at 1.1, as the article says (`newton.qc_worse`).

| largest difference over the amplitude | around a site | around a bond |
|---|---|---|
| in the limit | [0.0575](statement:dps.qc_site) | [0.0614](statement:dps.qc_bond) |
| at $\omega_b = 1.01$ | [0.0511](cell:approximation/centre=site/omega=1.01/difference) | [0.0475](cell:centre=bond/difference) |
| at $\omega_b = 1.1$ | [0.118](cell:approximation/centre=site/omega=1.1/difference) | [0.0978](cell:centre=bond/difference) | */
std::string name_of(Centre centre) {
  return centre == Centre::site ? "site" : "bond";
}

void report_profiles(Report& report) {
  Table& differences = report.table("approximation");
  for (Centre centre : both_centres) {
    // Three breathers, each with its approximation, site by site
    Table& table = report.table(
        name_of(centre) + "_profiles",
        {count("n", "site", "site"), number("u", "stationary DpS breather, mu = 1"),
         number("u_continuum", "quasi-continuum approximation of u"),
         number("y_101", "positions at t = 0, omega_b = 1.01"),
         number("y_101_continuum", "quasi-continuum approximation of these positions"),
         number("y_110", "positions at t = 0, omega_b = 1.1"),
         number("y_110_continuum", "quasi-continuum approximation of these positions")});
    const std::size_t sites = sites_of(centre);
    const auto y = [&](double omega) {
      return find_breather(problem_of(centre, omega, s)).start.y;
    };
    const auto near = [&](double omega) { return ansatz(centre, omega, sites).y; };
    const auto y_101 = y(1.01), near_101 = near(1.01), y_110 = y(1.1), near_110 = near(1.1);
    const auto u = stationary<double>(centre, 1, sites).u;
    for (std::size_t i = 0; i < sites; ++i) {
      const long n = site_number(i, sites);
      table.add(
          {n, u[i], quasi_continuum(centre, n), y_101[i], near_101[i], y_110[i], near_110[i]});
    }

    // The error of each approximation, at two tolerances
    for (double omega : {1.01, 1.1}) {
      const auto off = [&](int coarser) {
        const auto orbit =
            find_breather(problem_of(centre, omega, s), Phase::compressed, rule<double>(coarser));
        return largest_difference(orbit.start, ansatz(centre, omega, sites)) / orbit.amplitude;
      };
      differences.add(
          {{"centre", "site or bond", name_of(centre)},
           {"omega", "frequency", omega},
           {"difference", "largest difference over the amplitude", compare(off(1), off(0))}});
    }
  }
}

/**
## A hundred periods (figure 4)

The site-centred breather is weakly unstable (section 3.3), so rounding errors must grow; the error is the difference
from a second run with another tolerance. The article finds the positions visually equal after a hundred periods; they
have moved by [3e-12 ± 2e-12](cell:hundred_periods/moved) of the amplitude.

![The breather at the start and after a hundred periods. Drawn by fig04_hundred_periods.gp: `y_start` and `y_end` of
`persistence` against `n`.](fig:04) */
void report_persistence(Report& report, const Breather& breather) {
  const State<double> start = at_rest<double>(breather.y);
  std::array<State<double>, 2> end{start, start};
  parallel_for(2, [&](std::size_t k) {
    for (int period = 0; period < (report.quick ? 10 : 100); ++period)
      flow(chain, end[k], T_b, tolerance_of(int(k)));
  });
  const double moved = largest_difference(end[0], start) / largest(start);
  const double error = largest_difference(end[0], end[1]) / largest(start);
  report.table("hundred_periods")
      .add(Row{{"moved", "largest change of positions and velocities over the amplitude",
                Estimate{moved, error}, "", "relative, of two tolerances"}});

  Table& table = report.table("persistence",
                              {count("n", "site", "site"), number("y_start", "positions at t = 0"),
                               estimate("y_end", "positions after 100 periods")});
  for (std::size_t i = 0; i < start.y.size(); ++i) {
    const Estimate late{end[0].y[i], std::abs(end[0].y[i] - end[1].y[i])};
    table.add({site_number(i, start.y.size()), start.y[i], late});
  }
}

/**
## The tail (figure 5)

A bead far out feels only its inner neighbour, with a force that is the power $3/2$ of the neighbour's displacement, so
that $\ln|y_{n+1}|/\ln|y_n| \to 3/2$: the decay is double-exponential. Newton's method follows it to the end of the
number format, $10^{-308}$ in double precision and much farther in extended precision, if every site must converge
relative to its own size (`scaled_rule`). Where both exist their difference is the error.

![The tail of the site-centred breather. Drawn by fig05_tail.gp: `size`, `double_log` and `law` of `tail` against
`n`.](fig:05)

Outwards from the centre the ratio of neighbouring displacements falls from each pair to the next, on both sides and to
the end of double precision (`newton.decay`). The law demands a straight line of $\ln(-\ln|y_n|)$. At the last site
where it can be computed the exponent is [1.500](cell:tail/n=20/exponent), with its change from the site before as its
error. An exponential tail would have a constant ratio and the exponent one. */
/// |y_n(0)| of a breather on so many sites, at index n + 51; zero beyond the end of the chain.
template <class T>
std::vector<T> sizes_of_tail(std::size_t sites) {
  const auto problem = breather_problem<double>(Centre::site, omega_b, s, sites);
  const auto orbit = newton(in_precision<T>(problem), find_breather(problem), scaled_rule<T>());
  std::vector<T> size(103, T(0));
  for (std::size_t i = 0; i < sites; ++i) size[51 + i - sites / 2] = std::abs(orbit.start.y[i]);
  return size;
}

void report_tail(Report& report) {
  // The article's 99 beads in double precision, fewer in extended precision, and the exponents there
  const std::vector<double> size = sizes_of_tail<double>(99);
  const std::vector<Wide> wide = sizes_of_tail<Wide>(63);
  const double none = std::nan("");
  const auto ratio = [&](long n) {
    const Wide inner = wide[51 + n], outer = wide[n < 0 ? 50 + n : 52 + n];
    return inner > 0 && outer > 0 ? double(std::log(outer) / std::log(inner)) : none;
  };
  const auto exponent = [&](long n) {
    return n == 0 ? Estimate{ratio(0), none} : compare(ratio(n < 0 ? n + 1 : n - 1), ratio(n));
  };
  long last = 0;
  while (wide[52 + last] > 0) ++last;

  // Site by site, with the law |y_(n+1)| ~ |y_n|^(3/2) from the last site inwards
  Table& table = report.table(
      "tail", {count("n", "site", "site"),
               estimate("size", "|y_n(0)| in double precision; nan where it underflows", "",
                        "difference from extended precision; nan where size is"),
               estimate("exponent", "ln |y_(n+1)| / ln |y_n|, outwards from the centre", "",
                        "change from the site before, known to 15 per cent; nan at the centre and "
                        "where the tail ends"),
               number("double_log", "ln(-ln |y_n(0)|) in extended precision"),
               number("law", "double_log by the law 3/2, from the outermost site inwards")});
  const double end = double(std::log(wide[51 + last]));
  for (long n = -49; n <= 49; ++n) {
    const double y = size[51 + n];
    const Wide same = wide[51 + n];
    const bool known = y > 1e-300 && same > 0;
    table.add({n, known ? Estimate{y, std::abs(double(y - same))} : Estimate{none, none},
               exponent(n), same > 0 ? double(std::log(-std::log(same))) : none,
               std::log(-end) + double(std::abs(n) - last) * std::log(1.5)});
  }
}

/**
## The branches (figure 6)

Both families are followed by arclength from $\omega_b = 1.001$ to $2$ (continuation.hpp). Amplitude and energy grow
from each frequency of the figure to the next, and so does the asymmetry around a site, where the breather is its own
mirror image only in the limit of small amplitude. The energies of both kinds differ by 1.2 millionths at most, at the
lowest frequency. Towards $\omega_b = 1$ the fraction must tend to that of the DpS norms, which is
[-1.331e-6](cell:sec32_dps_profiles/norms/gap) from site to bond, with the other sign; at 1.001 its modulus is nine
tenths of this.

![Amplitude and energy of both families. Drawn by fig06_branches.gp: amplitudes and energies of `branches` against
`omega`.](fig:06)

| $\omega_b$ | amplitude, site | bond | site over bond, minus one (article: visible) | the same of the energies (article: indistinguishable) | asymmetry |
|---|---|---|---|---|---|
| 1.001 | [9.64e-7](cell:branches/omega=1.001/amplitude_site) | [8.84e-7](cell:amplitude_bond) | [0.0906](cell:amplitude_gap) | [1.186e-6](cell:energy_gap) | [0.000515](cell:asymmetry) |
| 1.1 | [0.01075](cell:branches/omega=1.1/amplitude_site) | [0.00978](cell:amplitude_bond) | [0.0985](cell:amplitude_gap) | [1.06e-7](cell:energy_gap) | [0.0506](cell:asymmetry) |
| 1.5 | [0.394](cell:branches/omega=1.5/amplitude_site) | [0.352](cell:amplitude_bond) | [0.122](cell:amplitude_gap) | [1.48e-8](cell:energy_gap) | [0.247](cell:asymmetry) |
| 1.725 | [0.997](cell:branches/omega=1.725/amplitude_site) | [0.882](cell:amplitude_bond) | [0.130](cell:amplitude_gap) | [1.28e-8](cell:energy_gap) | [0.365](cell:asymmetry) |
| 2 | [2.457](cell:branches/omega=2/amplitude_site) | [2.293](cell:amplitude_bond) | [0.0714](cell:amplitude_gap) | [-6.08e-8](cell:energy_gap) | [0.464](cell:asymmetry) | */
/// The largest |y_n(0) - y_-n(0)|, relative to the largest |y_n(0)|.
double asymmetry(const Orbit<double>& orbit) {
  double most = 0;
  for (std::size_t n = 0, last = orbit.start.y.size() - 1; n < last - n; ++n)
    most = std::max(most, std::abs(orbit.start.y[n] - orbit.start.y[last - n]));
  return most / orbit.amplitude;
}

// Around a site, from orbits at two tolerances
std::vector<Estimate> asymmetries_of(const BreatherPairs& pairs) {
  std::vector<Estimate> all(pairs.size());
  parallel_for(pairs.size(), [&](std::size_t i) {
    const Orbit<double>& orbit = pairs[i].orbit[0];
    const Vector<double> beside = orbit.x * 1.000001;
    const auto problem = problem_of(Centre::site, pairs[i].omega, s);
    all[i] = compare(asymmetry(newton(problem, beside, rule<double>(1))), asymmetry(orbit));
  });
  return all;
}

void report_branches(Report& report) {
  // Both families, frequency by frequency
  std::vector<double> omegas = pair_frequencies(s, report.quick ? 6 : 80);
  omegas.insert(omegas.begin(), 1.001);
  const BreatherPairs pairs = breather_pairs_at(s, omegas, measure_in<double>);
  const std::vector<Estimate> asymmetries = asymmetries_of(pairs);
  Table& table = report.table(
      "branches", {number("omega", "frequency"), estimate("amplitude_bond", "largest |y_n(0)|"),
                   estimate("amplitude_site", "largest |y_n(0)|"),
                   estimate("energy_bond", "energy of the bond-centred breather"),
                   estimate("energy_site", "energy of the site-centred breather"),
                   estimate("asymmetry",
                            "largest |y_n(0) - y_-n(0)| around a site, over the "
                            "amplitude"),
                   estimate("amplitude_gap", "amplitude_site over amplitude_bond, minus one"),
                   estimate("energy_gap", "E_site - E_bond, over E_bond", "",
                            "difference of two resolutions, against the largest")});
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const BreatherPair& r = pairs[i];
    const auto& [site, bond] = r.energy;
    const Estimate ratio = quotient(r.amplitude[0], r.amplitude[1]);
    table.add({r.omega, r.amplitude[1], r.amplitude[0], bond, site, asymmetries[i],
               Estimate{ratio.value - 1, ratio.error}, quotient(r.equal_frequency, bond)});
  }
}

/**
## The width at small amplitude

A breather of the DpS equation keeps its width when its amplitude goes to zero, and section 1 of the article says that
those of the chain nearly do. As width we take the participation number of the displacements,
$(\sum y_n^2)^2/\sum y_n^4$ at $t = 0$. Up to 1.01, which the article calls small amplitude, the amplitude grows a
hundredfold and the width by less than a hundredth; a width like $(\omega_b-1)^{-1/2}$, as in the discrete nonlinear
Schrödinger equation, would shrink to a third. Up to 1.05 the width grows by a twentieth at most, so what *nearly*
means decides how far one may go (`chain.width_constant`).

| width in sites, $\omega_b$ | 1.001 | 1.01 | 1.05 |
|---|---|---|---|
| around a site | [2.965](cell:widths/centre=site/omega=1.001/width) | [2.982](cell:omega=1.01/width) | [3.060](cell:omega=1.05/width) |
| around a bond | [2.973](cell:widths/centre=bond/omega=1.001/width) | [3.000](cell:omega=1.01/width) | [3.122](cell:omega=1.05/width) | */
void report_width(Report& report) {
  struct Wanted {
    Centre centre;
    double omega;
  };
  std::vector<Wanted> all;
  for (Centre centre : both_centres)
    for (double omega : {1.001, 1.002, 1.005, 1.01, 1.02, 1.03, 1.04, 1.05})
      all.push_back({centre, omega});
  report.table("widths").fill(all, [](const Wanted& at) {
    const auto problem = problem_of(at.centre, at.omega, s);
    const auto start = [&](int coarser) {
      return find_breather(problem, Phase::compressed, rule<double>(coarser)).start;
    };
    const TwoRuns<State<double>> starts{start(1), start(0)};
    const auto of_positions = [](const State<double>& state) {
      auto squares = state.y;
      for (double& y_n : squares) y_n *= y_n;
      return participation(squares);
    };
    const auto of_energies = [&](const State<double>& state) {
      return participation(energy_density(problem.chain, state));
    };
    return Row{{"centre", "site or bond", name_of(at.centre)},
               {"omega", "frequency", at.omega},
               {"width", "participation number of the displacements, (sum y^2)^2 / sum y^4",
                starts.of(of_positions), "site"},
               {"width_energy", "participation number of the energy densities, (sum e)^2 / sum e^2",
                starts.of(of_energies), "site"}};
  });
}

/**
## Other wells

For $s \in [-1, 1]$ the article finds both families, without showing them. We find them in nine wells, in steps of a
quarter of $s$. In all of them both families bifurcate from rest: the exponent of the amplitude in $\omega_b-1$,
between 1.0005 and 1.001, is two within its change from the next pair of frequencies, around a site
[2.001 ± 0.004](cell:other_wells/s=-1/centre=site/exponent) at $s = -1$ and [2.001 ± 0.004](cell:s=1/exponent) at
$s = 1$. */
void report_other_wells(Report& report) {
  struct Wanted {
    double s;
    Centre centre;
  };
  std::vector<Wanted> all;
  for (int quarters = -4; quarters <= 4; quarters += report.quick ? 8 : 1)
    for (Centre centre : both_centres) all.push_back({quarters / 4.0, centre});
  const auto row = [](const Wanted& in) {
    const auto orbits = breathers_at(in.centre, in.s, {1.0005, 1.001, 1.01});
    return Row{{"s", "anharmonicity of the well", in.s},
               {"centre", "site or bond", name_of(in.centre)},
               {"exponent", "of the amplitude in omega_b - 1, at 1.0005",
                compare(growth_exponent(orbits.at(1), orbits.at(2)),
                        growth_exponent(orbits.at(0), orbits.at(1))),
                "", "change from the next pair of frequencies"}};
  };
  report.table("other_wells").fill(all, row, "other wells");
}

/**
## Are the breathers really symmetric?

We impose both symmetries, so finding them in the result proves nothing. We therefore search without them: all positions
are unknown, the start is perturbed at random by a thousandth, and the only condition is that the chain is at rest at
$T_b/2$. In a continuous family of asymmetric breathers through ours the result would keep an asymmetry of about a
thousandth. In extended precision (a 64-bit mantissa) the symmetries $y_{1-n} = -y_n$ and $y_n(t) = -y_{-n}(t+T_b/2)$
are restored to $10^{-9}$ of the amplitude at five frequencies up to 2 (`newton.symmetry`). So ours are symmetric and
isolated; an asymmetric breather elsewhere is not excluded. */
double broken_symmetry(Centre centre, double omega) {
  auto problem = in_precision<Wide>(problem_of(centre, omega, s));
  State<Wide> start(problem.chain.sites);
  const auto y = shaken(find_breather(problem_of(centre, omega, s)).start.y, 1e-3, 7);
  std::copy(y.begin(), y.end(), start.y.begin());
  problem.symmetry = even_in_time(problem.chain.sites);
  const Orbit<Wide> orbit = newton(problem, problem.reduce(start));
  State<Wide> image = orbit.start;
  if (centre == Centre::site) flow(problem.chain, image, problem.period() / 2);
  Wide most = 0;
  for (std::size_t n = 0, last = image.y.size() - 1; n <= last; ++n)
    most = std::max(most, std::abs(orbit.start.y[n] + image.y[last - n]));
  return double(most / orbit.amplitude);
}

void report_symmetry(Report& report) {
  Table& table = report.table("symmetry");
  for (Centre centre : both_centres)
    for (double omega : {1.01, 1.1, 1.3, 1.5, 2.0})
      table.add({{"centre", "site or bond", name_of(centre)},
                 {"omega", "breather frequency", omega},
                 {"broken", "largest violation of the symmetry over the amplitude",
                  compare(0.0, broken_symmetry(centre, omega)), "",
                  "relative to the amplitude, distance from zero"}});
}

/**
## Differences and limits

The article counts five iterations of its Gauss-Newton method; ours continues until rounding stops it. Its chains have
31 and 99 beads around a site; around a bond we take one more. It does not say how far in frequency it followed the
families of anharmonic wells.

## Statement by statement

<!-- statements -->
| statement | printed | here | verdict |
|---|---|---|---|
| `newton.residual`: relative residual of the site-centred breather at omega_b = 1.1 on 31 particles after 5 iterations | 1.5e-9 | 4e-14 | quantified |
| `newton.variation`: relative variation of positions between the last iterates | 1.7e-11 | 7e-14 | quantified |
| `newton.persistence`: positions at t = 100 T_b coincide with the initial ones | visually equal | hundred_periods.moved: 2.803e-12 < 0.01 | holds |
| `newton.decay`: tail decays super-exponentially on 99 particles | super-exponential | tail.size (n = -3), (n = -2), (n = -1): 0.2094 < 0.3472 (the closest of 27) | holds |
| `newton.qc_small`: quasi-continuum ansatz is excellent at omega_b = 1.01 | excellent | 0.05113 relative | quantified |
| `newton.qc_worse`: accuracy of the quasi-continuum ansatz deteriorates at omega_b = 1.1 | ordering | approximation.difference (centre = site, omega = 1.01), (centre = site, omega = 1.1): 0.05113 < 0.1176; approximation.difference (centre = bond, omega = 1.01), (centre = bond, omega = 1.1): 0.04755 < 0.09777 | holds |
| `newton.energy_equal`: energy curves of both families are indistinguishable for omega_b in (1; 2] | indistinguishable | branches.energy_gap (omega = 1.001): 1.186e-06 < 0.01 (the closest of 82) | holds |
| `newton.symmetry`: bond-centred: y_(1-n) = -y_n; site-centred: y_n(t) = -y_(-n)(t + T_b/2) | symmetry | symmetry.broken (centre = bond, omega = 1.5): 9.815e-10 < 1e-08 (the closest of 10) | holds |
| `newton.any_s`: branches of both centres bifurcate from the origin for every s in [-1; 1] | exist | other_wells.exponent (s = -1, centre = site) away from 2: 0.0008169 < 0.05 (the closest of 18) | holds |
| `newton.grows`: amplitude and energy of both centres increase with omega_b | increase | branches.amplitude_site (omega = 1.988), (omega = 2): 2.37 < 2.457 (the closest of 324) | holds |
| `newton.site_asymmetry`: asymmetry of site-centred breathers under n -> -n increases with omega_b and is visible at 1.1 | increases | branches.asymmetry (omega = 1.988), (omega = 2): 0.4598 < 0.4637 (the closest of 82) | holds |
| `newton.amplitude_differs`: the amplitudes of the two centres differ visibly | visible | branches.amplitude_gap (omega = 2): 0.01 < 0.07143 (the closest of 82) | holds |
| `newton.amplitude_minor`: the differences of the amplitudes of the two centres are minor | minor | 0.1302 relative | quantified |
| `chain.width_constant`: the width of the chain's breathers remains nearly constant at small amplitude | nearly constant | widths.width (centre = site, omega = 1.001) and 3 other values: 0.005864 < 0.01; widths.width (centre = bond, omega = 1.001) and 3 other values: 0.00904 < 0.01 | holds, assuming |
<!-- /statements -->

## Try it

**To change it.** Another anharmonicity of all wells is `s` (below zero the branches end before 2, and the last row of
their table goes), another breather of the first listing `omega_b`, up to 1.1. Other wells and contacts are options of
the command `breather`.

1. *Easy.* How does the amplitude grow with $\omega_b - 1$?
   `build/bin/sec32_newton_breathers breather --centre bond --omega 1.002` gives `amplitude` = 3.53917e-6. Hint: at
   1.001 it is a quarter of that; Eq. (20) says why.
2. *Harder.* What is the law of exercise 1 for contacts of another exponent?
   `build/bin/sec32_newton_breathers breather --contact power --alpha 2 --omega 1.1` gives `amplitude` = 0.0998154.
   Hint: the shift of the frequency goes like the contact force over the displacement, amplitude$^{\alpha-1}$.

The command `breather` computes a breather with your own parameters (commands/one_breather.hpp). */
void reproduce(Report& report) {
  report.output.note("tolerance", "flow to 128 and 2048 roundings of the type");
  const Breather breather = report_convergence(report);
  report_symmetry(report);
  report_profiles(report);
  report_persistence(report, breather);
  report_tail(report);
  report_branches(report);
  report_width(report);
  report_other_wells(report);
}

int main(int argc, char** argv) {
  return run({"sec32_newton_breathers", "3.2", "Static breathers of the chain (section 3.2)",
              reproduce, commands<OneBreather>()},
             argc, argv);
}
