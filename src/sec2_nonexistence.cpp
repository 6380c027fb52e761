/**
# 2 No breathers without an on-site potential

Does a chain of beads need wells to have breathers, motions that are periodic in time and localized in space? It does if
beads only repel each other: section 2 of James, Kevrekidis and Cuevas (Physica D 251, 2013) has a proof, which rests on
one identity. The mean force is the same at every contact of a periodic motion; we check this without wells, and see it
fail in wells. Then we ask what the proof does not say: how does a localized state end? Five periods after a breather
has lost its wells, 95 per cent of its energy has left the nine sites around its centre.

The proof is one integral. Let $F_n \ge 0$ be the push of contact $n$, between the beads $n-1$ and $n$. Bead $n$ obeys
$m_n\ddot x_n = F_n - F_{n+1}$, and over a period $T$
$$0 = m_n\bigl[\dot x_n(T)-\dot x_n(0)\bigr] = \int_0^T F_n\,dt - \int_0^T F_{n+1}\,dt :$$
the mean force $\bar F_n$ is the same at every contact (`thm.mean_force`). Far to the right of a localized motion, Eq.
(5), the overlaps tend to zero, and so do the forces, for by hypothesis (2) all contacts there obey one bound $F_n \le
f$ of the overlap with $f(0) = 0$. (Ever stiffer contacts could carry the same mean at ever smaller overlaps.) So the
mean is zero. A force that is never negative and has zero mean vanishes: the beads are free, and the only periodic
motion of free beads is rest, in which no contact overlaps, $x_n \ge x_{n-1}$ (`thm.equilibria`).

![Mean contact forces are the same at every contact of free chains (a) and not in wells (b); energy and mean force of a
localized state (c, d).](fig:x16)

<!-- head -->
`build/bin/sec2_nonexistence` computes this chapter in less than 1 s on two cores and writes 4 tables to
`build/data/sec2_nonexistence`. Its figures: `make x16`, `make x41`.
<!-- /head --> */
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include "lattice/diagnostics/observe.hpp"
#include "lattice/events/event_driven.hpp"
#include "lattice/gsl/random.hpp"
#include "lattice/gsl/reference.hpp"
#include "lattice/integrators/event_corrected.hpp"
#include "lattice/model/chain.hpp"
#include "lattice/orbits/breather.hpp"
#include "lattice/orbits/shooting.hpp"
#include "lattice/orbits/symmetry.hpp"
#include "report/program.hpp"

using namespace lattice;

/**
## Model

The chain is that of Eqs. (1) and (3), dimensionless, with a mass for each bead and a stiffness for each contact. Wells
$W$ (section 3) add one more force:
$$m_n\ddot x_n = F_n-F_{n+1}-W'(x_n),\qquad F_n = \gamma_n\,(x_{n-1}-x_n)_+^{\alpha}.$$

The article gives a proof and no computation, so every parameter is ours. Localized motions of the free chain do not
exist: we test the identity on motions that fill a ring or a box. */
constexpr double omega_free = 1;     // frequency of the motions without wells
constexpr double unevenness = 0.15;  // largest deviation of masses and stiffnesses from 1
constexpr std::size_t ring_sites = 8, box_sites = 6;
constexpr double alpha_ring = 1.5, alpha_box = 2;
constexpr double off = 0.001;    // relative change of a bead's displacement in the control
constexpr double omega_b = 1.5;  // of the breathers in wells
constexpr double coarse_tolerance = 1e-11, tolerance = 1e-13;  // of GSL

/**
## The experiment: mean forces

GSL integrates the equations of motion, with the impulses of all contacts as further unknowns. Divided by the time they
are the means. */
struct Motion {
  std::string name;
  Chain chain;
  State<double> start;
  double time;
  bool returns = true;
};

struct Means {
  std::vector<double> push;  // of contact i, to the left of bead i, from 0
  State<double> end;
};

Means mean_forces(const Motion& m, double allowed) {
  // The unknowns: positions, velocities from v0 on, impulses from push0 on
  const std::size_t N = m.chain.sites, v0 = N, push0 = 2 * N, unknowns = 3 * N + 1;
  const auto equations = [&](double, const double* z, double* rate) {
    for (std::size_t i = 0; i <= N; ++i) rate[push0 + i] = contact_push(m.chain, z, i);
    for (std::size_t n = 0; n < N; ++n) {
      rate[n] = z[v0 + n];
      rate[v0 + n] = acceleration(m.chain, z, n);
    }
  };
  std::vector<double> z(unknowns);
  std::copy(m.start.y.begin(), m.start.y.end(), z.begin());
  std::copy(m.start.v.begin(), m.start.v.end(), z.begin() + long(v0));
  double t = 0;
  Reference(equations, unknowns, allowed).advance(t, m.time, z);

  // Impulses become means
  Means means{{}, State<double>(N)};
  for (std::size_t i = 0; i <= N; ++i) means.push.push_back(z[push0 + i] / m.time);
  for (std::size_t n = 0; n < N; ++n) {
    means.end.y[n] = z[n];
    means.end.v[n] = z[v0 + n];
  }
  return means;
}

/**
## Periodic motions of free chains

We find a periodic motion by shooting. Beads start from rest, neighbours displaced in opposite directions by the
amplitude $A$ of a guess. Newton's method corrects the start until all velocities vanish after half a period; the motion
then retraces its path and closes. We do so on a ring and, with another exponent, in a row between walls. A ring may
also be displaced as a whole, so Newton's matrix is singular, and we take the shortest of its solutions. The program
stops if a motion found in this way, with `flow` (event_driven.hpp), does not come back to its start in GSL, which
shares only the force law with it. The guess solves the uniform ring in harmonic balance. From there `part` runs from 0
to 1: masses and stiffnesses deviate by up to `part` times 15 per cent, and the exponent is interpolated likewise. */
Chain uneven_chain(std::size_t sites, Ends ends, double alpha, double part) {
  Chain chain{sites, None{}, PowerContact{1.5 + part * (alpha - 1.5)}, ends};
  const std::vector<double> ones(sites + 1, 1);
  std::vector<double> gamma = shaken(ones, unevenness * part, 12);  // random, with a seed
  if (ends == Ends::periodic) gamma.back() = gamma.front();         // one contact of a ring
  vary(chain, shaken({ones.begin(), ones.end() - 1}, unevenness * part, 11), gamma);
  return chain;
}

Motion standing_wave(const std::string& name, std::size_t sites, Ends ends, double alpha) {
  // omega^2 A = 2 harmonic (2 A)^(3/2), with the coefficient of cos t in (cos t)_+^(3/2)
  const double harmonic = 0.457;
  const double A = std::pow(2 * harmonic * std::pow(2, 1.5) / (omega_free * omega_free), -2);
  const NewtonRule<double> shortest{.most_steps = 60, .damped = true, .rank = 1e-9};
  Vector<double> y(sites);
  for (long n = 0; n < y.size(); ++n) y[n] = n % 2 == 0 ? A : -A;
  for (double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const Shooting<double> problem{uneven_chain(sites, ends, alpha, part), even_in_time(sites),
                                   omega_free};
    y = newton(problem.equations(), y, shortest).x;
  }
  Motion m{name, uneven_chain(sites, ends, alpha, 1), State<double>(sites),
           2 * std::numbers::pi / omega_free};
  m.start.y.assign(y.begin(), y.end());
  return m;
}

/**
The control is a motion that is not periodic: the start of one bead of the ring is changed by a thousandth.

![Spread of the mean forces, largest minus least over the largest, against the tolerance of the integration.](fig:x41)

On both periodic motions the spread falls with the tolerance of GSL, to below $10^{-11}$; the verdict below asks for
less than $10^{-8}$. On the control it stays at 0.0008: there it is physics, and not error. */
std::vector<Motion> free_motions() {
  const Motion ring = standing_wave("uneven_ring", ring_sites, Ends::periodic, alpha_ring);
  Motion control = ring;
  control.name = "not_returning";
  control.returns = false;
  control.start.y[0] *= 1 + off;
  return {ring, standing_wave("walls", box_sites, Ends::fixed, alpha_box), control};
}

void report_spread(Report& report, const std::vector<Motion>& motions) {
  Table& table = report.table("spread");
  for (const Motion& m : motions)
    for (int digits = 4; digits <= (report.quick ? 8 : 14); digits += 2) {
      const double allowed = std::pow(10, -digits);
      const std::vector<double> push = mean_forces(m, allowed).push;
      const auto [least, most] = std::minmax_element(push.begin(), push.end());
      table.add({{"motion", "name of the motion; not_returning is not periodic", m.name},
                 {"tolerance", "of GSL, for each step", allowed},
                 {"spread", "of the mean forces, over the largest", (*most - *least) / *most}});
    }
}

/**
## Unequal means in wells (figure x16 b)

The article remarks that the proof fails with an on-site potential, since the means then depend on $n$ (`thm.wells`). We
take breathers in wells $W = \frac12y^2$: a few beads oscillate, neighbours out of phase, and the others are nearly at
rest. There are two kinds, symmetric about a bead (*site*) and about a contact (*bond*), which section 3.2 computes by
the same method (sec32_newton_breathers.cpp). The outermost contacts carry nothing, so the mean falls from its largest
value to zero from the middle outwards, and at each bead the well makes up for the difference: for the bond-centred
breather it is [0.1525](cell:mean_forces/motion=breather_bond/n=12/force) at the middle contact and
[0.0038](cell:mean_forces/motion=breather_bond/n=16/force) at the fourth from there. */
Motion breather_in_wells(Centre centre) {
  const bool bond = centre == Centre::bond;
  const auto problem = breather_problem(centre, omega_b, 0, bond ? 22 : 23);
  const Orbit<double> orbit = find_breather(problem);
  return {bond ? "breather_bond" : "breather_site", problem.chain, orbit.start, orbit.period()};
}

// Panels a and b, contact by contact
void report_means(Report& report, const std::vector<Motion>& motions) {
  Table& table = report.table("mean_forces");
  for (const Motion& m : motions) {
    const Means coarse = mean_forces(m, coarse_tolerance), fine = mean_forces(m, tolerance);
    if (m.returns && largest_difference(fine.end, m.start) > 1e-9 * largest(m.start))
      throw Failure(m.name + " does not return to its start");
    // A ring has its first contact twice
    const std::size_t contacts = m.chain.ends == Ends::periodic ? m.chain.sites : m.chain.sites + 1;
    for (std::size_t i = 0; i < contacts; ++i) {
      if (!m.chain.pushes(i)) continue;
      table.add({{"motion", "name of the motion; all are periodic but not_returning", m.name},
                 {"n", "contact, to the left of bead n; 1 is the first", i + 1, "site"},
                 {"force", "mean force of the contact over a period",
                  compare(coarse.push[i], fine.push[i]), "",
                  "difference of two tolerances, against the largest force"}});
    }
  }
}

/**
## A localized state disperses (figure x16 c, d)

What becomes of a breather whose wells are taken away? We start it in the middle of a long chain, once with its wells
and once without. Every unit of time we record the energy on the nine sites around its centre, and the force of the
contact beside its central bead, averaged from the start up to $t$ (by the trapezoidal rule over all steps). Steps are
event-corrected (event_corrected.hpp), and half of their length gives the error. The program stops if the motion reaches
an end of the chain or the energy drifts: such a loss could pass for dispersal.

| | without wells | in wells |
|---|---|---|
| energy on nine sites at $t = 20$ | [0.0438](cell:dispersal/chain=free/t=20/core) | [0.99999](cell:chain=wells/core) |
| at $t = 200$ | [0.00163](cell:dispersal/chain=free/t=200/core) | [0.99998](cell:chain=wells/core) |
| impulse of the contact up to $t = 20$ | [0.774](cell:dispersal/chain=free/t=20/impulse) | [2.73](cell:chain=wells/impulse) |
| up to $t = 200$ | [0.975](cell:dispersal/chain=free/t=200/impulse) | [28.8](cell:chain=wells/impulse) |

In wells the impulse grows with time, and the mean stays. Without them the contact transmits 79 per cent of the whole
impulse in the first 20 units of time. Then it closes only four more times, each time more weakly; so the mean falls
nearly like $1/t$. */
constexpr std::size_t dispersal_sites = 401;
constexpr int steps_per_unit = 20;  // of time

void assert_isolated(const State<double>& end, double energy_drift) {
  if (end.v.front() != 0 || end.v.back() != 0) throw Failure("the ends of the chain have moved");
  if (!(energy_drift < 1e-8)) throw Failure("the energy drifts");
}

struct Dispersal {
  std::vector<double> t, core, impulse;
};

Dispersal let_go(const State<double>& breather, const Well& well, double time, int steps) {
  const Chain chain{dispersal_sites, well};
  const std::size_t centre = dispersal_sites / 2;
  State<double> state = resized(breather, dispersal_sites);
  const double all = energy(chain, state), step = 1. / steps;
  Dispersal out;
  double impulse = 0, before = 0, last = 0;  // the latter: time and push at the step before
  const auto look = [&](const State<double>& now) {
    const double push = contact_push(chain, now.y.data(), centre + 1);
    impulse += (last + push) / 2 * (now.t - before);
    last = push;
    before = now.t;
    if (now.t == 0 || std::lround(now.t * steps) % steps != 0) return;
    out.t.push_back(now.t);
    out.core.push_back(window_sum(energy_density(chain, now), centre, 4) / all);
    out.impulse.push_back(impulse);
  };
  const Run run = evolve(EventCorrected{step}, chain, state, time, step, look);
  assert_isolated(state, run.energy_drift);
  return out;
}

// Panels c and d, instant by instant
void report_dispersal(Report& report, const State<double>& breather) {
  const double time = report.quick ? 60 : 200;
  Table& table = report.table("dispersal");
  for (const std::string chain : {"free", "wells"}) {
    const Well well = chain == "free" ? Well{None{}} : Well{Harmonic{}};
    const Dispersal coarse = let_go(breather, well, time, steps_per_unit),
                    fine = let_go(breather, well, time, 2 * steps_per_unit);
    for (std::size_t i = 0; i < fine.t.size(); ++i)
      table.add(
          {{"chain", "chain without wells (free) or with them (wells)", chain},
           {"t", "time", fine.t[i]},
           {"core", "fraction of the energy on nine sites", compare(coarse.core[i], fine.core[i]),
            "", "difference of two resolutions, against the largest fraction"},
           {"impulse", "of a central contact, from 0 to t",
            compare(coarse.impulse[i], fine.impulse[i])},
           {"mean", "force of this contact, averaged from 0 to t",
            compare(coarse.impulse[i] / fine.t[i], fine.impulse[i] / fine.t[i]), "",
            "difference of two resolutions, against the largest mean"}});
  }
}

/**
## Ten localized states, none returns

A periodic motion returns to its start. So we start localized motions in a free chain and ask how near they come to
their starts again: one bead that is displaced, one that is kicked, two neighbours pushed together, and the breather.
Let $d(t)$ be the largest change of a displacement or velocity since the start. Once it has exceeded a thousandth, we
record the least value of $d(t)/\max_{t'\le t}d(t')$, the *return ratio*. It is one for a motion that only goes away
and zero for a periodic one, unless its period is longer than the run of 24 periods of the breather. The theorem leaves
states of rest in which no contact overlaps: a sequence of displacements that increases, with random steps, must stay,
and must not if one step is reversed.

| return ratio | equal beads, $\alpha = 3/2$ | uneven beads, $\alpha = 2$ |
|---|---|---|
| displaced bead | [0.512](cell:returns/start=displaced/chain=equal/back) | [0.630](cell:chain=uneven/back) |
| kicked bead | [0.970](cell:returns/start=kicked/chain=equal/back) | [0.902](cell:chain=uneven/back) |
| pair pushed together | [0.698](cell:returns/start=pair/chain=equal/back) | [0.755](cell:chain=uneven/back) |
| breather | [0.669](cell:returns/start=breather/chain=equal/back) | [0.659](cell:chain=uneven/back) |
| increasing sequence, one step reversed | [0.997](cell:returns/start=step_down/chain=equal/back) | [0.978](cell:chain=uneven/back) |
| control: breather in wells | [0 ± 2e-11](cell:returns/start=breather/chain=wells/back) | |

The control returns at every period; nothing else comes back even half of its way (the verdict takes a ratio below 0.1
for a return). The increasing sequence does not move at all. */
constexpr std::size_t return_sites = 201;
constexpr int instants = 168;  // in a period of the breather

std::vector<Motion> localized(const Chain& chain, const State<double>& breather, double time) {
  const std::size_t sites = chain.sites, middle = sites / 2, rising = 20;
  State<double> displaced(sites), kicked(sites), pair(sites), increasing(sites);
  displaced.y[middle] = 1;
  kicked.v[middle] = 1;
  pair.y[middle] = 0.5;
  pair.y[middle + 1] = -0.5;

  // Displacements that rise in random steps, between two ends at rest
  const std::vector<double> rise = shaken(std::vector<double>(rising, 0.05), 0.8, 13);
  for (std::size_t n = middle; n < sites; ++n)
    increasing.y[n] = increasing.y[n - 1] + (n < middle + rising ? rise[n - middle] : 0);
  State<double> step_down = increasing;
  for (std::size_t n = middle + rising / 2; n < sites; ++n) step_down.y[n] -= 2 * rise[rising / 2];
  return {{"displaced", chain, displaced, time},
          {"kicked", chain, kicked, time},
          {"pair", chain, pair, time},
          {"breather", chain, resized(breather, sites), time},
          {"increasing", chain, increasing, time},
          {"step_down", chain, step_down, time}};
}

// How near a motion comes to its start again
struct Return {
  double away = 0, back = 1;  // largest distance from the start, and the ratio
  bool moved() const { return away > 1e-3; }
};

Return closest_return(const Motion& m, double step, double every) {
  Return out;
  const auto look = [&](const State<double>& now) {
    double d = 0;
    for (std::size_t n = 0; n < m.chain.sites; ++n)
      d = std::max({d, std::abs(now.y[n] - m.start.y[n]), std::abs(now.v[n] - m.start.v[n])});
    out.away = std::max(out.away, d);
    if (out.moved()) out.back = std::min(out.back, d / out.away);
  };
  State<double> state = m.start;
  const Run run = evolve(EventCorrected{step}, m.chain, state, m.time, every, look);
  assert_isolated(state, energy(m.chain, m.start) > 0 ? run.energy_drift : 0);
  return out;
}

// Every start on both chains
void report_returns(Report& report, const State<double>& breather) {
  const double every = 2 * std::numbers::pi / omega_b / instants,
               time = (report.quick ? 5 : 24) * instants * every;
  Table& table = report.table("returns");
  const auto add = [&](const std::string& chain, const std::vector<Motion>& motions) {
    table.fill(motions, [&](const Motion& m) {
      const Return coarse = closest_return(m, every, every),
                   fine = closest_return(m, every / 2, every);
      return Row{{"start", "motion at the start", m.name},
                 {"chain", "free chain of equal or uneven beads, or chain with wells", chain},
                 {"away", "largest distance from the start", compare(coarse.away, fine.away)},
                 {"back", "return ratio; nan if it stays",
                  fine.moved() ? compare(coarse.back, fine.back) : undefined, "",
                  "difference of two steps, against the largest ratio; nan if it stays"}};
    });
  };
  const Chain wells{return_sites, Harmonic{}};
  add("wells", {{"breather", wells, resized(breather, return_sites), time}});
  for (const auto& [name, alpha, part] :
       {std::tuple{"equal", alpha_ring, 0.}, {"uneven", alpha_box, 1.}})
    add(name, localized(uneven_chain(return_sites, Ends::free, alpha, part), breather, time));
}

/**
## What the proof does not say

No computation proves a theorem. Only an exact return of a localized state would have contradicted it; that our ten
states disperse is more than it says, and they are a sample. (That the means are equal follows from Newton's law alone;
there our motions and averages are on trial.) What one learns beyond the proof is how a breather without wells ends:
within a few of its periods, by collisions that become ever weaker and rarer. */
void reproduce(Report& report) {
  const Motion site = breather_in_wells(Centre::site), bond = breather_in_wells(Centre::bond);
  const std::vector<Motion> free = free_motions();
  report_means(report, {free[0], free[1], free[2], bond, site});
  report_spread(report, free);
  report_dispersal(report, site.start);
  report_returns(report, site.start);
}

/**
## Statement by statement

<!-- statements -->
| statement | printed | here | verdict |
|---|---|---|---|
| `thm.mean_force`: period-averaged contact force is the same at every bond and zero for a localized periodic motion |  | dispersal.mean (chain = free, t = 100), (chain = free, t = 200) away from 0.5: 0.02478 < 0.1 (the closest of 17) | holds |
| `thm.equilibria`: all time-periodic solutions that are localized to the right are independent of t and increasing with n (in the proof x_n >= x_(n-1)) |  | returns.back (start = displaced, chain = equal): 0.1 < 0.5121 (the closest of 12) | holds |
| `thm.wells`: with an on-site potential the average interaction forces are no more independent of n |  | mean_forces.force (motion = breather_site, n = 13), (motion = breather_site, n = 14): 0.0958 < 0.1449 (the closest of 10) | holds |
<!-- /statements -->

## Try it

**To change it.** The constants under *Model* are the knobs: try `alpha_ring = 2` with `alpha_box = 2.5`, a ring of 12
beads, or `unevenness = 0.3`. With `omega_b = 1.3` runs are longer, and `return_sites` must grow to 251; the program
stops if an end of a chain moves. Another localized state is one more line in `localized`.

1. *Easy.* What becomes of an impact when there are no wells?
   `build/bin/sec34_impact run --well none --velocity 1 --time 200` gives `packet_energy_fraction` = 0.99366. Hint:
   nearly all energy leaves in one solitary wave; it is localized but not periodic.
2. *Harder.* Shallow wells at a fixed period are unit wells at a high frequency. How large is a breather then?
   `build/bin/sec32_newton_breathers breather --omega 2` gives `amplitude` = 2.45676. Hint: substitute
   $y(t) = k^2\,Y(k^{1/2}t)$ in the equation with wells of stiffness $k$. What does the theorem say of $k \to 0$? */
int main(int argc, char** argv) {
  return run({"sec2_nonexistence", "2", "No breathers without an on-site potential (section 2)",
              reproduce},
             argc, argv);
}
