/**
# 3.2 Static breathers of the chain

Does the chain have static breathers, and how accurately can they be computed? Section 3.2 of James, Kevrekidis and
Cuevas (Physica D 251, 2013) finds two families by Newton's method, and so do we, at every frequency up to $2$. If the
equations use the symmetry of the breather, four steps suffice; the article's equations, without symmetry, are
ill-conditioned along one direction, a shift of the breather along the chain. The amplitudes of the two families differ
visibly, their energies by little more than a millionth at most, which suggests that a breather moves at little cost
(section 3.3).

A breather is a time-periodic motion in which a few beads carry nearly all the energy and neighbours oscillate out of
phase, either around a *site*, one bead against both of its neighbours, or around a *bond*, two neighbours against each
other. Breathers are usually continued from decoupled sites of which one oscillates (MacKay and Aubry, Nonlinearity 7,
1994; Marín and Aubry, Nonlinearity 9, 1996). In linear wells all decoupled beads have the frequency 1, so the article
starts from the limit of small amplitude instead, the DpS breathers of the previous chapter.

![Bond-centred breathers, of the DpS equation and of the chain, and their quasi-continuum approximation.](fig:02)

<!-- head -->
`build/bin/sec32_newton_breathers` computes this chapter in 3 s on two cores and writes 12 tables to
`build/data/sec32_newton_breathers`. Its figures: `make fig02`, `make fig03`, `make fig04`, `make fig05`, `make fig06`,
`make x44`. With your parameters: `breather`, one breather: amplitude, energy, area (2 pi times the action) and
residual.
<!-- /head -->

## Model

The beads sit in the wells of Eq. (10), mostly linear ones ($s = 0$), and push on their neighbours, Eqs. (6) and (9):
$$\ddot y_n + y_n + s\,y_n^3 = (y_{n-1}-y_n)_+^{3/2} - (y_n-y_{n+1})_+^{3/2},
  \qquad y_n(t+T_b) = y_n(t),\quad T_b = 2\pi/\omega_b.$$
The ends are free, all quantities dimensionless. A breather starts from rest, so the positions $y_n(0)$ are the
unknowns, and its motion is even in time. A reflection of the chain must also change the sign of all positions,
since contacts only push. Around a bond the breather is its own image, $y_{1-n} = -y_n$, so half of the chain suffices;
since an even periodic motion is also even about $T_b/2$, all beads are at rest there. Around a site the image is the
breather half a period later, $y_n(t) = -y_{-n}(t+T_b/2)$. With the evenness this gives $y_n(T_b/4) = -y_{-n}(T_b/4)$
and $\dot y_n(T_b/4) = \dot y_{-n}(T_b/4)$. So the conditions, as many as unknowns, are
$$\dot y_n(T_b/2) = 0 \quad\text{(bond)},\qquad
  y_n+y_{-n} = 0,\quad \dot y_n-\dot y_{-n} = 0 \quad\text{at } t = T_b/4 \quad\text{(site)}.$$ */
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "commands/one_breather.hpp"
#include "lattice/algebra/dense.hpp"
#include "lattice/diagnostics/path.hpp"
#include "lattice/events/event_driven.hpp"
#include "lattice/gsl/random.hpp"
#include "lattice/model/dps.hpp"
#include "lattice/orbits/breather.hpp"
#include "lattice/orbits/shooting.hpp"
#include "lattice/standing/stationary.hpp"
#include "report/program.hpp"
#include "sec3/breather_pairs.hpp"
#include "sec3/resolutions.hpp"

using namespace lattice;
using namespace report;

/**
## The experiment

We look for the breather around a site at $\omega_b = 1.1$ on 31 beads, as in the article; around a bond we take one
more. The guess is the article's (`ansatz`): $y_n(0) = 2\epsilon\,u_n$ with $\epsilon = [2\tau_0(\omega_b-1)]^2$,
$\tau_0 = 1.545$ (dps.hpp) and the quasi-continuum profile $u_n$ of Eq. (19). `evaluate` integrates over a quarter of
the period (around a bond over half of it) and returns the conditions $R$ and their derivative $DR$, the same
combinations taken of the linearised flow. Its steps have variable length and order and end at every *contact event*,
the opening or closing of a contact (event_driven.hpp); their tolerance is 128 machine epsilons of the largest
displacement, or, in a coarser run, 16 times that (`rule`). The difference of the two runs is the error of a number. */
constexpr std::size_t sites = 31;  // around a site, and one more around a bond
constexpr double omega_b = 1.1;    // frequency of the breather of figures x44, 4 and 5
constexpr double s = 0;            // anharmonicity of the wells
const Contact contact = without_cutoff(Hertz{});  // since the tail counts
const double alpha = contact.exponent();
constexpr std::size_t article_steps = 5, most_steps = 10;  // of Newton's method
constexpr double least_kept = 1e-5;  // least singular value over the largest, if chosen
const std::vector searched{1.01, 1.1, 1.3, 1.5, 2.};  // frequencies, without symmetry
constexpr double perturbation = 1e-3;                 // at most, of each position at the start
constexpr unsigned long seed = 7;
constexpr std::array small_and_large{1.01, 1.1};  // frequencies of figures 2 and 3, y_101 and y_110
constexpr int periods = 100;                      // of figure 4
constexpr std::size_t tail_sites = 99, wide_sites = 63;  // of figure 5; wide: extended precision
constexpr double lowest = 1.001;                         // first frequency of figure 6
constexpr int intervals = 40;                            // of its other frequencies, from 1 to 2

/// The conditions on a breather, with its chain.
Shooting<double> conditions(Centre centre, double omega, double anharmonicity = s,
                            std::size_t beads = sites) {
  if (centre == Centre::bond) beads += 1;
  Shooting<double> problem = breather_problem(centre, omega, Quartic{anharmonicity}, beads);
  problem.chain.contact = contact;
  return problem;
}

/// A point of the iteration; residual and step are relative to the largest displacement.
struct Iterate {
  Vector<double> x;       // positions at t = 0
  double residual, step;  // the step from here on
  Softness soft;          // condition of DR and its least singular vector
};
using Iterates = std::vector<Iterate>;

/// x <- x - DR(x)^-1 R(x) from the ansatz, without directions of a singular value below `least`.
Iterates iterate(const Shooting<double>& problem, Resolution resolution, double least) {
  Vector<double> x =
      problem.reduce(ansatz(Centre::site, problem.omega, sites, Phase::compressed, contact));
  Iterates path;
  while (path.size() <= most_steps) {
    const Evaluation<double> now = problem.evaluate(x, rule<double>(resolution).events);
    const Vector<double>& R = now.residual;
    const Matrix<double>& DR = now.jacobian;
    // The unit of a bead is its own displacement, as the tail falls fast, or the largest
    const auto unit = problem.sizes(x, DR.rows() == DR.cols());
    const Vector<double> step = solve_scaled<double>(DR, R, unit, least);
    path.push_back({x, sup(R) / sup(x), sup(step) / sup(x), condition_of(DR)});
    x -= step;
  }
  return path;
}

/**
The library's `newton` makes these steps until the residual no longer falls, and `find_breather` continues the branch
beyond 1.1. An independent program with another integrator (`tests/second`) finds the same breathers at 1.1.

## Convergence of Newton's method

The article solves other equations: all positions and velocities return after the whole period, twice as many equations
as unknowns, in the sense of least squares. What is the cost of leaving out the symmetry?

![Residual of Newton's method, relative to the amplitude, for three sets of equations, each in its own conditions;
dotted: the least singular value of the whole period, relative to the largest; grey: the article's residual after five
steps.](fig:x44)

With the symmetric equations the number of correct digits doubles in each step, and after
[4](cell:hundred_periods/steps) steps only the tolerance of the flow is left. The article's equations begin alike, but
in the fourth step the residual *rises*, by three orders. The reason is an ill-conditioned direction: where a singular
value of $DR$ is small, what is left of the residual gives a large step. The least singular vector is nearly the
discrete gradient $y_{n+1}-y_{n-1}$ of the breather, which shifts it along the chain (the cosine of their angle is
[0.987](cell:convergence/equations=whole_period/steps=5/pinning)): the *pinning mode* of section 3.3 (Chen, Aubry and
Tsironis, Phys. Rev. Lett. 77, 1996). Its singular value becomes small only close to the solution, within three steps.
The residual over it then gives a fourth step [6.30e-3](cell:convergence/equations=whole_period/steps=4/step) long, a
shift along the chain; the new residual is quadratic in it. If least squares leave out the singular values below
$10^{-5}$, there is no rise, but what is left of the residual along the pinning mode is never corrected. Symmetry
excludes this mode. The article's numbers are more like those without it; it does not say if it kept it.

| after 5 steps, over the amplitude | change in a whole period | last step |
|---|---|---|
| article | 1.5e-9 | 1.7e-11 |
| symmetric equations | [2e-14 ± 2e-14](cell:convergence/equations=quarter_period/residual) | [0 ± 4e-13](cell:step) |
| its equations | [3.61e-10](cell:convergence/equations=whole_period/steps=5/residual) | [5.639e-5](cell:step) |
| without the pinning mode | [2.01e-9](cell:convergence/equations=without_pinning_mode/residual) | [2e-14 ± 9e-14](cell:step) | */
/// The article's residual of positions x at t = 0: the change of positions and velocities after a whole period, over the
/// largest of them, computed in extended precision.
double return_after_period(const Shooting<double>& problem, const Vector<double>& x) {
  const auto same = in_precision<Wide>(problem);
  const State<Wide> start = same.expand(x.cast<Wide>());
  State<Wide> end = start;
  flow(same.chain, end, same.period());
  return double(largest_difference(end, start) / largest(start));
}

/// A point of a path in numbers, compared with the breather.
Row row_of(const char* equations, std::size_t k, const TwoRuns<Iterates>& paths,
           const Shooting<double>& problem, const Orbit<double>& breather) {
  const auto returned = [&](const Iterates& path) {
    return return_after_period(problem, path[k].x);
  };
  const auto last_step = [&](const Iterates& path) { return path[k - 1].step; };
  const auto excess = [&](const Iterates& path) {
    return energy(problem.chain, problem.expand(path[k].x)) - breather.energy;
  };
  const auto condition = [&](const Iterates& path) { return path[k].soft.condition; };
  const auto pinning = [&](const Iterates& path) {
    return alignment(path[k].soft.softest, discrete_gradient({path[k].x.begin(), path[k].x.end()}));
  };
  return Row{{"equations", equations},
             {"steps", k},
             {"residual", paths.of(returned)},
             {"step", paths.of(last_step)},
             {"energy_excess", paths.of(excess)},
             {"condition", paths.of(condition)},
             {"pinning", paths.of(pinning)}};
}

void report_convergence(Report& report) {
  // The same iteration on a quarter of the period, and on the whole with and without the mode
  const auto both = [](const Shooting<double>& equations, double least) {
    return TwoRuns<Iterates>{iterate(equations, Resolution::coarse, least),
                             iterate(equations, Resolution::fine, least)};
  };
  const Shooting<double> symmetric = conditions(Centre::site, omega_b);
  Shooting<double> returning_after = symmetric;
  returning_after.symmetry = returning(sites);
  const TwoRuns<Iterates> quarter = both(symmetric, 0), whole = both(returning_after, 0),
                          without = both(returning_after, least_kept);
  Table& history = report.table("iterations");
  for (std::size_t k = 0; k <= most_steps; ++k)
    history.add({{"steps", k},
                 {"quarter_period", quarter.fine[k].residual},
                 {"whole_period", whole.fine[k].residual},
                 {"without_pinning_mode", without.fine[k].residual},
                 {"singular", 1 / whole.fine[k].soft.condition}});

  // What the article prints, and the step before
  Table& table = report.table("convergence");
  const Orbit<double> breather = find_breather(symmetric);
  table.add(row_of("quarter_period", article_steps, quarter, symmetric, breather));
  table.add(row_of("whole_period", article_steps - 1, whole, symmetric, breather));
  table.add(row_of("whole_period", article_steps, whole, symmetric, breather));
  table.add(row_of("without_pinning_mode", article_steps, without, symmetric, breather));
}

/**
## Are the breathers really symmetric?

Since the symmetries are imposed, finding them in the result proves nothing. We change each position of the symmetric
breather at random by up to 0.1 per cent, and Newton's method knows only that the chain is at rest at $T_b/2$
(`without_symmetry`). In extended precision (a 64-bit mantissa), at five frequencies in the linear well, both symmetries
return to $10^{-9}$ of the amplitude (`newton.symmetry`), about the tolerance, $1.4\cdot10^{-17}$, times the largest
condition number of $DR$, [6.89e7](cell:symmetry/centre=site/omega=1.5/condition). Since $DR$ is regular, no continuous
family of asymmetric breathers of one frequency passes here; others are possible. */
/// A breather that was found without its symmetry: how far from it, over the amplitude, and the condition number of DR.
struct FreeBreather {
  double broken;
  Estimate condition;  // its error: the difference from that at the symmetric breather
};

/// Newton's method in extended precision knows only that the breather of `problem` is even in time, and starts with all
/// positions changed by a random part of themselves, at most `perturbation`.
FreeBreather without_symmetry(const Shooting<double>& problem) {
  const std::size_t sites = problem.chain.sites;
  Shooting<double> even = problem;
  even.symmetry = even_in_time(sites);
  State<double> start = find_breather(problem).start;
  const auto symmetric = even.evaluate(even.reduce(start), {});
  start.y = perturbed(start.y, perturbation, seed);
  const auto free = in_precision<Wide>(even);
  const Orbit<Wide> orbit = newton(free, newton(even, even.reduce(start)));
  State<Wide> image = orbit.start;
  if (sites % 2 == 1) flow(free.chain, image, free.period() / 2);  // around a site
  Wide most = 0;
  for (std::size_t n = 0; n < sites; ++n)
    most = std::max(most, std::abs(orbit.start.y[n] + image.y[sites - 1 - n]));
  return {double(most / orbit.amplitude), with_error(condition_of(symmetric.jacobian).condition,
                                                     condition_of(orbit.jacobian).condition)};
}

void report_symmetry(Report& report) {
  Table& table = report.table("symmetry");
  for (Centre centre : both_centres)
    for (double omega : report.quick ? std::vector{omega_b} : searched) {
      const auto found = without_symmetry(conditions(centre, omega));
      table.add({{"centre", name_of(centre)},
                 {"omega", omega},
                 {"broken", with_error(0.0, found.broken)},
                 {"condition", found.condition}});
    }
}

/**
## Profiles (figures 2 and 3)

The quasi-continuum approximation is off by [0.0511](cell:approximation/centre=site/omega=1.01/difference) (site) and
[0.0475](cell:approximation/centre=bond/omega=1.01/difference) (bond) of the amplitude at 1.01, where the article calls
it excellent (`newton.qc_small`), and by more than twice as much at 1.1, as the article says (`newton.qc_worse`).

![Site-centred breathers and their quasi-continuum approximation.](fig:03) */
void report_profiles(Report& report) {
  Table& differences = report.table("approximation");
  for (Centre centre : both_centres) {
    std::vector<State<double>> breathers, guesses;
    for (double omega : small_and_large) {
      const auto orbit = [&](Resolution resolution) {
        return find_breather(conditions(centre, omega), Phase::compressed,
                             rule<double>(resolution));
      };
      const TwoRuns<Orbit<double>> found{orbit(Resolution::coarse), orbit(Resolution::fine)};
      const std::size_t beads = found.fine.start.y.size();
      const State<double> guess = ansatz(centre, omega, beads, Phase::compressed, contact);
      const auto difference = [&](const Orbit<double>& breather) {
        return largest_difference(breather.start, guess) / breather.amplitude;
      };
      differences.add(
          {{"centre", name_of(centre)}, {"omega", omega}, {"difference", found.of(difference)}});
      breathers.push_back(found.fine.start);
      guesses.push_back(guess);
    }

    // What the figures show
    const std::size_t beads = guesses.front().y.size();
    const auto u = stationary<double>(centre, 1, beads, alpha).u;
    Table& table = report.table(name_of(centre) + "_profiles");
    for (std::size_t i = 0; i < beads; ++i) {
      const long n = site_number(i, beads);
      table.add({{"n", n},
                 {"u", u[i]},
                 {"u_continuum", quasi_continuum(centre, n, alpha)},
                 {"y_101", breathers[0].y[i]},
                 {"y_101_continuum", guesses[0].y[i]},
                 {"y_110", breathers[1].y[i]},
                 {"y_110_continuum", guesses[1].y[i]}});
    }
  }
}

/**
## A hundred periods (figure 4)

The article finds the positions visually equal after 100 periods; positions and velocities have changed by
[3e-12 ± 2e-12](cell:hundred_periods/moved) of the amplitude. Yet this breather is unstable (section 3.3). But the one
real multiplier above 1 is [1.000214](cell:sec33_floquet/site_against_s/s=0/largest_modulus): along its eigenvector a
disturbance grows by 2 per cent in 100 periods. In each, a velocity shifts the breather.

![The breather at the start and after a hundred periods.](fig:04) */
void report_persistence(Report& report) {
  const auto problem = conditions(Centre::site, omega_b);
  const Orbit<double> found = find_breather(problem);
  const State<double>& start = found.start;
  const auto after = [&](Resolution resolution) {
    State<double> now = start;
    for (int period = 0; period < (report.quick ? periods / 10 : periods); ++period)
      flow(problem.chain, now, problem.period(), rule<double>(resolution).events);
    return now;
  };
  const TwoRuns<State<double>> end{after(Resolution::coarse), after(Resolution::fine)};
  report.table("hundred_periods")
      .add(Row{{"steps", found.iterations()},
               {"moved", Estimate{largest_difference(end.fine, start) / largest(start),
                                  largest_difference(end.fine, end.coarse) / largest(start)}}});
  Table& table = report.table("persistence");
  for (std::size_t i = 0; i < start.y.size(); ++i)
    table.add({{"n", site_number(i, start.y.size())},
               {"y_start", start.y[i]},
               {"y_end", with_error(end.coarse.y[i], end.fine.y[i])}});
}

/**
## The tail (figure 5)

A bead far out feels only its inner neighbour, with a force that is the power $3/2$ of the neighbour's displacement, so
that $\ln|y_{n+1}|/\ln|y_n| \to 3/2$: the decay is double-exponential. At the last site where it can be computed we find
[1.500](cell:tail/n=20/exponent), with the change from the site before as its error.

![The tail of the site-centred breather.](fig:05)

If every site must converge relative to its own size (`scaled_rule`), Newton's method follows the tail to $n = 14$ in
double precision, to [6.42e-208](cell:tail/n=14/size), and to $n = 21$ in extended precision; where both exist their
difference is the error. So 31 beads suffice at 1.1. Outwards the ratio of neighbouring displacements falls from each
pair to the next, on both sides and to the end of double precision (`newton.decay`). */
/// |y_n(0)| of a breather, each site as accurate as the largest, and zero beyond the end of the chain.
template <class T>
struct Tail {
  std::vector<T> y;

  explicit Tail(const Shooting<double>& problem)
      : y(newton(in_precision<T>(problem), find_breather(problem), scaled_rule<T>()).start.y) {}
  T operator()(long n) const {
    const std::size_t i = site_index(n, y.size());
    return i < y.size() ? std::abs(y[i]) : T(0);
  }
  /// ln(-ln |y_n|), which grows by ln(3/2) a site; nan where there is no number.
  double double_log(long n) const {
    const T y = (*this)(n);
    return y > 0 ? double(std::log(-std::log(y))) : undefined.value;
  }
  /// ln |y_(n+1)| / ln |y_n|, outwards; nan where there is no number.
  double exponent(long n) const {
    const T y = (*this)(n), outer = (*this)(n < 0 ? n - 1 : n + 1);
    return outer > 0 ? double(std::log(outer) / std::log(y)) : undefined.value;
  }
};

void report_tail(Report& report) {
  const Tail<double> size(conditions(Centre::site, omega_b, s, tail_sites));
  const Tail<Wide> wide(conditions(Centre::site, omega_b, s, wide_sites));
  long last = 0;
  while (wide(last + 1) > 0) ++last;

  // Site by site, with the law |y_(n+1)| ~ |y_n|^(3/2) from the last site inwards
  Table& table = report.table("tail");
  for (long n = -long(tail_sites / 2); n <= long(tail_sites / 2); ++n) {
    const bool known = size(n) > 1e-300 && wide(n) > 0;
    const double before = n == 0 ? undefined.value : wide.exponent(n < 0 ? n + 1 : n - 1);
    table.add({{"n", n},
               {"size", known ? Estimate{size(n), std::abs(double(size(n) - wide(n)))} : undefined},
               {"exponent", with_error(before, wide.exponent(n))},
               {"double_log", wide.double_log(n)},
               {"law", wide.double_log(last) + double(std::abs(n) - last) * std::log(alpha)}});
  }
}

/**
## The branches (figure 6)

Both families are continued by arclength from $\omega_b = 1.001$ to $2$ (continuation.hpp). Amplitude and energy grow
monotonically on the grid of the figure, and so does the asymmetry around a site, where the breather is its own mirror
image only in the limit of small amplitude.

![Amplitude and energy of both families.](fig:06)

The surprise is how nearly the energies agree while the amplitudes differ by a tenth. The relative difference is largest
at the lowest frequency. Towards $\omega_b = 1$, where the energy is proportional to the norm of the DpS breather, it
tends to that of the two norms, which is [-1.331e-6](cell:sec32_dps_profiles/norms/gap) from site to bond.

| $\omega_b$ | amplitude, site over bond, minus one (article: visible) | the same of the energies (article: indistinguishable) | asymmetry |
|---|---|---|---|
| 1.001 | [0.0906](cell:branches/omega=1.001/amplitude_gap) | [1.186e-6](cell:energy_gap) | [0.000515](cell:asymmetry) |
| 1.725 | [0.130](cell:branches/omega=1.725/amplitude_gap) | [1.28e-8](cell:energy_gap) | [0.365](cell:asymmetry) |
| 2 | [0.0714](cell:branches/omega=2/amplitude_gap) | [-6.08e-8](cell:energy_gap) | [0.464](cell:asymmetry) | */
/// The largest |y_n(0) - y_-n(0)|, relative to the largest |y_n(0)|.
double asymmetry(const Orbit<double>& orbit) {
  double most = 0;
  for (std::size_t n = 0, last = orbit.start.y.size() - 1; n < last - n; ++n)
    most = std::max(most, std::abs(orbit.start.y[n] - orbit.start.y[last - n]));
  return most / orbit.amplitude;
}

void report_branches(Report& report) {
  // Both families, frequency by frequency, at two tolerances
  std::vector<double> omegas = pair_frequencies(s, report.quick ? intervals / 20 : intervals);
  omegas.insert(omegas.begin(), lowest);
  const BreatherPairs pairs =
      breather_pairs_at(s, {conditions(Centre::site, omega_b), conditions(Centre::bond, omega_b)},
                        omegas, measure_in<double>);
  const auto row = [](const BreatherPair& pair) {
    const Vector<double> away = pair.orbit[0].x * 1.000001;  // lest the coarser run keep it
    const auto coarse =
        newton(conditions(Centre::site, pair.omega), away, rule<double>(Resolution::coarse));
    const Estimate ratio = quotient(pair.amplitude[0], pair.amplitude[1]);
    return Row{{"omega", pair.omega},
               {"amplitude_bond", pair.amplitude[1]},
               {"amplitude_site", pair.amplitude[0]},
               {"energy_bond", pair.energy[1]},
               {"energy_site", pair.energy[0]},
               {"asymmetry", with_error(asymmetry(coarse), asymmetry(pair.orbit[0]))},
               {"amplitude_gap", Estimate{ratio.value - 1, ratio.error}},
               {"energy_gap", quotient(pair.equal_frequency, pair.energy[1])}};
  };
  report.table("branches").fill(pairs, row, "branches");
}

/**
## Small amplitude

Section 1 of the article says that the chain's breathers, like those of the DpS equation, nearly keep their width when
the amplitude goes to zero. As width we take the participation number of the displacements, $(\sum y_n^2)^2/\sum y_n^4$
at $t = 0$. Around a site it is [2.965](cell:widths/centre=site/omega=1.001/width) sites at $\omega_b = 1.001$,
[2.982](cell:widths/centre=site/omega=1.01/width) at 1.01, which the article calls small amplitude, and
[3.060](cell:widths/centre=site/omega=1.05/width) at 1.05. While the amplitude grows a hundredfold, the width grows by
less than 1 per cent; a width like $(\omega_b-1)^{-1/2}$, as in the discrete nonlinear Schrödinger equation, would
shrink to a third. So the statement holds up to 1.01 if *nearly* means 1 per cent, and not up to 1.05
(`chain.width_constant`).

For $s \in [-1, 1]$ the article finds that both families bifurcate from rest. There the force $s\,y^3$ is negligible:
between 1.0005 and 1.001, where the amplitude is below $10^{-6}$, it grows like $(\omega_b-1)^2$, as in Eq. (20), with
one exponent to 9 digits at $s = -1$, 0, 1: [2.001 ± 0.004](cell:other_wells/s=1/centre=site/exponent) for a site. */
/// The exponent of the amplitude in omega_b - 1 between two breathers: two near a bifurcation from rest, by Eq. (20),
/// zero where a family begins at a finite amplitude.
double growth_exponent(const Orbit<double>& lower, const Orbit<double>& upper) {
  return std::log(upper.amplitude / lower.amplitude) /
         std::log((upper.omega - 1) / (lower.omega - 1));
}

/// Participation number of the displacements at t = 0, (sum y^2)^2 / sum y^4, in sites, at two tolerances.
Estimate width_of(const Shooting<double>& problem) {
  const auto width = [&](Resolution resolution) {
    auto squares = find_breather(problem, Phase::compressed, rule<double>(resolution)).start.y;
    for (double& y_n : squares) y_n *= y_n;
    return participation(squares);
  };
  return with_error(width(Resolution::coarse), width(Resolution::fine));
}

void report_small_amplitude(Report& report) {
  Table &widths = report.table("widths"), &others = report.table("other_wells");
  for (Centre centre : both_centres) {
    for (double omega : {lowest, 1.005, 1.01, 1.05})
      widths.add({{"centre", name_of(centre)},
                  {"omega", omega},
                  {"width", width_of(conditions(centre, omega))}});

    // How the amplitude grows from rest in three wells
    for (int well : {-1, 0, 1}) {
      const auto orbits = breathers_at(conditions(centre, omega_b, well), {1.0005, lowest, 1.01});
      others.add({{"s", double(well)},
                  {"centre", name_of(centre)},
                  {"exponent", with_error(growth_exponent(orbits.at(1), orbits.at(2)),
                                          growth_exponent(orbits.at(0), orbits.at(1)))}});
    }
  }
}

/**
## Statement by statement

<!-- statements -->
| statement | printed | here | verdict |
|---|---|---|---|
| `newton.residual`: relative residual of the site-centred breather at omega_b = 1.1 on 31 particles after 5 iterations | 1.5e-9 | 2e-14 ± 2e-14 | quantified |
| `newton.variation`: relative variation of positions between the last iterates | 1.7e-11 | 0 ± 4e-13 | quantified |
| `newton.persistence`: positions at t = 100 T_b coincide with the initial ones | visually equal | hundred_periods.moved: 2.803e-12 < 0.01 | holds |
| `newton.decay`: tail decays super-exponentially on 99 particles | super-exponential | tail.size (n = -3), (n = -2), (n = -1): 0.2094 < 0.3472 (the closest of 27) | holds |
| `newton.qc_small`: quasi-continuum ansatz is excellent at omega_b = 1.01 | excellent | 0.05113 relative | quantified |
| `newton.qc_worse`: accuracy of the quasi-continuum ansatz deteriorates at omega_b = 1.1 | ordering | approximation.difference (centre = site, omega = 1.01), (centre = site, omega = 1.1): 0.05113 < 0.1176; approximation.difference (centre = bond, omega = 1.01), (centre = bond, omega = 1.1): 0.04755 < 0.09777 | holds |
| `newton.energy_equal`: energy curves of both families are indistinguishable for omega_b in (1; 2] | indistinguishable | branches.energy_gap (omega = 1.001): 1.186e-06 < 0.01 (the closest of 42) | holds |
| `newton.symmetry`: bond-centred: y_(1-n) = -y_n; site-centred: y_n(t) = -y_(-n)(t + T_b/2) | symmetry | symmetry.broken (centre = site, omega = 1.3): 8.007e-10 < 1e-08 (the closest of 10) | holds |
| `newton.any_s`: branches of both centres bifurcate from the origin for every s in [-1; 1] | exist | other_wells.exponent (s = -1, centre = site) away from 2: 0.0008169 < 0.05 (the closest of 6) | holds |
| `newton.grows`: amplitude and energy of both centres increase with omega_b | increase | branches.amplitude_site (omega = 1.975), (omega = 2): 2.285 < 2.457 (the closest of 164) | holds |
| `newton.site_asymmetry`: asymmetry of site-centred breathers under n -> -n increases with omega_b and is visible at 1.1 | increases | branches.asymmetry (omega = 1.975), (omega = 2): 0.4558 < 0.4637 (the closest of 42) | holds |
| `newton.amplitude_differs`: the amplitudes of the two centres differ visibly | visible | branches.amplitude_gap (omega = 2): 0.01 < 0.07143 (the closest of 42) | holds |
| `newton.amplitude_minor`: the differences of the amplitudes of the two centres are minor | minor | 0.1302 relative | quantified |
| `chain.width_constant`: the width of the chain's breathers remains nearly constant at small amplitude | nearly constant | widths.width (centre = site, omega = 1.001), (centre = site, omega = 1.005), (centre = site, omega = 1.01): 0.005864 < 0.01; widths.width (centre = bond, omega = 1.001), (centre = bond, omega = 1.005), (centre = bond, omega = 1.01): 0.00904 < 0.01 | holds, assuming |
<!-- /statements -->

## Try it

**To change it.** The frequency of the first breather is `omega_b`, up to 1.1, and `sites` its chain. `s` is the well of
the chapter; below zero the branches turn back before 2, and the last of `searched` has to be smaller (1.7 for
$s = -0.5$). Another contact is for instance `without_cutoff(PowerContact{1.8})` (then `least_kept` is $10^{-3}$); another well
replaces `Quartic{anharmonicity}` in `conditions` (with `Pendulum{}` the last of `searched` is 1.7).

1. *Easy.* How does the amplitude grow with $\omega_b - 1$?
   `build/bin/sec32_newton_breathers breather --centre bond --omega 1.002` gives `amplitude` = 3.53917e-6. Hint: at
   1.001 it is a quarter of that; Eq. (20) says why.
2. *Harder.* What is the law of exercise 1 for contacts of another exponent?
   `build/bin/sec32_newton_breathers breather --contact power --alpha 2 --omega 1.1` gives `amplitude` = 0.0998154.
   Hint: the shift of the frequency goes like the contact force over the displacement, amplitude$^{\alpha-1}$. */
void reproduce(Report& report) {
  report.output.note("tolerance", "flow to 128 and 2048 roundings of the type");
  report_convergence(report);
  report_symmetry(report);
  report_profiles(report);
  report_persistence(report);
  report_tail(report);
  report_branches(report);
  report_small_amplitude(report);
}

int main(int argc, char** argv) {
  return run({"sec32_newton_breathers", "3.2", "Static breathers of the chain (section 3.2)",
              reproduce, commands<OneBreather>()},
             argc, argv);
}
