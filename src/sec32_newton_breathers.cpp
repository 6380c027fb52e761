/**
# 3.2 Static breathers of the chain

Does the chain have static breathers, and how accurately can they be computed? Section 3.2 of James, Kevrekidis and
Cuevas (Physica D 251, 2013) finds two families by Newton's method, and so do we, at every frequency up to $2$. If the
equations use the symmetry of the breather, the method reaches machine precision in four steps; the article's equations,
without symmetry, are ill-conditioned along one direction, a shift of the breather along the chain. The amplitudes of
the two families differ visibly, their energies by little more than a millionth at most, which suggests that a breather
moves at little cost (section 3.3).

A breather is a time-periodic motion in which a few beads carry nearly all the energy and neighbours oscillate out of
phase, either around a *site*, one bead against both of its neighbours, or around a *bond*, two neighbours against each
other. Breathers are usually continued from the *anticontinuous limit*, where the sites are decoupled and one of them
oscillates (MacKay and Aubry, Nonlinearity 7, 1994; Marín and Aubry, Nonlinearity 9, 1996). In linear wells all
decoupled beads have the frequency 1, so the article starts from the limit of small amplitude instead, the DpS breathers
of the previous chapter.

![Bond-centred breathers, of the DpS equation and of the chain, and their quasi-continuum approximation. Drawn by
fig02_bond_centred.gp: the columns of `bond_profiles` against `n`.](fig:02)

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
The chain has free ends; all quantities are dimensionless. A breather starts from rest, so the positions $y_n(0)$ are
the unknowns, and its motion is even in time. A reflection of the chain must also change the sign of all positions,
since contacts only push. Around a bond the breather is its own image, $y_{1-n} = -y_n$, so half of the chain suffices;
since an even periodic motion is also even about $T_b/2$, all beads are at rest there. Around a site the image is the
breather half a period later, $y_n(t) = -y_{-n}(t+T_b/2)$. With the evenness this gives $y_n(T_b/4) = -y_{-n}(T_b/4)$
and $\dot y_n(T_b/4) = \dot y_{-n}(T_b/4)$. So the conditions, as many as unknowns, are
$$\dot y_n(T_b/2) = 0 \quad\text{(bond)},\qquad
  y_n+y_{-n} = 0,\quad \dot y_n-\dot y_{-n} = 0 \quad\text{at } t = T_b/4 \quad\text{(site)}.$$ */
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "commands/one_breather.hpp"
#include "lattice/algebra/dense.hpp"
#include "lattice/diagnostics/observe.hpp"
#include "lattice/events/event_driven.hpp"
#include "lattice/model/dps.hpp"
#include "lattice/numerics/parallel.hpp"
#include "lattice/orbits/breather.hpp"
#include "lattice/orbits/breather_pairs.hpp"
#include "lattice/orbits/shooting.hpp"
#include "lattice/standing/stationary.hpp"
#include "report/program.hpp"
#include "sec3/static_breathers.hpp"

using namespace lattice;

/**
## The experiment

We look for the breather around a site at $\omega_b = 1.1$ on 31 beads, as in the article; around a bond we take one
more. The guess is the article's (`ansatz`): $y_n(0) = 2\epsilon\,u_n$ with $\epsilon = [2\tau_0(\omega_b-1)]^2$ and the
quasi-continuum profile $u_n$ of Eq. (19). `evaluate` integrates over a quarter of the period (around a bond over half
of it) and returns the conditions $R$ and their derivative $DR$, the same combinations taken of the linearised flow. Its
steps have variable length and order and end at every *contact event*, the opening or closing of a contact; their error
is relative to the largest displacement (event_driven.hpp). The numbers of the text are computed at two tolerances or in
two precisions, and the difference is their error. */
constexpr std::size_t sites = 31;       // around a site, and one more around a bond
constexpr double omega_b = 1.1;         // frequency of the breather of figures x44, 4 and 5
constexpr double s = 0;                 // anharmonicity of the wells
const Contact contact = bare(Hertz{});  // without a cutoff of the force, since the tail counts
const double alpha = contact.exponent();
constexpr int article_steps = 5;       // of Newton's method
constexpr int most_steps = 10;         // of ours
constexpr double pinning = 1e-5;       // relative singular values below it are left out
constexpr double perturbation = 1e-3;  // of the start of a search without symmetry,
constexpr std::array searched{1.01, 1.1, 1.3, 1.5, 2.0};  // at these frequencies
constexpr std::array small_and_large{1.01, 1.1};          // the frequencies of figures 2 and 3
constexpr int periods = 100;                              // of figure 4
constexpr std::size_t tail_sites = 99;                    // of figure 5, and in extended precision
constexpr std::size_t tail_sites_wide = 63;
constexpr int intervals = 80;     // of the frequency from 1 to 2 in figure 6
constexpr double lowest = 1.001;  // the first frequency there
constexpr double beside =
    1.000001;  // a run that is only compared starts off the orbit by this factor
enum Resolution { fine, coarse };  // of the flow: 128 and 2048 machine epsilons

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
using Path = std::vector<Iterate>;

/// x <- x - DR(x)^-1 R(x), without singular values of DR below `least_singular`, relative to the largest.
Path iterate(const Shooting<double>& problem, Resolution resolution, double least_singular = 0) {
  const std::size_t beads = problem.chain.sites;
  const Centre centre = beads % 2 == 1 ? Centre::site : Centre::bond;
  Vector<double> x =
      problem.reduce(ansatz(centre, problem.omega, beads, Phase::compressed, contact));
  Path path;
  while (path.size() <= most_steps) {
    const Evaluation<double> now = problem.evaluate(x, rule<double>(resolution).events);
    const Vector<double>& R = now.residual;
    const Matrix<double>& DR = now.jacobian;
    // Each bead in its own unit, since the tail falls double-exponentially; least squares in one unit
    const bool square = DR.rows() == DR.cols();
    const Vector<double> step =
        solve_scaled<double>(DR, R, problem.sizes(x, square), least_singular);
    path.push_back({x, sup(R) / sup(x), sup(step) / sup(x), condition_of(DR)});
    x -= step;
  }
  return path;
}

/**
The other breathers of this chapter come from the library's `newton`, which makes these steps for any symmetry and
precision until the residual no longer falls, and from `find_breather`, which starts at $\omega_b = 1.1$ at most,
continues the branch to the frequency, and rejects a motion in which neighbours oscillate in phase. An independent
program (`tests/second`), with another integrator, finds the same breathers at 1.1.

## Convergence of Newton's method

The article solves other equations: all positions and velocities return after the whole period, twice as many equations
as unknowns, in the sense of least squares. Its measure of the error is this return, relative to the start. What is the
cost of leaving out the symmetry?

![Residual of Newton's method, relative to the amplitude, for three sets of equations; dotted: the least singular value
of the whole period, relative to the largest; grey: the article's residual after five steps. Drawn by
x44_newton_steps.gp from `iterations`.](fig:x44)

With the symmetric equations the number of correct digits doubles in each step, and after
[4](cell:convergence/equations=quarter_period/steps) steps machine precision is the limit. The article's equations begin
alike, but in the fourth step the residual *rises*, by three orders, and it needs seven steps to reach machine
precision. The reason is an ill-conditioned direction: where a singular value of $DR$ is small, what is left of the
residual gives a large step. The least singular vector is nearly the discrete gradient $y_{n+1}-y_{n-1}$ of the
breather, which shifts it along the chain (the cosine of their angle is
[0.987](cell:convergence/equations=whole_period/steps=5/pinning)): the *pinning mode* of section 3.3 (Chen, Aubry and
Tsironis, Phys. Rev. Lett. 77, 1996). Its singular value becomes small only close to the solution, within three steps.
The fourth step is then [6.30e-3](cell:convergence/equations=whole_period/steps=4/step) long, a shift along the chain
whose square is of the order of the new residual. Even after ten steps the next one is
[8e-9](cell:convergence/equations=whole_period/steps=10/next_step), of the order of the residual, at machine precision,
over the singular value. If least squares leave out the singular values below $10^{-5}$, there is no rise and the steps
soon vanish, but what is left of the residual along the pinning mode is never corrected. Symmetry excludes this mode
from the beginning.

| at $\omega_b = 1.1$, relative to the amplitude | residual | next step | condition of $DR$ |
|---|---|---|---|
| a quarter of the period, [4](cell:convergence/equations=quarter_period/steps) steps | [4e-14](statement:newton.residual) | [7e-14](statement:newton.variation) | [22.3](cell:convergence/equations=quarter_period/condition) |
| the whole period, five steps | [3.61e-10](cell:convergence/equations=whole_period/steps=5/residual) | [1.00e-5](cell:next_step) | [1.75e6](cell:condition) |
| pinning mode left out, five steps | [2.01e-9](cell:convergence/equations=without_pinning_mode/residual) | rounding | [1.77e6](cell:condition) |

The article prints a residual of $1.5\cdot10^{-9}$ after five steps and a last change of $1.7\cdot10^{-11}$. Both lie
between those of the last two rows, but the last changes of these are nine orders apart; and the article does not say
how it treated the pinning mode, so neither number is judged. */
void report_convergence(Report& report) {
  // The same iteration on a quarter of the period and on the whole, with and without the pinning mode
  const auto problem = conditions(Centre::site, omega_b);
  Shooting<double> whole = problem;
  whole.symmetry = returning(problem.chain.sites);
  const Path path = iterate(problem, fine), all = iterate(whole, fine),
             without = iterate(whole, fine, pinning);
  Table& history = report.table("iterations");
  for (std::size_t k = 0; k < path.size(); ++k)
    history.add({{"steps", "steps of Newton's method", k},
                 {"quarter_period", "residual over the amplitude", path[k].residual},
                 {"whole_period", "the same of the article's equations", all[k].residual},
                 {"without_pinning_mode", "without steps along it", without[k].residual},
                 {"singular", "least singular value of whole_period over the largest",
                  1 / all[k].soft.condition}});

  // Some of the points in numbers, from two tolerances
  const Orbit<double> breather = find_breather(problem);
  const std::size_t steps = breather.iterations();
  Table& table = report.table("convergence");
  const auto add = [&](const char* equations, std::size_t k, const Path& rough, const Path& best) {
    const auto both = [&](const auto& number) {
      return compare(number(rough[k]), number(best[k]));
    };
    const char* size = "of two resolutions, against the largest: the others are rounding";
    table.add(
        {{"equations", "the time after which they are imposed, and how", equations},
         {"steps", "steps of Newton's method", k},
         {"residual", "change after a whole period, in extended precision, over the amplitude",
          both([&](const Iterate& at) { return return_after_period(problem, at.x); }), "", size},
         {"step", "the last of these steps over the amplitude",
          compare(rough[k - 1].step, best[k - 1].step), "", size},
         {"next_step", "the step after them over the amplitude",
          both([](const Iterate& at) { return at.step; }), "", size},
         {"energy_excess", "energy at this point minus that of the breather",
          both([&](const Iterate& at) {
            return energy(problem.chain, problem.expand(at.x)) - breather.energy;
          }),
          "", size},
         {"condition", "condition number of the equations",
          both([](const Iterate& at) { return at.soft.condition; })},
         {"pinning", "|cos| of the angle between least singular vector and discrete gradient",
          both([](const Iterate& at) {
            return alignment(at.soft.softest, gradient({at.x.begin(), at.x.end()}));
          })}});
  };
  add("quarter_period", steps, iterate(problem, coarse), path);
  const Path all_coarse = iterate(whole, coarse);
  for (int k : {article_steps - 1, article_steps, most_steps})
    add("whole_period", k, all_coarse, all);
  add("without_pinning_mode", article_steps, iterate(whole, coarse, pinning), without);
}

/**
## Are the breathers really symmetric?

Since the symmetries are imposed, finding them in the result proves nothing. We therefore search without them: all
positions are unknown, the start is perturbed at random by a thousandth, and the only condition is that the chain is at
rest at $T_b/2$ (`broken_symmetry`). In a continuous family of asymmetric breathers through ours the result would keep
an asymmetry of about this size. In extended precision (a 64-bit mantissa) both symmetries are restored to $10^{-9}$ of
the amplitude at five frequencies up to 2 (`newton.symmetry`). So we find no sign of such a family; an asymmetric
breather elsewhere is not excluded. */
std::string name_of(Centre centre) {
  return centre == Centre::site ? "site" : "bond";
}

void report_symmetry(Report& report) {
  Table& table = report.table("symmetry");
  for (Centre centre : both_centres)
    for (double omega : searched)
      table.add({{"centre", "site or bond", name_of(centre)},
                 {"omega", "breather frequency", omega},
                 {"broken", "largest violation of the symmetry over the amplitude",
                  compare(0.0, broken_symmetry(conditions(centre, omega), perturbation, 7)), "",
                  "relative to the amplitude, distance from zero"}});
}

/**
## Profiles (figures 2 and 3)

How good is the quasi-continuum approximation? It is accurate to 5 per cent of the amplitude where the article calls it
excellent (`newton.qc_small`), and twice as bad at 1.1, as the article says (`newton.qc_worse`).

![Site-centred breathers and their quasi-continuum approximation. Drawn by fig03_site_centred.gp: the columns of
`site_profiles` against `n`.](fig:03)

There are two errors, and the table has both. The quasi-continuum profile differs from the DpS breather even in the
limit; the chain differs from the DpS equation by a fraction that grows with $\omega_b-1$. They partly cancel: at 1.01
the approximation is closer to the chain than to the DpS breather for which it was made.

| largest difference over the amplitude | around a site | around a bond |
|---|---|---|
| quasi-continuum and DpS | [0.0575](statement:dps.qc_site) | [0.0614](statement:dps.qc_bond) |
| DpS and chain, $\omega_b = 1.01$ | [0.0136](cell:approximation/centre=site/omega=1.01/dps) | [0.0132](cell:centre=bond/dps) |
| DpS and chain, $\omega_b = 1.1$ | [0.129](cell:approximation/centre=site/omega=1.1/dps) | [0.129](cell:centre=bond/dps) |
| quasi-continuum and chain, $\omega_b = 1.01$ | [0.0511](cell:approximation/centre=site/omega=1.01/difference) | [0.0475](cell:centre=bond/difference) |
| quasi-continuum and chain, $\omega_b = 1.1$ | [0.118](cell:approximation/centre=site/omega=1.1/difference) | [0.0978](cell:centre=bond/difference) | */
void report_profiles(Report& report) {
  Table& differences = report.table("approximation");
  for (Centre centre : both_centres) {
    const std::size_t beads = conditions(centre, omega_b).chain.sites;
    const auto u = stationary<double>(centre, 1, beads, alpha).u;
    std::vector<State<double>> breathers, guesses;
    for (double omega : small_and_large) {
      const auto orbit = [&](Resolution resolution) {
        return find_breather(conditions(centre, omega), Phase::compressed,
                             rule<double>(resolution));
      };
      const TwoRuns<Orbit<double>> orbits{orbit(coarse), orbit(fine)};
      const auto difference = [&](const State<double>& other) {
        return orbits.of([&](const Orbit<double>& found) {
          return largest_difference(found.start, other) / found.amplitude;
        });
      };
      State<double> limit(beads);  // 2 epsilon u_n
      for (std::size_t i = 0; i < beads; ++i) limit.y[i] = 2 * breather_eps(omega, alpha) * u[i];
      breathers.push_back(orbits.fine.start);
      guesses.push_back(ansatz(centre, omega, beads, Phase::compressed, contact));
      differences.add(
          {{"centre", "site or bond", name_of(centre)},
           {"omega", "frequency", omega},
           {"difference", "largest difference over the amplitude", difference(guesses.back())},
           {"dps", "the same from the DpS breather", difference(limit)}});
    }

    // What the figures show
    Table& table = report.table(name_of(centre) + "_profiles");
    for (std::size_t i = 0; i < beads; ++i) {
      const long n = site_number(i, beads);
      table.add(
          {{"n", "site", n, "site"},
           {"u", "stationary DpS breather, mu = 1", u[i]},
           {"u_continuum", "its quasi-continuum approximation", quasi_continuum(centre, n, alpha)},
           {"y_101", "positions at t = 0 at the first frequency", breathers[0].y[i]},
           {"y_101_continuum", "quasi-continuum approximation", guesses[0].y[i]},
           {"y_110", "positions at t = 0 at the second frequency", breathers[1].y[i]},
           {"y_110_continuum", "quasi-continuum approximation", guesses[1].y[i]}});
    }
  }
}

/**
## A hundred periods (figure 4)

The article finds the positions visually equal after a hundred periods; they have moved by
[3e-12 ± 2e-12](cell:hundred_periods/moved) of the amplitude, hardly more than two tolerances differ.

![The breather at the start and after a hundred periods. Drawn by fig04_hundred_periods.gp: `y_start` and `y_end` of
`persistence` against `n`.](fig:04) */
void report_persistence(Report& report) {
  const auto problem = conditions(Centre::site, omega_b);
  const State<double> start = find_breather(problem).start;
  std::array<State<double>, 2> end{start, start};
  for (Resolution resolution : {fine, coarse})
    for (int period = 0; period < (report.quick ? periods / 10 : periods); ++period)
      flow(problem.chain, end[resolution], problem.period(), rule<double>(resolution).events);
  const auto& [last, other] = end;
  report.table("hundred_periods")
      .add(Row{{"moved", "largest change of positions and velocities over the amplitude",
                Estimate{largest_difference(last, start) / largest(start),
                         largest_difference(last, other) / largest(start)},
                "", "relative, of two tolerances"}});
  Table& table = report.table("persistence");
  for (std::size_t i = 0; i < start.y.size(); ++i)
    table.add({{"n", "site", site_number(i, start.y.size()), "site"},
               {"y_start", "positions at t = 0", start.y[i]},
               {"y_end", "positions after 100 periods", compare(other.y[i], last.y[i])}});
}

/**
## The tail (figure 5)

A bead far out feels only its inner neighbour, with a force that is the power $3/2$ of the neighbour's displacement, so
that $\ln|y_{n+1}|/\ln|y_n| \to 3/2$: the decay is double-exponential. At the last site where it can be computed we find
[1.500](cell:tail/n=20/exponent), with the change from the site before as its error; an exponential tail would have 1.

![The tail of the site-centred breather. Drawn by fig05_tail.gp: `size`, `double_log` and `law` of `tail` against
`n`.](fig:05)

Newton's method follows the tail to $10^{-308}$ in double precision and much farther in extended precision, if every
site must converge relative to its own size (`scaled_rule`); where both exist their difference is the error. Outwards
from the centre the ratio of neighbouring displacements falls from each pair to the next, on both sides and to the end
of double precision (`newton.decay`). */
void report_tail(Report& report) {
  const Tail<double> size(conditions(Centre::site, omega_b, s, tail_sites));
  const Tail<Wide> wide(conditions(Centre::site, omega_b, s, tail_sites_wide));
  long last = 0;
  while (wide(last + 1) > 0) ++last;

  // Site by site, with the law |y_(n+1)| ~ |y_n|^(3/2) from the last site inwards
  Table& table = report.table("tail");
  for (long n = -long(tail_sites / 2); n <= long(tail_sites / 2); ++n) {
    const bool known = size(n) > 1e-300 && wide(n) > 0;
    const double before = n == 0 ? undefined.value : wide.exponent(n < 0 ? n + 1 : n - 1);
    table.add({{"n", "site", n, "site"},
               {"size", "|y_n(0)| in double precision; nan where it underflows",
                known ? Estimate{size(n), std::abs(double(size(n) - wide(n)))} : undefined, "",
                "difference from extended precision; nan where size is"},
               {"exponent", "ln |y_(n+1)| / ln |y_n|, outwards from the centre",
                compare(before, wide.exponent(n)), "",
                "change from the site before, known to 15 per cent; nan at the centre and where "
                "the tail ends"},
               {"double_log", "ln(-ln |y_n(0)|) in extended precision", wide.double_log(n)},
               {"law", "double_log by the law |y|^alpha, from the outermost site inwards",
                wide.double_log(last) + double(std::abs(n) - last) * std::log(alpha)}});
  }
}

/**
## The branches (figure 6)

Both families are continued by arclength from $\omega_b = 1.001$ to $2$ (continuation.hpp). Amplitude and energy grow
from each frequency of the figure to the next, and so does the asymmetry around a site, where the breather is its own
mirror image only in the limit of small amplitude.

![Amplitude and energy of both families. Drawn by fig06_branches.gp: amplitudes and energies of `branches` against
`omega`.](fig:06)

The surprise is how nearly the energies of the two kinds agree while their amplitudes differ by a tenth. The relative
difference is largest at the lowest frequency. Towards $\omega_b = 1$ it tends to that of the two DpS norms, from bond
to site $1.331\cdot10^{-6}$ ([-1.331e-6](cell:sec32_dps_profiles/norms/gap) from site to bond).

| $\omega_b$ | amplitude, site over bond, minus one (article: visible) | the same of the energies (article: indistinguishable) | asymmetry |
|---|---|---|---|
| 1.001 | [0.0906](cell:branches/omega=1.001/amplitude_gap) | [1.186e-6](cell:energy_gap) | [0.000515](cell:asymmetry) |
| 1.1 | [0.0985](cell:branches/omega=1.1/amplitude_gap) | [1.06e-7](cell:energy_gap) | [0.0506](cell:asymmetry) |
| 1.725 | [0.130](cell:branches/omega=1.725/amplitude_gap) | [1.28e-8](cell:energy_gap) | [0.365](cell:asymmetry) |
| 2 | [0.0714](cell:branches/omega=2/amplitude_gap) | [-6.08e-8](cell:energy_gap) | [0.464](cell:asymmetry) | */
void report_branches(Report& report) {
  // Both families, frequency by frequency, at two tolerances
  std::vector<double> omegas = pair_frequencies(s, report.quick ? intervals / 16 : intervals);
  omegas.insert(omegas.begin(), lowest);
  const BreatherPairs pairs =
      breather_pairs_at(s, {conditions(Centre::site, omega_b), conditions(Centre::bond, omega_b)},
                        omegas, measure_in<double>);
  const auto row = [](const BreatherPair& pair) {
    const auto& [site, bond] = pair.orbit;
    const auto& [energy_site, energy_bond] = pair.energy;
    const auto& [amplitude_site, amplitude_bond] = pair.amplitude;
    const auto coarse_site = newton(conditions(Centre::site, pair.omega),
                                    Vector<double>(site.x * beside), rule<double>(coarse));
    const Estimate ratio = quotient(amplitude_site, amplitude_bond);
    return Row{
        {"omega", "frequency", pair.omega},
        {"amplitude_bond", "largest |y_n(0)|", amplitude_bond},
        {"amplitude_site", "largest |y_n(0)|", amplitude_site},
        {"energy_bond", "energy of the bond-centred breather", energy_bond},
        {"energy_site", "energy of the site-centred breather", energy_site},
        {"asymmetry", "largest |y_n(0) - y_-n(0)| around a site, over the amplitude",
         compare(asymmetry(coarse_site), asymmetry(site))},
        {"amplitude_gap", "amplitude_site over amplitude_bond, minus one",
         Estimate{ratio.value - 1, ratio.error}},
        {"energy_gap", "E_site - E_bond, over E_bond", quotient(pair.equal_frequency, energy_bond),
         "", "difference of two resolutions, against the largest"}};
  };
  report.table("branches").fill(pairs, row, "branches");
}

/**
## Small amplitude

Two statements concern the beginning of the branches. A breather of the DpS equation keeps its width when its amplitude
goes to zero, and section 1 of the article says that those of the chain nearly do. As width we take the participation
number of the displacements, $(\sum y_n^2)^2/\sum y_n^4$ at $t = 0$. Up to 1.01, which the article calls small
amplitude, the amplitude grows a hundredfold and the width by less than 1 per cent. A width like $(\omega_b-1)^{-1/2}$,
as in the discrete nonlinear Schrödinger equation, would shrink to a third. So the statement holds up to 1.01 if
*nearly* means 1 per cent, and not up to 1.05 (`chain.width_constant`).

| width in sites, $\omega_b$ | 1.001 | 1.01 | 1.05 |
|---|---|---|---|
| around a site | [2.965](cell:widths/centre=site/omega=1.001/width) | [2.982](cell:omega=1.01/width) | [3.060](cell:omega=1.05/width) |
| around a bond | [2.973](cell:widths/centre=bond/omega=1.001/width) | [3.000](cell:omega=1.01/width) | [3.122](cell:omega=1.05/width) |

For $s \in [-1, 1]$ the article finds that both families bifurcate from rest, without showing them. The reason is that
the force $s\,y^3$ is negligible there: between 1.0005 and 1.001, where the amplitude is below $10^{-6}$, it grows like
$(\omega_b-1)^2$, as in Eq. (20), with one exponent to nine digits at $s = -1$, 0 and 1. Around a site the exponent is
[2.001 ± 0.004](cell:other_wells/s=1/centre=site/exponent), its error the change to the next pair of frequencies. */
void report_small_amplitude(Report& report) {
  Table &widths = report.table("widths"), &others = report.table("other_wells");
  for (Centre centre : both_centres) {
    for (double omega : {lowest, 1.002, 1.005, 1.01, 1.05}) {
      const Widths width = widths_of(conditions(centre, omega));
      widths.add(
          {{"centre", "site or bond", name_of(centre)},
           {"omega", "frequency", omega},
           {"width", "participation number of the displacements, (sum y^2)^2 / sum y^4",
            width.displacements, "site"},
           {"width_energy", "participation number of the energy densities, (sum e)^2 / sum e^2",
            width.energies, "site"}});
    }

    // How the amplitude grows from rest in three wells
    for (int well : {-1, 0, 1}) {
      const auto orbits = breathers_at(conditions(centre, omega_b, well), {1.0005, lowest, 1.01});
      others.add({{"s", "anharmonicity of the well", double(well)},
                  {"centre", "site or bond", name_of(centre)},
                  {"exponent", "of the amplitude in omega_b - 1, at 1.0005",
                   compare(growth_exponent(orbits.at(1), orbits.at(2)),
                           growth_exponent(orbits.at(0), orbits.at(1))),
                   "", "change from the next pair of frequencies"}});
    }
  }
}

/**
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
| `newton.symmetry`: bond-centred: y_(1-n) = -y_n; site-centred: y_n(t) = -y_(-n)(t + T_b/2) | symmetry | symmetry.broken (centre = site, omega = 1.3): 8.007e-10 < 1e-08 (the closest of 10) | holds |
| `newton.any_s`: branches of both centres bifurcate from the origin for every s in [-1; 1] | exist | other_wells.exponent (s = -1, centre = site) away from 2: 0.0008169 < 0.05 (the closest of 6) | holds |
| `newton.grows`: amplitude and energy of both centres increase with omega_b | increase | branches.amplitude_site (omega = 1.988), (omega = 2): 2.37 < 2.457 (the closest of 324) | holds |
| `newton.site_asymmetry`: asymmetry of site-centred breathers under n -> -n increases with omega_b and is visible at 1.1 | increases | branches.asymmetry (omega = 1.988), (omega = 2): 0.4598 < 0.4637 (the closest of 82) | holds |
| `newton.amplitude_differs`: the amplitudes of the two centres differ visibly | visible | branches.amplitude_gap (omega = 2): 0.01 < 0.07143 (the closest of 82) | holds |
| `newton.amplitude_minor`: the differences of the amplitudes of the two centres are minor | minor | 0.1302 relative | quantified |
| `chain.width_constant`: the width of the chain's breathers remains nearly constant at small amplitude | nearly constant | widths.width (centre = site, omega = 1.001) and 3 other values: 0.005864 < 0.01; widths.width (centre = bond, omega = 1.001) and 3 other values: 0.00904 < 0.01 | holds, assuming |
<!-- /statements -->

## Try it

**To change it.** The frequency of the first breather is `omega_b`, up to 1.1, and `sites` its chain. `s` is the well of
the chapter; below zero the branches turn back before 2, and the last of the frequencies `searched` has to be smaller
(1.7 for $s = -0.5$). The contact is `contact`, for instance `bare(PowerContact{1.8})` (the singular value of the
pinning mode is then larger, and `pinning` $10^{-3}$); another well replaces `Quartic{anharmonicity}` in `conditions`.

1. *Easy.* How does the amplitude grow with $\omega_b - 1$?
   `build/bin/sec32_newton_breathers breather --centre bond --omega 1.002` gives `amplitude` = 3.53917e-6. Hint: at
   1.001 it is a quarter of that; Eq. (20) says why.
2. *Harder.* What is the law of exercise 1 for contacts of another exponent?
   `build/bin/sec32_newton_breathers breather --contact power --alpha 2 --omega 1.1` gives `amplitude` = 0.0998154.
   Hint: the shift of the frequency goes like the contact force over the displacement, amplitude$^{\alpha-1}$.

The command `breather` computes a breather with your own parameters (commands/one_breather.hpp). */
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
