/**
# 2 No breathers without wells

Section 2 of James, Kevrekidis and Cuevas (Physica D 251, 2013) proves that beads which only repel each other have no
breathers: no motion of theirs is both periodic in time and localized in space. The proof is one integral. Bead $n$
obeys $m_n\ddot x_n = F_{n-1} - F_n$ with the push $F_n \ge 0$ of contact $n$, and over a period $T$
$$0 = m_n\bigl[\dot x_n(T)-\dot x_n(0)\bigr] = \int_0^T F_{n-1}\,dt - \int_0^T F_n\,dt :$$
the mean push $\bar F_n$ is the same at every contact (`thm.mean_force`). Far away from a localized motion the pushes
tend to zero, so this mean is zero. A push that is never negative and zero in the mean is zero always: the beads are
free, and a periodic motion of free beads is rest.

No computation proves a theorem, but ours could have refuted it: by a search that ends in a breather, or by a localized
state that stays together. (Equal means follow from Newton's law for every periodic motion; there we test our motions
and averages.) Each instrument is also tried where it must find something, in the wells of section 3. There the mean
force of a well balances unequal pushes on the two sides of its bead, so that $\bar F_n$ may fall off outwards, and
there are breathers.

![Mean contact forces are the same at every contact of free chains (a) and not in wells (b); how searches from small
and large starts end (c); energy and mean force of a localized state (d, e). Drawn by x16_mean_force.py from
`mean_forces` (`relative` against `n`), `searches` and `dispersal` (`core` and `mean` against `t`).](fig:x16) */
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "lattice/diagnostics/observe.hpp"
#include "lattice/gsl/gsl_ode.hpp"
#include "lattice/integrators/event_corrected.hpp"
#include "lattice/integrators/integrate.hpp"
#include "lattice/numerics/parallel.hpp"
#include "lattice/orbits/breather.hpp"
#include "report/program.hpp"
#include "sec2/periodic_motions.hpp"
#include "sec2/searches.hpp"

using namespace lattice;

/**
## Model

The chain is that of Eqs. (1) and (3). Each bead has its own mass, each contact its stiffness and exponent,
$$m_n\ddot x_n = F_{n-1}-F_n,\qquad F_n = \gamma_n\,(x_n-x_{n+1})_+^{\alpha_n},$$
(`mass`, `eta` and `exponent` in the program). In wells $W$ the balance of a bead over a time $T$ reads
$$\frac{m_n}{T}\bigl[\dot x_n\bigr]_0^T = \bar F_{n-1}-\bar F_n-\overline{W'(x_n)}.$$
The left side vanishes over a period. All quantities are dimensionless.

## The experiment

Take a periodic motion and average the push of every contact over its period. The averages are further unknowns of the
equations of motion, which GSL integrates with an adaptive step: a route that shares nothing with the one by which the
motion was found. Two tolerances, $10^{-11}$ and $10^{-13}$, give each number with its error. */
struct Means {
  std::vector<double> push;  // of every contact, from the one to the left of the first bead on
  std::vector<double> well;  // of W' at every bead
  State<double> end;         // where the chain is after the time of the average
};

template <class AnyChain>
Means mean_forces(const AnyChain& chain, const State<double>& start, double period,
                  double tolerance) {
  // Positions, velocities, and the integrals of all pushes and of the forces of all wells
  const std::size_t N = chain.sites;
  std::vector<double> z(4 * N + 1, 0);
  std::copy(start.y.begin(), start.y.end(), z.begin());
  std::copy(start.v.begin(), start.v.end(), z.begin() + long(N));
  const auto equations = [&](double, const double* x, double* dx) {
    for (std::size_t i = 0; i <= N; ++i) dx[2 * N + i] = contact_push(chain, x, i);
    for (std::size_t n = 0; n < N; ++n) {
      const double pull = -chain.well.force(x[n]);
      dx[3 * N + 1 + n] = pull;
      dx[n] = x[N + n];
      dx[N + n] = (dx[2 * N + n] - dx[2 * N + n + 1] - pull) / chain.mass_of(n);
    }
  };
  double t = 0;
  Reference(equations, z.size(), tolerance).advance(t, period, z);
  const auto part = [&](std::size_t from, std::size_t count, double over) {
    std::vector<double> out(z.begin() + long(from), z.begin() + long(from + count));
    for (double& x : out) x /= over;
    return out;
  };
  Means means{part(2 * N, N + 1, period), part(3 * N + 1, N, period), State<double>(N)};
  means.end.y = part(0, N, 1), means.end.v = part(N, N, 1);
  return means;
}

/**
Two numbers say what the theorem asks for: the spread of the mean push over the contacts, relative to the largest, and
the amount by which the balance of a bead is missed. */
struct Balance {
  double largest, spread, imbalance;

  Balance(const Means& m, bool outermost) {  // whether the outermost contacts exist
    const long skip = outermost ? 0 : 1;
    const auto [least, most] = std::minmax_element(m.push.begin() + skip, m.push.end() - skip);
    largest = *most, spread = (*most - *least) / largest, imbalance = 0;
    for (std::size_t n = 0; n < m.well.size(); ++n)
      imbalance = std::max(imbalance, std::abs(m.push[n] - m.push[n + 1] - m.well[n]) / largest);
  }
};

struct Motion {
  std::string name;
  Means coarse, fine;
  bool outermost;  // on a ring, or between walls

  /// One of the numbers of its balance, in some unit.
  Estimate number(double Balance::*of, double unit = 1) const {
    return compare(Balance(coarse, outermost).*of / unit, Balance(fine, outermost).*of / unit);
  }
};

template <class AnyChain>
Motion averaged(const std::string& name, const AnyChain& chain, const State<double>& start,
                double period, bool outermost) {
  Motion m{name, mean_forces(chain, start, period, 1e-11), mean_forces(chain, start, period, 1e-13),
           outermost};
  // Periodic or not, pushes and wells must add up to the change of momentum of each bead
  for (std::size_t n = 0; n < chain.sites; ++n) {
    const double gained = chain.mass_of(n) * (m.fine.end.v[n] - start.v[n]) / period;
    const double given = m.fine.push[n] - m.fine.push[n + 1] - m.fine.well[n];
    if (!(std::abs(gained - given) < 1e-9 * largest(start)))
      throw Failure("the mean pushes do not balance the momentum of a bead");
  }
  return m;
}

/**
The balance of a bead with its change of momentum holds for any motion, so each run must obey it to $10^{-9}$, or the
program stops: that would be an error of our averages.

## Equal means in free chains (figure x16 a)

On a localized motion of the free chain all means would be zero, but no such motion exists. So we check the identity on
motions that fill a ring or a box, found by *shooting*. Let $z$ be the positions and velocities at $t = 0$ and
$\Phi_T(z)$ those after a period. A periodic motion is a zero of $R(z) = \Phi_T(z)-z$. Newton's method corrects a guess,
$$z \leftarrow z - \delta,\qquad \bigl(D\Phi_T(z) - 1\bigr)\,\delta = R(z),$$
with $D\Phi_T$ from the linearised equations of motion. Far from a solution a step is halved until it lowers $|R|$.
Where a motion may be shifted in time or along the chain the matrix is singular, and of all solutions $\delta$ we take
the shortest. A motion that begins at rest is at rest again after $T/2$, which halves the number of equations
(shooting.hpp).

We need chains on which only the theorem makes the means equal. On a ring of equal beads symmetry alone does, so this
case checks the instrument. On two others masses and stiffnesses differ by 15 per cent from bead to bead, with
$\alpha = 3/2$ on a ring and $\alpha = 2$ between walls; their standing waves are followed from that of equal beads
(periodic_motions.hpp). In the last chain every contact has an exponent of its own. The library knows no such chain, so
we write its push here; its motion is even found by GSL's integrator, with a derivative by central differences. */
struct MixedChain {
  std::size_t sites;
  None well{};
  std::vector<double> mass, stiffness, exponent;
  double mass_of(std::size_t n) const { return mass[n]; }
};

double contact_push(const MixedChain& chain, const double* y, std::size_t i) {
  const double left = i > 0 ? y[i - 1] : 0, right = i < chain.sites ? y[i] : 0;
  return left > right ? chain.stiffness[i] * std::pow(left - right, chain.exponent[i]) : 0;
}

/// Five beads between walls that are the more uneven the larger `part` is: at one, exponents from 1.4 to 1.8.
MixedChain mixed_chain(double part) {
  using motions::uneven;
  MixedChain chain{5,
                   {},
                   uneven(5, 0.15 * part, 13),
                   uneven(6, 0.15 * part, 14),
                   {1.5, 1.7, 1.4, 1.6, 1.8, 1.5}};
  for (double& alpha : chain.exponent) alpha = 1.5 + part * (alpha - 1.5);
  return chain;
}

/// A start at rest from which its beads come to rest again after half a period of frequency one.
State<double> mixed_wave() {
  State<double> start = motions::zigzag(5);
  NewtonRule<double> rule = motions::free_rule();
  rule.rank = 0;
  for (int k = 0; k <= motions::degrees; ++k) {
    const MixedChain chain = mixed_chain(double(k) / motions::degrees);
    const auto velocities_after_half = [&](const Vector<double>& x) {
      State<double> from(5);
      std::copy(x.begin(), x.end(), from.y.begin());
      const auto v = mean_forces(chain, from, std::numbers::pi, 1e-14).end.v;
      return Vector<double>(Eigen::Map<const Vector<double>>(v.data(), 5));
    };
    const auto equations =
        by_differences("standing wave with mixed exponents", velocities_after_half, 1e-5);
    const auto x = Eigen::Map<const Vector<double>>(start.y.data(), 5).eval();
    const Vector<double> found = newton(equations, x, rule).x;
    std::copy(found.begin(), found.end(), start.y.begin());
  }
  return start;
}

/**
The means of all four agree to the accuracy of the motions. From a start that is wrong by a thousandth at one bead the
uneven ring does not return, and its means differ visibly.

| spread of the mean push, relative to the largest | here |
|---|---|
| the largest of the four motions | [1e-11 ± 1e-9](num:sec2_nonexistence.mean_force_spread_free) |
| of the uneven ring | [4e-12 ± 7e-10](num:sec2_nonexistence.mean_force_spread_uneven_ring) |
| of the uneven ring, not periodic | [0.000756758 ± 3e-10](num:sec2_nonexistence.mean_force_spread_not_periodic) |
| of breathers in wells, the smaller one | [1.00000 ± 2e-16](num:sec2_nonexistence.mean_force_spread_wells) |
| imbalance of a bead in wells, with the force of its well | [2e-12 ± 2e-10](num:sec2_nonexistence.mean_force_imbalance_wells) | */
std::vector<Motion> of_free_chains(Report& report) {
  std::vector<Motion> all;
  Estimate spread{}, push{HUGE_VAL};
  const auto add = [&](const std::string& name, const auto& chain, const State<double>& start,
                       double period) {
    all.push_back(averaged(name, chain, start, period, true));
    spread = larger(spread, all.back().number(&Balance::spread));
    push = smaller(push, all.back().number(&Balance::largest, largest(start)));
  };
  // Equal beads on a ring, a wave that moves on by one site in its period
  Shooting<double> ring{{8, None{}, PowerContact{1.5}, Ends::periodic}, {}, 1}, uneven_ring = ring;
  const Orbit<double> wave = motions::ring_wave(ring);
  add("ring_wave", ring.chain, wave.start, 8 * wave.period());

  // Uneven beads and contacts, on a ring, between walls, and with mixed exponents
  const Orbit<double> standing = motions::standing_wave(uneven_ring, 1.5);
  Shooting<double> walls{{6, None{}, PowerContact{1.5}, Ends::fixed}, {}, 1};
  const Orbit<double> between = motions::standing_wave(walls, 2);
  add("uneven_ring", uneven_ring.chain, standing.start, standing.period());
  report.facts.add("mean_force_spread_uneven_ring", all.back().number(&Balance::spread));
  add("walls", walls.chain, between.start, between.period());
  add("mixed_exponents", mixed_chain(1), mixed_wave(), 2 * std::numbers::pi);
  report.facts.add("mean_force_spread_free", spread);
  report.facts.add("mean_force_least_free", push, "relative to amplitude");

  // A motion that does not return
  State<double> wrong = standing.start;
  wrong.y[0] *= 1.001;
  report.facts.add(
      "mean_force_spread_not_periodic",
      averaged("", uneven_ring.chain, wrong, standing.period(), true).number(&Balance::spread));
  return all;
}

/**
## Unequal means in wells (figure x16 b)

The contrast comes from breathers: periodic motions of a few beads in wells $W = \frac12y^2$, in which neighbours swing
against each other and the other beads are nearly at rest. There are two kinds, one symmetric about a bead (*site*) and
one about a contact (*bond*); section 3.2 computes them by the same method (sec32_newton_breathers.cpp). We take both at
the frequency $\omega_b = 2\pi/T = 1.5$, on free chains long enough for their tails. Here the spread is of order one,
and each bead is balanced by its well. */
void of_wells(Report& report, std::vector<Motion>& all) {
  Estimate spread{HUGE_VAL}, imbalance{};
  for (Centre centre : {Centre::bond, Centre::site}) {
    const std::string name = centre == Centre::bond ? "breather_bond" : "breather_site";
    const auto problem = breather_problem(centre, 1.5, 0, sites_of(centre, Length::spare));
    const Orbit<double> orbit = find_breather(problem);
    all.push_back(averaged(name, problem.chain, orbit.start, orbit.period(), false));
    spread = smaller(spread, all.back().number(&Balance::spread));
    imbalance = larger(imbalance, all.back().number(&Balance::imbalance));
  }
  report.facts.add("mean_force_spread_wells", spread);
  report.facts.add("mean_force_imbalance_wells", imbalance);
}

void report_means(Report& report, const std::vector<Motion>& all) {
  Table& table = report.table("mean_forces");
  for (const Motion& m : all) {
    const std::size_t sites = m.fine.well.size(), first = m.outermost ? 0 : 1;
    const double top = Balance(m.fine, m.outermost).largest;
    for (std::size_t i = first; i + first <= sites; ++i) {
      const bool bead = i < sites;
      const double here = m.fine.push[i], none = std::nan("");
      table.add({{"motion", "which periodic motion", m.name},
                 {"n", "contact, to the left of bead n; 1 is the first", i + 1, "site"},
                 {"force", "mean force of the contact over a period",
                  Estimate{here, std::abs(here - m.coarse.push[i])}, "",
                  "difference of two tolerances, against the largest force"},
                 {"relative", "mean force over the largest one of the motion", here / top},
                 {"step", "mean force of this contact minus that of the next",
                  bead ? here - m.fine.push[i + 1] : none},
                 {"well", "mean of W' at bead n, nan where there is no bead",
                  bead ? m.fine.well[i] : none}});
    }
  }
}

/**
## Random searches find nothing (figure x16 c)

Next we look for breathers of the free open chain by brute force. Three beads in the middle get random positions, and in
half of the searches random velocities too; damped Newton's method then looks for a motion with the period of a
breather, $\omega_b = 1.2$. To be cheap, a search moves the chain by leapfrog steps, 128 and again 256 of them in a
period, and what it finds must survive the exact flow (sec2/searches.hpp). Finding nothing means something only if the
same search finds what does exist, so each series of searches has its control. Small starts, of the size of a breather,
are also tried in wells of unit stiffness. Large starts have the size of motions of this frequency without wells: about
$0.3$ when neighbours swing against each other. Such motions of a few beads exist between walls, and there the same
search looks for them with three beads. */
const std::array<searches::Series, 4> series{{{"free", 15, Ends::free, false, 0.02, 0.08},
                                              {"wells", 15, Ends::free, true, 0.02, 0.08},
                                              {"free_large", 15, Ends::free, false, 0.3, 2},
                                              {"walls", 3, Ends::fixed, false, 0.3, 2}}};

/**
A search ends at rest, in a localized motion, in an extended one, in doubt, or fails to converge. On the free chain the
theorem allows only the first and the last of these; one count in any of the others would refute it.

No start in the free chain ends in a motion, small or large; nearly all come to rest. In wells a fifth of the same
starts ends in a breather that the exact flow confirms, and between walls more than a quarter finds a motion. The error
is the difference of the two steps plus the statistical one.

| of [100](num:sec2_nonexistence.searches) searches each | here |
|---|---|
| end in a motion of the free chain, small starts | [0](num:sec2_nonexistence.mean_force_moving_free) |
| the same, large starts | [0](num:sec2_nonexistence.mean_force_moving_free_large) |
| fraction at rest in the free chain, of either | [0.99 ± 0.02](num:sec2_nonexistence.mean_force_rest_share) |
| fraction in a breather, in wells | [0.2 ± 0.1](num:sec2_nonexistence.mean_force_localized_share_wells) |
| fraction in a motion, between walls | [0.29 ± 0.05](num:sec2_nonexistence.mean_force_moving_share_walls) | */
void report_searches(Report& report) {
  using searches::End;
  const unsigned long seeds = report.quick ? 40 : 100;
  report.output.note("seed", "searches 1 to " + std::to_string(seeds) + ", unevenness 11 to 14");
  report.facts.add("searches", exact(double(seeds)), "searches");

  // Every series fills two columns
  Table& table = report.table("searches", label("ends_in", "how a search ends"));
  for (const char* name : searches::end_names) table.add({name});
  Estimate rest{HUGE_VAL};
  for (const searches::Series& of : series) {
    const searches::EndCounts counts = search_all(of, seeds);
    table.columns.push_back(count(of.name, "searches with 128 steps a period"));
    table.columns.push_back(count(of.name + "_fine", "searches with 256 steps a period"));
    for (std::size_t k : {0, 1})
      for (std::size_t i = 0; i < searches::end_names.size(); ++i)
        table.rows[i].push_back(std::int64_t(counts.of[k][i]));
    // What the theorem allows and forbids in free chains, and what the controls find
    const auto share = [&](const std::vector<End>& ends) {
      return quotient(counts.sum(ends), exact(counts.all));
    };
    if (of.wells)
      report.facts.add("mean_force_localized_share_wells", share({End::localized}));
    else if (of.ends == Ends::fixed)
      report.facts.add("mean_force_moving_share_walls", share({End::localized, End::extended}));
    else {
      report.facts.add("mean_force_moving_" + of.name,
                       counts.sum({End::localized, End::extended, End::doubtful}));
      rest = smaller(rest, share({End::rest}));
    }
  }
  report.facts.add("mean_force_rest_share", rest);
}

/**
## A localized state disperses (figure x16 d, e)

A third way to find a breather is to start from one. We put the breather at $\omega_b = 1.5$ into a long chain, once
with its wells and once without, and watch two quantities: the energy on the nine sites around its centre, and the push
of the contact beside its central bead, averaged from the start up to $t$. Steps are event-corrected
(event_corrected.hpp), 0.05 and half of it, and the difference of the two runs is the error. */
struct Dispersal {
  std::vector<double> t, core, mean;
  std::int64_t woken = 0;  ///< sites that are not exactly at rest when the run ends
  Run run{};
};

/// The chain at rest with a breather of the wells in its middle, site 200.
State<double> breather_in_long_chain() {
  const Orbit<double> orbit = find_breather(breather_problem(Centre::site, 1.5, 0, 23));
  State<double> state(401);
  std::copy(orbit.start.y.begin(), orbit.start.y.end(), state.y.begin() + 200 - 11);
  return state;
}

/**
The mean push is an integral over samples. They follow the steps, so that both become denser together. */
Dispersal disperse(const Well& well, double time, int halvings) {
  const Chain chain{401, well};
  State<double> state = breather_in_long_chain();
  const double all = energy(chain, state);
  EventCorrected method{0.05};
  method.halvings = halvings;
  const TimeGrid grid = time_grid(method, time, denser(0.05));
  Dispersal out;
  double impulse = 0, before = 0;
  std::size_t k = 0;
  out.run = evolve(method, chain, state, grid, [&](const State<double>& now) {
    const double push = contact_push(chain, now.y.data(), 201);
    if (k > 0) impulse += (before + push) / 2 * grid.interval();
    before = push;
    if (k++ % (std::size_t(20) << halvings) != 0) return;
    out.t.push_back(now.t);
    out.core.push_back(window_sum(energy_density(chain, now), 200, 4) / all);
    out.mean.push_back(now.t > 0 ? impulse / now.t : push);
  });
  out.woken = std::count_if(state.v.begin(), state.v.end(), [](double v) { return v != 0; });
  return out;
}

/**
A contact that transmits a finite impulse in all has a mean force that goes to zero like $1/t$: over the second half of
the time it falls to one half. Some beads are still at rest at the end, so the ends of the chain do not matter.

| up to $t = 200$ | without wells | in wells |
|---|---|---|
| energy left on nine sites | [0.00162601 ± 1e-12](num:sec2_nonexistence.mean_force_core_free) | [0.999982 ± 6e-10](num:sec2_nonexistence.mean_force_core_wells) |
| mean push at $t = 200$ over that at 100, its distance from 1/2 (from 1 in wells) | [0.0247840 ± 5e-7](num:sec2_nonexistence.mean_force_late_mean_free) | [0.006581 ± 8e-6](num:sec2_nonexistence.mean_force_late_mean_wells) | */
Estimate deviation(const Dispersal& coarse, const Dispersal& fine, double expected) {
  const auto late = [&](const Dispersal& run) {
    return run.mean.back() / run.mean[run.mean.size() / 2] - expected;
  };
  const Estimate e = compare(late(coarse), late(fine));
  return {std::abs(e.value), e.error};
}

// A loss of energy by the integrator could pass for dispersal, so every run is listed with its drift
void report_dispersal(Report& report) {
  // Without and with wells, each at two resolutions
  const double time = report.quick ? 60 : 200;
  std::array<Dispersal, 4> runs;
  parallel_for(4, [&](std::size_t k) {
    const int halvings = int(k % 2);
    runs[k] = disperse(k < 2 ? Well{None{}} : Well{Harmonic{}}, time, halvings);
  });

  // What the figure shows, instant by instant
  Table& table = report.table("dispersal");
  for (std::size_t c : {0, 1}) {
    const Dispersal &coarse = runs[2 * c], &fine = runs[2 * c + 1];
    const std::string name = c == 0 ? "free" : "wells";
    for (std::size_t i = 0; i < fine.t.size(); ++i)
      table.add({{"chain", "free or wells", name},
                 {"t", "time", fine.t[i]},
                 {"core", "share of the energy on nine sites",
                  Estimate{fine.core[i], std::abs(fine.core[i] - coarse.core[i])}, "",
                  "difference of two resolutions, against the largest share"},
                 {"mean", "push of a central contact, averaged from 0 to t",
                  Estimate{fine.mean[i], std::abs(fine.mean[i] - coarse.mean[i])}, "",
                  "difference of two resolutions, against the largest mean"}});
    report.facts.add("mean_force_core_" + name, compare(coarse.core.back(), fine.core.back()));
    report.facts.add("mean_force_late_mean_" + name, deviation(coarse, fine, c == 0 ? 0.5 : 1));
    report.facts.add("drift_" + name, compare(coarse.run.energy_drift, fine.run.energy_drift));
  }
  report.facts.add("mean_force_woken_free", compare(runs[0].woken, runs[1].woken));
}

/**
## Softer and softer wells

What becomes of a breather whose wells are made softer at a fixed period? With $y(t) = k^2\,Y(\sqrt k\,t)$ wells of the
stiffness $k$ are unit wells at the frequency $1/\sqrt k$. Its mean displacements obey
$k\,\bar y_n = \bar F_{n-1}-\bar F_n$. In a wide breather, whose neighbours swing against each other at a mean distance
$g$, this gives $\bar F'' = -k\,g(\bar F)$, so that its width grows like $k^{-1/2}$. Near its centre it tends to a
motion of the free chain with the same mean force at every contact, as the theorem demands, and that motion is no longer
localized.

## Differences and limits

The article proves and does not compute, so every parameter here is ours. The frequency of the searches,
$\omega_b = 1.2$, was chosen so that those in wells succeed. Some of these end in doubt, more of them at the longer
step: perhaps because the energy barrier between a site and a bond is so low at this frequency that the leapfrog chain
has breathers centred in between, near which Newton's method finds none of the exact flow. Between walls it is tried
with three beads only; it may be a weak instrument for motions of many, but a breather has few. Without wells contacts
in the core still close now and then, ever more faintly, so we look at the fall of the mean and do not wait for silence.
Where each contact has its own exponent both the search and the check use GSL's integrator, and only the identity is
tested. */
void reproduce(Report& report) {
  std::vector<Motion> means = of_free_chains(report);
  of_wells(report, means);
  report_searches(report);
  report_dispersal(report);
  report_means(report, means);
}

/**
## Try it

**To change it.** Another chain without wells is a few lines like those of
`mixed_chain`; another kind of search is a row of `series`; another state to let go is
`breather_in_long_chain`. A new quantity is a `report.facts.add`, a new column one more entry of a table, and the script
in `figures/` reads columns by name.

1. *Easy.* What becomes of an impact when there are no wells?
   `build/bin/sec34_impact run --well none --velocity 1 --time 200` gives `packet_energy_fraction` = 0.99366. Hint:
   nearly all energy leaves in one solitary wave, whose contacts push once each; it is localized but not periodic.
2. *Easy.* The same in weak motion: `build/bin/sec34_impact run --well none --velocity 0.01 --time 200`
   gives `speed` = 0.33461. Hint: without wells the equations have no scale; the speed goes like the power $1/5$ of the
   impact velocity.
3. *Harder.* Shallow wells at a fixed period are unit wells at a high frequency. How large is a breather then?
   `build/bin/sec32_newton_breathers breather --omega 2` gives `amplitude` = 2.45676. Hint: substitute
   $y(t) = k^2\,Y(k^{1/2}t)$ in the equation with wells of stiffness $k$.
4. *Open.* Which periodic motions does the free chain have between walls, and which are stable? With attracting contacts
   (cohesion) the argument fails: how little attraction makes a breather? */
int main(int argc, char** argv) {
  return run({"sec2_nonexistence", "2", "No breathers without wells (section 2)", reproduce}, argc,
             argv);
}
