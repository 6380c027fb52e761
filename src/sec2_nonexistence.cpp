/**
# 2 No breathers without an on-site potential

Does a chain of beads need wells to have breathers, motions that are periodic in time and localized in space? It does if
beads only repel each other: section 2 of James, Kevrekidis and Cuevas (Physica D 251, 2013) has a proof, which rests on
one identity. The mean force is the same at every contact of a periodic motion; we check this without wells, and see it
fail in wells. Then we ask what the proof does not say: how does a localized state end? Without its wells a breather
loses 95 per cent of its energy within five periods.

The proof is one integral. Let $F_n \ge 0$ be the push of contact $n$, between the beads $n-1$ and $n$. Bead $n$ obeys
$m_n\ddot x_n = F_n - F_{n+1}$, and over a period $T$
$$0 = m_n\bigl[\dot x_n(T)-\dot x_n(0)\bigr] = \int_0^T F_n\,dt - \int_0^T F_{n+1}\,dt :$$
the mean force $\bar F_n$ is the same at every contact (`thm.mean_force`). Far to the right of a localized motion, Eq.
(5), the overlaps tend to zero, and so do the forces, for by hypothesis (2) all contacts there obey one bound $F_n \le
f$ of the overlap with $f(0) = 0$. (Ever stiffer contacts could carry the same mean at ever smaller overlaps.) So the
mean is zero. A force that is never negative and has zero mean vanishes: the beads are free, and the only periodic
motion of free beads is rest, in which no contact overlaps, $x_n \ge x_{n-1}$ (`thm.equilibria`).

![Mean contact forces are the same at every contact of free chains (a) and not in wells (b); energy and mean force of a
localized state (c, d). Drawn by x16_mean_force.py from the tables `mean_forces` (against `n`) and `dispersal` (against
`t`).](fig:x16)

<!-- head -->
`build/bin/sec2_nonexistence` computes this chapter in less than 1 s on two cores and writes 4 tables to
`build/data/sec2_nonexistence`. Its figures: `make x16`, `make x41`.
<!-- /head --> */
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "lattice/diagnostics/observe.hpp"
#include "lattice/gsl/random.hpp"
#include "lattice/gsl/reference.hpp"
#include "lattice/integrators/event_corrected.hpp"
#include "lattice/model/chain.hpp"
#include "lattice/orbits/breather.hpp"
#include "lattice/orbits/symmetry.hpp"
#include "report/program.hpp"
#include "sec2/localized.hpp"
#include "sec2/ring_wave.hpp"

using namespace lattice;

/**
## Model

The chain is that of Eqs. (1) and (3), dimensionless, with a mass for each bead and a stiffness for each contact. Wells
$W$ (section 3) add one more force:
$$m_n\ddot x_n = F_n-F_{n+1}-W'(x_n),\qquad F_n = \gamma_n\,(x_{n-1}-x_n)_+^{\alpha}.$$
Its mean over a time $T$ is the balance of a bead, whose left side vanishes over a period:
$$\frac{m_n}{T}\bigl[\dot x_n\bigr]_0^T = \bar F_n-\bar F_{n+1}-\overline{W'(x_n)}.$$

The article gives a proof and no computation, so every parameter is ours. Localized motions of the free chain do not
exist: we test the identity on motions that fill a ring or a box. */
constexpr double period = 2 * std::numbers::pi;  // of the motions without wells
constexpr double unevenness = 0.15;  // largest deviation of masses and stiffnesses from 1
constexpr std::size_t ring_sites = 8, box_sites = 6;
constexpr double alpha_ring = 1.5, alpha_box = 2;
constexpr double off = 0.001;    // relative displacement of a bead in the control
constexpr double omega_b = 1.5;  // of the breathers in wells
constexpr double coarse_tolerance = 1e-11, tolerance = 1e-13;  // of GSL

/**
## The experiment: mean forces

GSL integrates the equations of motion, with the impulses of all contacts and of all wells as further unknowns. Divided
by the time they are the means. */
struct Motion {
  std::string name;
  Chain chain;
  State<double> start;
  double time;
  bool returns = true;
};

struct Means {
  std::vector<double> push, well;  // of contact i, to the left of bead i, and of bead i, from 0
  State<double> end;
};

Means mean_forces(const Motion& m, double allowed) {
  const Chain& chain = m.chain;
  // Where the velocities and the two kinds of impulses begin among the unknowns
  const std::size_t N = chain.sites, v = N, push = 2 * N, well = 3 * N + 1, unknowns = 4 * N + 1;
  const auto equations = [&](double, const double* z, double* rate) {
    for (std::size_t i = 0; i <= N; ++i) rate[push + i] = contact_push(chain, z, i);
    for (std::size_t n = 0; n < N; ++n) {
      rate[n] = z[v + n];
      rate[well + n] = -chain.well.force(z[n]);
      rate[v + n] = (rate[push + n] - rate[push + n + 1] - rate[well + n]) / chain.mass_of(n);
    }
  };
  std::vector<double> z(unknowns);
  std::copy(m.start.y.begin(), m.start.y.end(), z.begin());
  std::copy(m.start.v.begin(), m.start.v.end(), z.begin() + long(v));
  double t = 0;
  Reference(equations, unknowns, allowed).advance(t, m.time, z);

  // Impulses become means
  Means means{{}, {}, State<double>(N)};
  for (std::size_t i = 0; i <= N; ++i) means.push.push_back(z[push + i] / m.time);
  for (std::size_t n = 0; n < N; ++n) {
    means.well.push_back(z[well + n] / m.time);
    means.end.y[n] = z[n];
    means.end.v[n] = z[v + n];
  }
  return means;
}

/**
The program stops if contacts and wells do not add up to the change of momentum of a bead, as they must on any motion,
since then our averages are wrong. It stops too if GSL, which shares nothing but the force law with the integrator that
found a motion, does not bring it back to its start, since then the motion is not periodic. */
void check(const Motion& m, const Means& means) {
  const double small = 1e-9 * largest(m.start);
  for (std::size_t n = 0; n < m.chain.sites; ++n) {
    const double y = means.end.y[n] - m.start.y[n], v = means.end.v[n] - m.start.v[n];
    const double gained = m.chain.mass_of(n) * v / m.time,
                 given = means.push[n] - means.push[n + 1] - means.well[n];
    if (!(std::abs(gained - given) < small))
      throw Failure(m.name + ": the mean forces do not balance the momentum of a bead");
    if (m.returns && !(std::max(std::abs(y), std::abs(v)) < small))
      throw Failure(m.name + " does not return to its start");
  }
}

/**
## Periodic motions of free chains

We find a periodic motion by shooting. Beads start from rest, neighbours displaced in opposite directions by the
amplitude $A$ of a guess. Newton's method corrects the start until all velocities vanish after half a period; the motion
then retraces its path and closes. A ring without wells may also be displaced as a whole, which makes the matrix
singular; of all steps we take the shortest. The guess is that of a uniform ring with only the first harmonic of the two
forces on a bead. From there `part` runs from 0 to 1: masses and stiffnesses deviate by up to `part` times 15 per cent,
and the exponent has gone that part of the way from 3/2 to `alpha`. */
Chain uneven_chain(std::size_t sites, Ends ends, double alpha, double part) {
  Chain chain{sites, None{}, PowerContact{1.5 + part * (alpha - 1.5)}, ends};
  const std::vector<double> ones(sites + 1, 1);
  std::vector<double> gamma = shaken(ones, unevenness * part, 12);  // random, with a seed
  if (ends == Ends::periodic) gamma.back() = gamma.front();         // one contact of a ring
  vary(chain, shaken({ones.begin(), ones.end() - 1}, unevenness * part, 11), gamma);
  return chain;
}

State<double> standing_wave(std::size_t sites, Ends ends, double alpha) {
  const double A = std::pow(2 * harmonic * std::pow(2, 1.5), -2);  // A = 2 harmonic (2 A)^(3/2)
  Vector<double> y(sites);
  for (long n = 0; n < y.size(); ++n) y[n] = n % 2 == 0 ? A : -A;
  for (double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const Shooting<double> problem{uneven_chain(sites, ends, alpha, part), even_in_time(sites), 1};
    y = newton(problem.equations(), y, shortest).x;
  }
  State<double> start(sites);
  start.y.assign(y.begin(), y.end());
  return start;
}

/**
We take a ring and, with another exponent, a row between walls. A ring of equal beads carries a wave too
(sec2/ring_wave.hpp), where symmetry alone makes the means equal; it checks the averages. The control is a motion that
is not periodic: one bead of the uneven ring starts a thousandth off. The means of the three periodic motions agree at
all contacts, those of the control differ by almost a thousandth.

| mean force over the largest one, at contact | 1 | 2 | 4 |
|---|---|---|---|
| equal beads, ring | [1.00000](cell:mean_forces/motion=ring_wave/n=1/relative) | [1.00000](cell:n=2/relative) | [1.00000](cell:n=4/relative) |
| uneven, ring, $\alpha = 3/2$ | [1.00000](cell:mean_forces/motion=uneven_ring/n=1/relative) | [1.00000](cell:n=2/relative) | [1.00000](cell:n=4/relative) |
| uneven, between walls, $\alpha = 2$ | [1.00000](cell:mean_forces/motion=walls/n=1/relative) | [1.00000](cell:n=2/relative) | [1.00000](cell:n=4/relative) |
| uneven, ring, does not return | [0.999579](cell:mean_forces/motion=not_returning/n=1/relative) | [0.999243](cell:n=2/relative) | [1.00000](cell:n=4/relative) | */
Motion on_uneven_ring(double displaced = 0) {
  Motion m{"uneven_ring", uneven_chain(ring_sites, Ends::periodic, alpha_ring, 1),
           standing_wave(ring_sites, Ends::periodic, alpha_ring), period};
  if (displaced != 0) m.name = "not_returning";
  m.returns = displaced == 0;
  m.start.y[0] *= 1 + displaced;
  return m;
}

Motion between_walls() {
  return {"walls", uneven_chain(box_sites, Ends::fixed, alpha_box, 1),
          standing_wave(box_sites, Ends::fixed, alpha_box), period};
}

// Once round the ring, with three wavelengths on it
Motion wave_on_ring() {
  const Orbit<double> wave = ring_wave(ring_sites, 3 * period / ring_sites);
  const Chain ring{ring_sites, None{}, PowerContact{1.5}, Ends::periodic};
  return {"ring_wave", ring, wave.start, ring_sites * wave.period()};
}

/**
## Unequal means in wells (figure x16 b)

The article remarks that the proof fails with an on-site potential, since the means then depend on $n$ (`thm.wells`). We
take breathers in wells $W = \frac12y^2$: a few beads oscillate, neighbours out of phase, and the others are nearly at
rest. There are two kinds, symmetric about a bead (*site*) and about a contact (*bond*), which section 3.2 computes by
the same method (sec32_newton_breathers.cpp). On free chains, long enough for the tails, the outermost contacts carry
nothing; so the mean falls from its largest value to zero, and at each bead the well makes up for the difference.

| mean force over the largest one, contacts from the middle | 0 | 1 | 2 | 4 |
|---|---|---|---|---|
| bond-centred breather | [1.000](cell:mean_forces/motion=breather_bond/n=12/relative) | [0.815](cell:n=13/relative) | [0.433](cell:n=14/relative) | [0.0249](cell:n=16/relative) | */
Motion breather_in_wells(Centre centre) {
  const bool bond = centre == Centre::bond;
  const auto problem = breather_problem(centre, omega_b, 0, bond ? 22 : 23);
  const Orbit<double> orbit = find_breather(problem);
  return {bond ? "breather_bond" : "breather_site", problem.chain, orbit.start, orbit.period()};
}

// Panels a and b, contact by contact
void report_means(Report& report) {
  constexpr const char* from = "difference of two tolerances, against the largest force";
  Table& table = report.table("mean_forces");
  for (const Motion& m : {wave_on_ring(), on_uneven_ring(), between_walls(), on_uneven_ring(off),
                          breather_in_wells(Centre::bond), breather_in_wells(Centre::site)}) {
    const Means coarse = mean_forces(m, coarse_tolerance), fine = mean_forces(m, tolerance);
    check(m, fine);
    const double top = *std::max_element(fine.push.begin(), fine.push.end()),
                 coarse_top = *std::max_element(coarse.push.begin(), coarse.push.end());
    for (std::size_t i = 0; i <= m.chain.sites; ++i) {
      const bool again = m.chain.ends == Ends::periodic && i == m.chain.sites;
      if (!m.chain.pushes(i) || again) continue;
      table.add({{"motion", "name of the motion; all are periodic but not_returning", m.name},
                 {"n", "contact, to the left of bead n; 1 is the first", i + 1, "site"},
                 {"force", "mean force of the contact over a period",
                  Estimate{fine.push[i], std::abs(fine.push[i] - coarse.push[i])}, "", from},
                 {"relative", "mean force divided by the largest one of this motion",
                  compare(coarse.push[i] / coarse_top, fine.push[i] / top), "", from}});
    }
  }
}

/**
## Accuracy

How equal are equal means? The figure shows their spread on the uneven ring, largest minus least over the largest,
against the tolerance of GSL. On the periodic motion it falls with the tolerance, to below $10^{-12}$. On the control it
does not fall: there it is physics, and not error.

![Spread of the mean forces on a ring against the tolerance of the integration.](fig:x41) */
void report_accuracy(Report& report) {
  const Motion periodic = on_uneven_ring(), control = on_uneven_ring(off);
  const auto spread = [](const Motion& m, double allowed) {
    const std::vector<double> push = mean_forces(m, allowed).push;
    const auto [least, most] = std::minmax_element(push.begin(), push.end());
    return (*most - *least) / *most;
  };
  Table& table = report.table("spread");
  for (int digits = 4; digits <= (report.quick ? 8 : 14); ++digits) {
    const double allowed = std::pow(10, -digits);
    table.add(
        {{"tolerance", "of GSL, for each step", allowed},
         {"periodic", "spread of the mean forces over the largest", spread(periodic, allowed)},
         {"control", "of the motion that does not return", spread(control, allowed)}});
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
| mean force up to $t = 100$ | [0.00929](cell:dispersal/chain=free/t=100/mean) | [0.143](cell:chain=wells/mean) |
| up to $t = 200$ | [0.00488](cell:dispersal/chain=free/t=200/mean) | [0.144](cell:chain=wells/mean) |

In wells the mean stays. Without them it nearly halves when the time doubles, that is, it falls like $1/t$: the impulse
that the contact transmits, $t$ times the mean, hardly grows any more. The contact still closes now and then, but ever
more weakly. */
constexpr std::size_t dispersal_sites = 401;
constexpr int steps_per_unit = 20;  // of time

struct Dispersal {
  std::vector<double> t, core, mean;
};

Dispersal let_go(const State<double>& breather, const Well& well, double time, int steps) {
  const Chain chain{dispersal_sites, well};
  const std::size_t centre = dispersal_sites / 2;
  State<double> state = resized(breather, dispersal_sites);
  const double all = energy(chain, state), step = 1. / steps;
  Dispersal out;
  double impulse = 0, before = 0;
  int taken = 0;
  const auto look = [&](const State<double>& now) {
    const double push = contact_push(chain, now.y.data(), centre + 1);
    if (taken > 0) impulse += (before + push) / 2 * step;
    before = push;
    if (taken % steps == 0) {
      out.t.push_back(now.t);
      out.core.push_back(window_sum(energy_density(chain, now), centre, 4) / all);
      out.mean.push_back(taken > 0 ? impulse / now.t : push);
    }
    ++taken;
  };
  const Run run = evolve(EventCorrected{step}, chain, state, time, step, look);
  assert_isolated(state, run.energy_drift);
  return out;
}

// Panels c and d, instant by instant
void report_dispersal(Report& report) {
  const State<double> breather = breather_in_wells(Centre::site).start;
  const double time = report.quick ? 60 : 200;
  Table& table = report.table("dispersal");
  for (const std::string chain : {"free", "wells"}) {
    const Well well = chain == "free" ? Well{None{}} : Well{Harmonic{}};
    const Dispersal coarse = let_go(breather, well, time, steps_per_unit),
                    fine = let_go(breather, well, time, 2 * steps_per_unit);
    for (std::size_t i = 0; i < fine.t.size(); ++i)
      table.add({{"chain", "chain without wells (free) or with them (wells)", chain},
                 {"t", "time", fine.t[i]},
                 {"core", "fraction of the energy on nine sites",
                  Estimate{fine.core[i], std::abs(fine.core[i] - coarse.core[i])}, "",
                  "difference of two resolutions, against the largest fraction"},
                 {"mean", "force of a central contact, averaged from 0 to t",
                  Estimate{fine.mean[i], std::abs(fine.mean[i] - coarse.mean[i])}, "",
                  "difference of two resolutions, against the largest mean"}});
  }
}

/**
## No localized state returns

A periodic motion returns to its start. So we start localized motions in a free chain and ask how near they come to
their starts again: one bead that is displaced, one that is kicked, two neighbours pushed together, and the breather.
Let $d(t)$ be the largest change of a displacement or velocity since the start. Once it has exceeded a thousandth, we
record the least value of $d(t)/\max_{t'\le t}d(t')$ (sec2/localized.hpp). It is one for a motion that only goes away
and zero for a periodic one, unless its period is longer than the run of 24 periods of the breather. The theorem leaves
states of rest in which no contact overlaps: a sequence of displacements that increases, with random steps, must stay,
and must not if one step is reversed.

| least $d(t)/\max d$ | equal beads, $\alpha = 3/2$ | uneven beads, $\alpha = 2$ |
|---|---|---|
| displaced bead | [0.512](cell:returns/start=displaced/chain=equal/back) | [0.630](cell:chain=uneven/back) |
| kicked bead | [0.970](cell:returns/start=kicked/chain=equal/back) | [0.902](cell:chain=uneven/back) |
| pair pushed together | [0.698](cell:returns/start=pair/chain=equal/back) | [0.755](cell:chain=uneven/back) |
| breather | [0.669](cell:returns/start=breather/chain=equal/back) | [0.659](cell:chain=uneven/back) |
| increasing sequence, one step reversed | [0.997](cell:returns/start=step_down/chain=equal/back) | [0.978](cell:chain=uneven/back) |
| control: breather in wells | [0 ± 2e-11](cell:returns/start=breather/chain=wells/back) | |

The control returns at every period; nothing else comes back even half of its way. The increasing sequence does not move
at all. */
constexpr std::size_t return_sites = 201;
constexpr int instants = 168;  // in a period of the breather

void report_returns(Report& report) {
  const State<double> breather = breather_in_wells(Centre::site).start;
  struct Case {
    std::string chain, start;
  };
  std::vector<Case> cases{{"wells", "breather"}};
  for (const char* chain : {"equal", "uneven"})
    for (const char* start : {"displaced", "kicked", "pair", "breather", "increasing", "step_down"})
      cases.push_back({chain, start});
  const double every = period / omega_b / instants,
               time = (report.quick ? 5 : 24) * instants * every;
  const auto row = [&](const Case& c) {
    Chain chain{return_sites, Harmonic{}};
    if (c.chain == "equal") chain = uneven_chain(return_sites, Ends::free, alpha_ring, 0);
    if (c.chain == "uneven") chain = uneven_chain(return_sites, Ends::free, alpha_box, 1);
    const State<double> start = localized(c.start, breather, return_sites);
    const Return coarse = closest_return(chain, start, every, every, time),
                 fine = closest_return(chain, start, every / 2, every, time);
    return Row{
        {"start", "motion at the start", c.start},
        {"chain", "free chain of equal or uneven beads, or chain with wells", c.chain},
        {"away", "largest distance from the start", compare(coarse.away, fine.away)},
        {"back", "least distance from the start over the largest one before; nan if it stays",
         fine.moved ? compare(coarse.back, fine.back) : undefined, "",
         "difference of two steps, against the largest ratio; nan if it stays"}};
  };
  report.table("returns").fill(cases, row, "starts");
}

/**
## What the proof does not say

No computation proves a theorem, but ours could have refuted it, by a localized state that stays together or returns.
(That the means are equal follows from Newton's law alone; there our motions and averages are on trial.) What one learns
beyond the proof is how a localized state ends: within a few of its periods, while each contact transmits little more
than the impulse of its first pushes. */
void reproduce(Report& report) {
  report_means(report);
  report_accuracy(report);
  report_dispersal(report);
  report_returns(report);
}

/**
## Statement by statement

<!-- statements -->
| statement | printed | here | verdict |
|---|---|---|---|
| `thm.mean_force`: period-averaged contact force is the same at every bond and zero for a localized periodic motion |  | mean_forces.force (motion = ring_wave, n = 5): 9.412e-12 < 1e-08 (the closest of 25) | holds |
| `thm.equilibria`: all time-periodic solutions that are localized to the right are independent of t and increasing with n (in the proof x_n >= x_(n-1)) |  | returns.back (start = displaced, chain = equal): 0.1 < 0.5121 (the closest of 12) | holds |
| `thm.wells`: with an on-site potential the average interaction forces are no more independent of n |  | mean_forces.force (motion = breather_site, n = 13), (motion = breather_site, n = 14): 0.0958 < 0.1449 (the closest of 10) | holds |
<!-- /statements -->

## Try it

**To change it.** The constants under *Model* are the knobs: try `alpha_ring = 2` with `alpha_box = 2.5`, a ring of 12
beads, or `unevenness = 0.3`. With `omega_b = 1.3` runs are longer, and `return_sites` must grow to 251; the program
stops if an end of a chain moves. Another localized state is the first argument of `let_go`, such as
`localized("kicked", breather, dispersal_sites)`.

1. *Easy.* What becomes of an impact when there are no wells?
   `build/bin/sec34_impact run --well none --velocity 1 --time 200` gives `packet_energy_fraction` = 0.99366. Hint:
   nearly all energy leaves in one solitary wave; it is localized but not periodic.
2. *Harder.* Shallow wells at a fixed period are unit wells at a high frequency. How large is a breather then?
   `build/bin/sec32_newton_breathers breather --omega 2` gives `amplitude` = 2.45676. Hint: substitute
   $y(t) = k^2\,Y(k^{1/2}t)$ in the equation with wells of stiffness $k$. What does the theorem say of $k \to 0$? */
int main(int argc, char** argv) {
  return run({"sec2_nonexistence", "2", "No breathers without wells (section 2)", reproduce}, argc,
             argv);
}
