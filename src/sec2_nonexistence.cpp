/**
# 2 No breathers without wells

Section 2 of James, Kevrekidis and Cuevas (Physica D 251, 2013) proves that beads which only repel each other have no
breathers: no motion of theirs is both periodic in time and localized in space. The proof is one integral. Bead $n$
obeys $m_n\ddot x_n = F_{n-1} - F_n$ with the push $F_n \ge 0$ of contact $n$, and over a period $T$
$$0 = m_n\bigl[\dot x_n(T)-\dot x_n(0)\bigr] = \int_0^T F_{n-1}\,dt - \int_0^T F_n\,dt :$$
the mean push $\bar F_n$ is the same at every contact (`thm.mean_force`). Far away from a localized motion the pushes
tend to zero, so this mean is zero. A push that is never negative and zero in the mean is zero always: the beads are
free, and a periodic motion of free beads is rest.

No computation proves a theorem, but ours could have refuted it: by a periodic motion with unequal means, by a search
that ends in a breather, or by a localized state that stays together. Each instrument is also tried where it must find
something, in the wells of section 3: the mean force of a well balances unequal pushes on the two sides of its bead, so
that $\bar F_n$ may fall off outwards, and there are breathers.

![Mean contact forces are the same at every contact of free chains (a) and not in wells (b); how searches from
small and large starts end (c); energy and mean force of a localized state (d, e).](fig:x16) */
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "lattice/diagnostics/observe.hpp"
#include "lattice/integrators/event_corrected.hpp"
#include "lattice/integrators/integrate.hpp"
#include "lattice/numerics/parallel.hpp"
#include "lattice/orbits/breather.hpp"
#include "report/program.hpp"
#include "sec2/mean_force.hpp"
#include "sec2/periodic_motions.hpp"
#include "sec2/searches.hpp"

using namespace lattice;

/**
## Model

The chain is that of Eqs. (1) and (3). Each bead has its own mass, each contact its stiffness and exponent,
$$m_n\ddot x_n = V_n'(x_{n+1}-x_n) - V_{n-1}'(x_n-x_{n-1}),\qquad
  V_n(x) = \frac{\gamma_n}{\alpha_n+1}\,(-x)_+^{\alpha_n+1},$$
so that contact $n$ pushes with $F_n = \gamma_n\,(x_n-x_{n+1})_+^{\alpha_n}$ (`mass`, `eta` and `exponent` in the
program). In wells $W$ the balance of a bead over a period reads $\bar F_{n-1}-\bar F_n = \overline{W'(y_n)}$. All
quantities are dimensionless.

## Method: periodic motions by shooting

Let $z$ be the positions and velocities at $t = 0$ and $\Phi_T(z)$ those after a period. A periodic motion is a zero of
$R(z) = \Phi_T(z) - z$. *Shooting* starts from a guess, runs the chain, and corrects the guess by Newton's method,
$$z \leftarrow z - \delta,\qquad \bigl(D\Phi_T(z) - 1\bigr)\,\delta = R(z),$$
where the derivative $D\Phi_T$ comes from the linearised equations of motion, integrated along. Far from a solution a
step is halved until it lowers $|R|$ (damping). Where a motion may be shifted in time or along the chain the matrix is
singular, and of all solutions $\delta$ we take the shortest. A motion that begins at rest is at rest again after $T/2$,
which halves the number of equations (lattice/orbits/shooting.hpp). */
constexpr std::array tolerances{1e-11, 1e-13};

/**
## Equal means in free chains (figure x16)

On a localized motion of the free chain all means would be zero, but no such motion exists. So we check the identity on
motions that fill a ring or a box. We follow each over a whole period and integrate the pushes along with it by an
integrator that shares nothing with the one that found it (sec2/mean_force.hpp), at two tolerances, whose difference is
the error. */
struct MotionMeans {
  std::string motion;
  MeanForces coarse, fine;
  bool outermost;  ///< whether the outermost contacts exist: on a ring, or between walls
};

template <class AnyChain>
MotionMeans means_of(const std::string& motion, const AnyChain& chain, const State<double>& start,
                     double period, bool outermost) {
  return {motion, mean_forces(chain, start, period, tolerances[0]),
          mean_forces(chain, start, period, tolerances[1]), outermost};
}

/**
Two numbers show it: the spread of the mean force over the contacts, relative to the largest, and the amount by which
the balance of a bead, with the force of its well, is missed. */
struct Balance {
  double largest, spread, imbalance;

  Balance(const MeanForces& m, bool outermost) {
    const std::size_t first = outermost ? 0 : 1;
    largest = *std::max_element(m.contact.begin(), m.contact.end());
    spread = m.spread(first, m.well.size() - first) / largest;
    imbalance = m.imbalance() / largest;
  }
};

/// One of these numbers, in some unit, with its error.
Estimate balance_estimate(const MotionMeans& m, double Balance::*number, double unit = 1) {
  const Balance coarse(m.coarse, m.outermost), fine(m.fine, m.outermost);
  return compare(coarse.*number / unit, fine.*number / unit);
}

/**
We need chains on which only the theorem makes the means equal. On a ring of equal beads symmetry alone does, so this
case only checks the instrument. Masses and stiffnesses then differ from bead to bead, with $\alpha = 3/2$ on a ring and
$\alpha = 2$ between walls, and in the last chain every contact has an exponent of its own (sec2/periodic_motions.hpp
finds all four). The mean forces of the uneven ring agree to
[4e-12](num:sec2_nonexistence.mean_force_spread_uneven_ring) of the largest. From a start that is wrong by a thousandth
at one bead the uneven ring does not return, and its means agree only to
[0.000756758](num:sec2_nonexistence.mean_force_spread_not_periodic) of the largest. */
void of_free_chains(Report& report, std::vector<MotionMeans>& all) {
  Estimate spread{}, force{HUGE_VAL};
  const auto add = [&](const std::string& name, const auto& chain, const State<double>& start,
                       double period) {
    all.push_back(means_of(name, chain, start, period, true));
    spread = larger(spread, balance_estimate(all.back(), &Balance::spread));
    force = smaller(force, balance_estimate(all.back(), &Balance::largest, largest(start)));
  };
  // Equal beads on a ring: symmetry alone makes the means equal
  Shooting<double> ring{{8, None{}, PowerContact{1.5}, Ends::periodic}, {}, 1}, uneven_ring = ring;
  const Orbit<double> wave = motions::ring_wave(ring);
  add("ring_wave", ring.chain, wave.start, 8 * wave.period());

  // Uneven beads and contacts, on a ring, between walls, and with mixed exponents: only the theorem does
  const Orbit<double> standing = motions::standing_wave(uneven_ring, 1.5);
  Shooting<double> walls{{6, None{}, PowerContact{1.5}, Ends::fixed}, {}, 1};
  const Orbit<double> between = motions::standing_wave(walls, 2);
  add("uneven_ring", uneven_ring.chain, standing.start, standing.period());
  report.facts.add("mean_force_spread_uneven_ring", balance_estimate(all.back(), &Balance::spread));
  add("walls", walls.chain, between.start, between.period());
  add("mixed_exponents", motions::mixed_chain(1), motions::mixed_wave(), 2 * std::numbers::pi);
  report.facts.add("mean_force_spread_free", spread);
  report.facts.add("mean_force_least_free", force, "relative to amplitude");

  // A motion that does not return
  State<double> wrong = standing.start;
  wrong.y[0] *= 1.001;
  report.facts.add("mean_force_spread_not_periodic",
                   balance_estimate(means_of("", uneven_ring.chain, wrong, standing.period(), true),
                                    &Balance::spread));
}

/**
## Unequal means in wells

The contrast comes from breathers: periodic motions of a few beads in wells $W = \frac12y^2$, in which neighbours swing
against each other and the other beads are nearly at rest. There are two kinds, one symmetric about a bead (*site*) and
one about a contact (*bond*); section 3.2 computes them by the same method (sec32_newton_breathers.cpp). We take both at
the frequency $\omega_b = 2\pi/T = 1.5$, on free chains long enough for their tails. Here the spread is of order one,
and each bead is balanced by its well. */
void of_wells(Report& report, std::vector<MotionMeans>& all) {
  Estimate spread{HUGE_VAL}, imbalance{};
  for (Centre centre : {Centre::bond, Centre::site}) {
    const std::string name = centre == Centre::bond ? "breather_bond" : "breather_site";
    const auto problem = breather_problem(centre, 1.5, 0, sites_of(centre, Length::spare));
    const Orbit<double> orbit = find_breather(problem);
    all.push_back(means_of(name, problem.chain, orbit.start, orbit.period(), false));
    spread = smaller(spread, balance_estimate(all.back(), &Balance::spread));
    imbalance = larger(imbalance, balance_estimate(all.back(), &Balance::imbalance));
  }
  report.facts.add("mean_force_spread_wells", spread);
  report.facts.add("mean_force_imbalance_wells", imbalance);
}

void report_means(Report& report, const std::vector<MotionMeans>& all) {
  Table& table = report.table("mean_forces");
  for (const MotionMeans& m : all) {
    const MeanForces &fine = m.fine, &coarse = m.coarse;
    const std::size_t sites = fine.well.size(), first = m.outermost ? 0 : 1;
    const double top = *std::max_element(fine.contact.begin(), fine.contact.end());
    for (std::size_t i = first; i + first <= sites; ++i) {
      const bool bead = i < sites;
      const double here = fine.contact[i], none = std::nan("");
      table.add({{"motion", "which periodic motion", m.motion},
                 {"n", "contact, to the left of bead n; 1 is the first", i + 1, "site"},
                 {"force", "mean force of the contact over a period",
                  Estimate{here, std::abs(here - coarse.contact[i])}, "",
                  "difference of two tolerances, against the largest force"},
                 {"relative", "mean force over the largest one of the motion", here / top},
                 {"step", "mean force of this contact minus that of the next",
                  bead ? here - fine.contact[i + 1] : none},
                 {"well", "mean of W' at bead n, nan where there is no bead",
                  bead ? fine.well[i] : none}});
    }
  }
}

/**
## Random searches find nothing (figure x16)

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

Of [100](num:sec2_nonexistence.searches) small starts in the free chain
[0](num:sec2_nonexistence.mean_force_moving_free) end in a motion, and of as many large ones
[0](num:sec2_nonexistence.mean_force_moving_free_large); of either, the share
[0.99](num:sec2_nonexistence.mean_force_rest_share) or more comes to rest. In wells the share that ends in a confirmed
breather is about [0.2](num:sec2_nonexistence.mean_force_localized_share_wells), larger with the shorter step, and
between walls the share [0.29](num:sec2_nonexistence.mean_force_moving_share_walls) finds a motion (the table `searches`
has all counts). */
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
## A localized state disperses (figure x16)

A third way to find a breather is to start from one. We put the breather at $\omega_b = 1.5$ into a long chain, once
with its wells and once without, and watch two quantities: the energy on the nine sites around its centre, and the push
of the contact beside its central bead, averaged from the start up to $t$. Two runs with different steps and samples
agree to the errors in the table. Without wells [0.00162601](num:sec2_nonexistence.mean_force_core_free) of the energy
stays in the core up to $t = 200$, with them [0.999982](num:sec2_nonexistence.mean_force_core_wells). */
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
the time it falls to one half. In the free chain the fall misses one half by
[0.0247840](num:sec2_nonexistence.mean_force_late_mean_free), and in wells the mean changes by the fraction
[0.006581](num:sec2_nonexistence.mean_force_late_mean_wells). Some beads are still at rest at the end, so that the ends
of the chain do not matter. */
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
stiffness $k$ are unit wells at the frequency $1/\sqrt k$. Its mean displacements obey $k\,\bar y_n =
\bar F_{n-1}-\bar F_n$. In a wide breather, whose neighbours swing against each other at a mean distance $g$, this gives
$\bar F'' = -k\,g(\bar F)$, so that its width grows like $k^{-1/2}$. Near its centre it tends to a motion of the free chain
with the same mean force at every contact, as the theorem demands, and that motion is no longer localized.

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
  std::vector<MotionMeans> means;
  of_free_chains(report, means);
  of_wells(report, means);
  report_searches(report);
  report_dispersal(report);
  report_means(report, means);
}

/**
## Try it

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
