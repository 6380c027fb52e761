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
f$, a continuous, increasing function of the overlap with $f(0) = 0$. (Ever stiffer contacts could carry the same mean
at ever smaller overlaps.) So the mean is zero. A force that is never negative and has zero mean vanishes: the beads are
free, and the only periodic motion of free beads is rest, in which no contact overlaps, $x_n \ge x_{n-1}$
(`thm.equilibria`).

![Mean contact forces are the same at every contact of free chains (a) and not in wells (b); energy and mean force of a
localized state (c, d).](fig:x16)

<!-- head -->
`build/bin/sec2_nonexistence` computes this chapter in less than 1 s on two cores and writes 3 tables to
`build/data/sec2_nonexistence`. Its figures: `make x16`, `make x41`.
<!-- /head --> */
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "lattice/diagnostics/observe.hpp"          // window_sum
#include "lattice/events/event_driven.hpp"          // largest_difference
#include "lattice/gsl/random.hpp"                   // shaken
#include "lattice/gsl/reference.hpp"                // Reference: GSL
#include "lattice/integrators/event_corrected.hpp"  // evolve
#include "lattice/model/chain.hpp"                  // Chain, State, contacts
#include "lattice/orbits/breather.hpp"              // find_breather, resized
#include "lattice/orbits/shooting.hpp"              // Shooting, newton
#include "lattice/orbits/symmetry.hpp"              // even_in_time
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
constexpr double off = 0.001;        // relative change of a bead's displacement in the control
constexpr double omega_b = 1.5;      // of the breathers in wells
constexpr double tolerance = 1e-13;  // of GSL

/**
## The experiment: mean forces

GSL integrates the equations of motion, with the impulses of all contacts as further unknowns. The impulse over a
period, divided by the period, is the mean force. Contact $i$ of the code, from 0, lies to the left of bead $i$. */
struct Motion {
  std::string name;
  Chain chain;
  State<double> start;
  double time;
  bool returns = true;
};

struct Means {
  std::vector<double> push;  // of each contact
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
  std::vector<double> z = m.start.y;
  z.insert(z.end(), m.start.v.begin(), m.start.v.end());
  z.resize(unknowns);
  double t = 0;
  Reference(equations, unknowns, allowed).advance(t, m.time, z);

  // Impulses become means
  Means means;
  means.end.y.assign(z.begin(), z.begin() + long(v0));
  means.end.v.assign(z.begin() + long(v0), z.begin() + long(push0));
  for (std::size_t i = 0; i <= N; ++i) means.push.push_back(z[push0 + i] / m.time);
  return means;
}

/**
## Periodic motions of free chains

We find a periodic motion by shooting. Beads start from rest, neighbours displaced in opposite directions by the same
amplitude, and Newton's method corrects this until all velocities vanish after half a period; the motion then retraces
its path and closes. We do so on a ring and, with another exponent, in a row between walls. A ring may also be displaced
as a whole, so Newton's matrix is singular, and we take the correction of least norm. We begin with a
uniform chain, whose amplitude in one harmonic follows from $\omega^2A = 2c_1(2A)^{3/2}$ with the coefficient $c_1 =
0.458$ of $\cos t$ in $(\cos t)_+^{3/2}$, and deform it in four steps, `part` = 0.25 to 1. */
Chain uneven_chain(std::size_t sites, Ends ends, double alpha, double part) {
  Chain chain{sites, None{}, PowerContact{1.5 + part * (alpha - 1.5)}, ends};
  std::vector<double> mass(sites, 1), gamma(sites + 1, 1);
  gamma = shaken(gamma, unevenness * part, 12);              // random, with a seed
  if (ends == Ends::periodic) gamma.back() = gamma.front();  // one contact of a ring
  vary(chain, shaken(mass, unevenness * part, 11), gamma);
  return chain;
}

Motion standing_wave(const std::string& name, std::size_t sites, Ends ends, double alpha) {
  // Singular values below `rank` of the largest count as zero
  const NewtonRule<double> shortest{.most_steps = 60, .damped = true, .rank = 1e-9};
  const double c_1 = 0.458, A = std::pow(omega_free, 4) / (32 * c_1 * c_1);
  Motion m{name, {}, State<double>(sites), 2 * std::numbers::pi / omega_free};
  Vector<double> y(sites);
  for (long n = 0; n < y.size(); ++n) y[n] = n % 2 == 0 ? A : -A;
  for (double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    m.chain = uneven_chain(sites, ends, alpha, part);
    const Shooting<double> problem{m.chain, even_in_time(sites), omega_free};
    y = newton(problem.equations(), y, shortest).x;
  }
  m.start.y.assign(y.begin(), y.end());
  return m;
}

/**
The program stops if such a motion, found with `flow` (event_driven.hpp), does not come back to its start in GSL, which
shares only the force law with it. The control is a motion that is not periodic: the start of one bead of the ring is
changed by a thousandth.

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
      table.add({{"motion", m.name}, {"tolerance", allowed}, {"spread", (*most - *least) / *most}});
    }
}

/**
## Unequal means in wells (figure x16 b)

The article remarks that the proof fails with an on-site potential, since the means then depend on $n$ (`thm.wells`). We
take the breathers of section 3.2 in wells $W = \frac12x^2$: a few beads oscillate, neighbours out of phase, and the
others are nearly at rest. One is symmetric about a bead (*site*), the other about a contact (*bond*). The outermost
contacts carry nothing, so the mean falls to zero from the middle outwards, and at each bead the well makes up for the
difference: for the bond-centred breather it is [0.1525](cell:mean_forces/motion=breather_bond/n=12/force) at the middle
contact and [0.0038](cell:mean_forces/motion=breather_bond/n=16/force) at the fourth from there. */
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
    const Means coarse = mean_forces(m, 100 * tolerance), fine = mean_forces(m, tolerance);
    if (m.returns && largest_difference(fine.end, m.start) > 1e-9 * largest(m.start))
      throw Failure(m.name + " does not return to its start");
    // A ring has its first contact twice
    const std::size_t contacts = m.chain.ends == Ends::periodic ? m.chain.sites : m.chain.sites + 1;
    for (std::size_t i = 0; i < contacts; ++i) {
      if (!m.chain.pushes(i)) continue;
      table.add(
          {{"motion", m.name}, {"n", i + 1}, {"force", compare(coarse.push[i], fine.push[i])}});
    }
  }
}

/**
## Localized states disperse (figure x16 c, d)

What becomes of a breather whose wells are taken away? We start it in the middle of a long chain, once with its wells
and once without; and without wells also a bead that is displaced, one that is kicked, and two neighbours pushed
together. Every unit of time we record the energy on the nine sites around the centre, and the force of the contact
beside the central bead, averaged from the start up to $t$ (by the trapezoidal rule over all steps). Steps are
event-corrected (event_corrected.hpp), and half of their length gives the error. The program stops if the motion reaches
an end of the chain or the energy drifts: such a loss could pass for dispersal. */
constexpr std::size_t long_chain = 401;
constexpr int steps_per_unit = 20;  // of time

std::vector<Motion> localized(const State<double>& breather, double time) {
  const Chain free{long_chain, None{}}, wells{long_chain, Harmonic{}};
  const std::size_t middle = long_chain / 2;
  const State<double> rest(long_chain), standing = resized(breather, long_chain);
  State<double> displaced = rest, kicked = rest, pair = rest;
  displaced.y[middle] = 1;
  kicked.v[middle] = 1;
  pair.y[middle] = 0.5;
  pair.y[middle + 1] = -0.5;
  return {{"breather", free, standing, time},
          {"breather_in_wells", wells, standing, time},
          {"displaced", free, displaced, time},
          {"kicked", free, kicked, time},
          {"pair", free, pair, time}};
}

// At each instant: fraction of the energy on nine sites, and mean force
struct Dispersal {
  std::vector<double> t, core, mean;
};

Dispersal let_go(const Motion& m, int steps) {
  const std::size_t centre = m.chain.sites / 2;
  const double all = energy(m.chain, m.start), step = 1. / steps;
  Dispersal out;
  double impulse = 0, time_before = 0, push_before = 0;
  State<double> state = m.start;
  const auto observe = [&](const State<double>& now) {
    const double push = contact_push(m.chain, now.y.data(), centre + 1);
    impulse += (push_before + push) / 2 * (now.t - time_before);
    push_before = push;
    time_before = now.t;
    if (now.t == 0 || std::lround(now.t * steps) % steps != 0) return;
    out.t.push_back(now.t);
    out.core.push_back(window_sum(energy_density(m.chain, now), centre, 4) / all);
    out.mean.push_back(impulse / now.t);
  };
  const Run run = evolve(EventCorrected{step}, m.chain, state, m.time, step, observe);
  if (state.v.front() != 0 || state.v.back() != 0) throw Failure("the ends have moved");
  if (!(run.energy_drift < 1e-8)) throw Failure("the energy drifts");
  return out;
}

/**
Without wells the breather keeps [0.0438](cell:dispersal/motion=breather/t=20/core) of its energy on nine sites up to $t
= 20$ and [0.00163](cell:dispersal/motion=breather/t=200/core) up to $t = 200$; in wells
[0.99998](cell:dispersal/motion=breather_in_wells/t=200/core). The loss comes in steps (panel c): energy leaves only
while a contact at the edge of the nine sites pushes, that is in pulses of compression. What they leave behind are slow
beads, which meet again now and then. After $t = 20$ the contact closes four more times, near $t = 38$, 66, 101 and 149,
each time more weakly; in between it transmits nothing. So its mean force falls nearly like $1/t$, from
[0.00929](cell:dispersal/motion=breather/t=100/mean) at $t = 100$ to
[0.00488](cell:dispersal/motion=breather/t=200/mean) at $t = 200$. In wells it pushes in every period, and the mean
stays.

The displaced bead, the kicked bead and the pair end sooner: at $t = 20$ they keep
[0.0058](cell:dispersal/motion=displaced/t=20/core), [0.0063](cell:dispersal/motion=kicked/t=20/core) and
[0.0063](cell:dispersal/motion=pair/t=20/core). From $t = 20$ on none of the four has more than 4.4 per cent of its
energy left in any record, and a periodic motion would have to come back to all of it, unless its period is longer than
the run. The theorem leaves states of rest in which no contact overlaps. */
void report_dispersal(Report& report, const State<double>& breather) {
  Table& table = report.table("dispersal");
  for (const Motion& m : localized(breather, report.quick ? 60 : 200)) {
    const Dispersal coarse = let_go(m, steps_per_unit), fine = let_go(m, 2 * steps_per_unit);
    for (std::size_t i = 0; i < fine.t.size(); ++i)
      table.add({{"motion", m.name},
                 {"t", fine.t[i]},
                 {"core", compare(coarse.core[i], fine.core[i])},
                 {"mean", compare(coarse.mean[i], fine.mean[i])}});
  }
}

/**
No computation proves a theorem. A localized state that returns would have contradicted it; that the four disperse is
more than it says, and they are a sample. (That the means are equal follows from Newton's law alone; there our motions
and averages are on trial.) */
void reproduce(Report& report) {
  const Motion site = breather_in_wells(Centre::site), bond = breather_in_wells(Centre::bond);
  const std::vector<Motion> free = free_motions();
  report_means(report, {free[0], free[1], free[2], bond, site});
  report_spread(report, free);
  report_dispersal(report, site.start);
}

/**
## Statement by statement

<!-- statements -->
| statement | printed | here | verdict |
|---|---|---|---|
| `thm.mean_force`: period-averaged contact force is the same at every bond and zero for a localized periodic motion |  | dispersal.mean (motion = breather, t = 100), (motion = breather, t = 200) away from 0.5: 0.02478 < 0.1 (the closest of 17) | holds |
| `thm.equilibria`: all time-periodic solutions that are localized to the right are independent of t and increasing with n (in the proof x_n >= x_(n-1)) |  | dispersal.core (motion = breather, t = 20) and 180 other values: 0.04381 < 0.1 (the closest of 4) | holds |
| `thm.wells`: with an on-site potential the average interaction forces are no more independent of n |  | mean_forces.force (motion = breather_site, n = 13), (motion = breather_site, n = 14): 0.0958 < 0.1449 (the closest of 10) | holds |
<!-- /statements -->

## Try it

**To change it.** The constants under *Model* are the knobs: try `alpha_ring = 2` with `alpha_box = 2.5`, a ring of 12
beads with `unevenness = 0.3`, or `omega_b = 1.3`. Another localized state is one more line in `localized`; the program
stops if an end of its chain moves.

1. *Easy.* What becomes of an impact when there are no wells?
   `build/bin/sec34_impact run --well none --velocity 1 --time 200` gives `packet_energy_fraction` = 0.99366. Hint:
   nearly all energy leaves in one solitary wave; it is localized but not periodic.
2. *Harder.* Shallow wells at a fixed period are unit wells at a high frequency. How large is a breather then?
   `build/bin/sec32_newton_breathers breather --omega 2` gives `amplitude` = 2.45676. Hint: substitute
   $x(t) = k^2\,\tilde x(k^{1/2}t)$ in the equation with wells of stiffness $k$. What does the theorem say of $k \to 0$? */
int main(int argc, char** argv) {
  return run({"sec2_nonexistence", "2", "No breathers without an on-site potential (section 2)",
              reproduce},
             argc, argv);
}
