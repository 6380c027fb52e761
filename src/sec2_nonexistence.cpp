/**
# 2 No breathers without an on-site potential

Does a chain of beads need wells to have breathers, motions that are periodic in time and localized in space? It does if
beads only repel each other: section 2 of James, Kevrekidis and Cuevas (Physica D 251, 2013) has a proof, which rests on
one identity. The mean force is the same at every contact of a periodic motion; we check this without wells, and see it
fail in wells. Then we ask what the proof does not say: how does a localized state end? Five periods after a breather
has lost its wells, 95 per cent of its energy has left the nine sites around its centre. Such states illustrate the
theorem; that $x_n$ increases with $n$ at rest is not tested.

The proof is one integral. Let $F_n \ge 0$ be the push of contact $n$, between the beads $n-1$ and $n$. Bead $n$ obeys
$m_n\ddot x_n = F_n - F_{n+1}$, and over a period $T$
$$0 = m_n\bigl[\dot x_n(T)-\dot x_n(0)\bigr] = \int_0^T F_n\,dt - \int_0^T F_{n+1}\,dt :$$
the mean force $\bar F_n$ is the same at every contact (`thm.mean_force`). Far to the right of a localized motion, Eq.
(5), the overlaps tend to zero, and so do the forces, for by hypothesis (2) all contacts there obey one bound $F_n \le
f$, a continuous, increasing function of the overlap with $f(0) = 0$. So the mean is zero. A force that is never
negative and has zero mean vanishes: the beads are free, and the only periodic motion of free beads is rest, in which no
contact overlaps, $x_n \ge x_{n-1}$ (`thm.equilibria`).

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

#include "lattice/diagnostics/path.hpp"             // energy_density, window_sum
#include "lattice/events/event_driven.hpp"          // largest, largest_difference
#include "lattice/gsl/random.hpp"                   // perturbed
#include "lattice/gsl/reference.hpp"                // Reference: GSL
#include "lattice/integrators/event_corrected.hpp"  // evolve
#include "lattice/model/chain.hpp"                  // Chain, State, vary, contact_push
#include "lattice/orbits/breather.hpp"              // find_breather, resized
#include "lattice/orbits/shooting.hpp"              // Shooting, newton
#include "lattice/orbits/symmetry.hpp"              // even_in_time
#include "report/program.hpp"

using namespace lattice;
using namespace report;

/**
## Model

The chain is that of Eqs. (1) and (3), dimensionless, with a mass for each bead and a stiffness for each contact. Wells
$W$ (section 3) add one more force:
$$m_n\ddot x_n = F_n-F_{n+1}-W'(x_n),\qquad F_n = \gamma_n\,(x_{n-1}-x_n)_+^{\alpha}.$$

The library calls $x_n$ `y`, and its contact $i$, from 0, lies to the left of bead $i$; in tables $n = i+1$. Every
parameter is ours. Localized periodic motions do not exist here: those that test the identity fill a ring or a box. */
constexpr double omega_free = 1;     // frequency of the motions without wells
constexpr double unevenness = 0.15;  // largest deviation of masses and stiffnesses from 1
constexpr std::size_t ring_sites = 8, box_sites = 6;
constexpr double alpha_ring = 1.5, alpha_box = 2;
constexpr int mass_seed = 11, contact_seed = 12;
constexpr double off = 0.001;       // relative change of a bead's displacement in the control
constexpr double omega_b = 1.5;     // of the breathers in wells
constexpr double accuracy = 1e-13;  // of a step of GSL
constexpr std::size_t long_chain = 401, core_reach = 4;  // sites; nine around the centre
constexpr int steps_per_unit = 20;                       // of time

/**
## The experiment: mean forces

GSL integrates the equations of motion, with the impulses of all contacts as further unknowns. The impulse over a
period, divided by the period, is the mean force. */
struct Motion {
  std::string name;
  Chain chain;
  State<double> start;
  double duration;  // the period, if it is periodic
  bool periodic = true;
};

struct Means {
  std::vector<double> push;  // of each contact
  State<double> end;
};

Means mean_forces(const Motion& m, double tolerance) {
  // Where positions, velocities and impulses begin among the unknowns
  const std::size_t N = m.chain.sites, x = 0, v = N, impulse = 2 * N, unknowns = 3 * N + 1;
  const auto equations = [&](double, const double* z, double* rate) {
    for (std::size_t n = 0; n < N; ++n) {
      rate[x + n] = z[v + n];
      rate[v + n] = acceleration(m.chain, z + x, n);
    }
    for (std::size_t i = 0; i <= N; ++i) rate[impulse + i] = contact_push(m.chain, z + x, i);
  };
  std::vector<double> z = m.start.y;
  z.insert(z.end(), m.start.v.begin(), m.start.v.end());
  z.resize(unknowns);
  double t = 0;
  Reference(equations, unknowns, tolerance).advance(t, m.duration, z);

  // Impulses become means
  Means means{.push = {}, .end = State<double>(N)};
  std::copy_n(&z[x], N, means.end.y.begin());
  std::copy_n(&z[v], N, means.end.v.begin());
  for (std::size_t i = 0; i <= N; ++i) means.push.push_back(z[impulse + i] / m.duration);
  return means;
}

/**
## Periodic motions of free chains

We find a periodic motion by shooting. Beads start from rest, neighbours displaced in opposite directions by the same
amplitude, and Newton's method corrects this until all velocities vanish after half a period; the motion then retraces
its path and closes. We do so on a ring and, with another exponent, in a row between walls. A ring may also be displaced
as a whole, so Newton's matrix is singular, and we take the correction of least norm. We begin with a uniform ring,
whose amplitude $A$, with one harmonic kept, follows from $\omega^2A = 2c_1(2A)^{3/2}$ with the coefficient $c_1 =
0.458$ of $\cos t$ in $(\cos t)_+^{3/2}$, and deform it in four steps, `part` = 0.25 to 1. Between walls we start from
the same $A$, though a bead meets a wall with overlap $A$, not $2A$. */
Chain uneven_chain(std::size_t sites, Ends ends, double alpha, double part) {
  Chain chain{sites, NoWell{}, PowerContact{1.5 + part * (alpha - 1.5)}, ends};
  std::vector<double> mass(sites, 1), gamma(sites + 1, 1);
  gamma = perturbed(gamma, unevenness * part, contact_seed);  // random
  if (ends == Ends::periodic) gamma.back() = gamma.front();   // one contact of a ring
  vary(chain, perturbed(mass, unevenness * part, mass_seed), gamma);
  return chain;
}

Motion standing_wave(const std::string& name, std::size_t sites, Ends ends, double alpha) {
  // Singular values below `rank` of the largest count as zero
  const NewtonRule<double> least_norm{.most_steps = 60, .damped = true, .rank = 1e-9};
  const double c_1 = 0.458, A = std::pow(omega_free, 4) / (32 * c_1 * c_1);
  Motion m{name, {}, State<double>(sites), 2 * std::numbers::pi / omega_free};
  Vector<double> y(sites);
  for (long n = 0; n < y.size(); ++n) y[n] = n % 2 == 0 ? A : -A;
  for (double part : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    m.chain = uneven_chain(sites, ends, alpha, part);
    const Shooting<double> problem{m.chain, even_in_time(sites), omega_free};
    y = newton(problem.equations(), y, least_norm).x;
  }
  m.start.y.assign(y.begin(), y.end());
  return m;
}

/**
The program stops if such a motion, found with `flow`, does not come back to its start in GSL, which shares only the
force law with it. Then equal means are Newton's law: neighbouring ones differ by $m_n[\dot x_n(T) -\dot x_n(0)]/T$, and
our orbits and averages are on trial. The control, the ring with one bead displaced by a thousandth more, does not
return, and its means lie between [0.0407858](cell:mean_forces/motion=not_returning/n=2/force) and
[0.0408167](cell:mean_forces/motion=not_returning/n=4/force). */
std::vector<Motion> free_motions() {
  const Motion ring = standing_wave("uneven_ring", ring_sites, Ends::periodic, alpha_ring);
  Motion control = ring;
  control.name = "not_returning";
  control.periodic = false;
  control.start.y[0] *= 1 + off;
  return {ring, standing_wave("walls", box_sites, Ends::fixed, alpha_box), control};
}

/**
## Unequal means in wells (figure x16 b)

The article remarks that the proof fails with an on-site potential, since the means then depend on $n$ (`thm.wells`). We
take the breathers of section 3.2 in wells $W = \frac12x^2$: a few beads oscillate, neighbours out of phase, and the
others are nearly at rest. One is symmetric about a bead (*site*), the other about a contact (*bond*). The outermost
contacts carry practically nothing, so the mean falls to zero from the middle outwards, and at each bead the well makes
up for the difference: for the bond-centred breather it is [0.1525](cell:mean_forces/motion=breather_bond/n=12/force) at
the middle contact and [0.0038](cell:mean_forces/motion=breather_bond/n=16/force) at the fourth from there. */
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
    const Means coarse = mean_forces(m, 100 * accuracy), fine = mean_forces(m, accuracy);
    if (m.periodic && largest_difference(fine.end, m.start) > 1e-9 * largest(m.start))
      throw Failure(m.name + " does not return to its start");
    // A ring has its first contact twice
    const std::size_t contacts = m.chain.ends == Ends::periodic ? m.chain.sites : m.chain.sites + 1;
    for (std::size_t i = 0; i < contacts; ++i) {
      if (!m.chain.has_contact(i)) continue;  // a free end
      table.add(
          {{"motion", m.name}, {"n", i + 1}, {"force", with_error(coarse.push[i], fine.push[i])}});
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
std::vector<Motion> localized(const State<double>& breather, double duration) {
  const Chain free{long_chain, NoWell{}}, wells{long_chain, Harmonic{}};
  const std::size_t middle = long_chain / 2;
  const State<double> rest(long_chain), standing = resized(breather, long_chain);
  State<double> displaced = rest, kicked = rest, pair = rest;
  displaced.y[middle] = 1;
  kicked.v[middle] = 1;
  pair.y[middle] = 0.5;
  pair.y[middle + 1] = -0.5;
  return {{"breather", free, standing, duration},
          {"breather_in_wells", wells, standing, duration},
          {"displaced", free, displaced, duration},
          {"kicked", free, kicked, duration},
          {"pair", free, pair, duration}};
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
    out.core.push_back(window_sum(energy_density(m.chain, now), centre, core_reach) / all);
    out.mean.push_back(impulse / now.t);
  };
  const Run run = evolve(EventCorrected{step}, m.chain, state, m.duration, Every{step}, observe);
  if (state.v.front() != 0 || state.v.back() != 0) throw Failure("the ends have moved");
  if (!(run.energy_drift < 1e-8)) throw Failure("the energy drifts");
  return out;
}

/**
Without wells the breather keeps [0.0438](cell:dispersal/motion=breather/t=20/core) of its energy on nine sites up to $t
= 20$ and [0.00163](cell:dispersal/motion=breather/t=200/core) up to $t = 200$; in wells
[0.99998](cell:dispersal/motion=breather_in_wells/t=200/core). The loss comes in steps (panel c): energy leaves only
while a contact at the edge of the nine sites pushes, that is in pulses of compression. They leave slow beads behind,
which meet now and then. After $t = 20$ four more groups of pushes of the contact are seen, near $t = 38$, 66, 101 and
149, each weaker than the one before; in between it transmits nothing. So its mean force falls nearly like $1/t$, from
[0.00929](cell:dispersal/motion=breather/t=100/mean) at $t = 100$ to
[0.00488](cell:dispersal/motion=breather/t=200/mean) at $t = 200$.

![Changes of the energy fraction and of the mean force at t = 60 at each halving of the step.](fig:x41)

Dispersal is no error of the step: the fraction changes by less than $10^{-7}$ of itself between the steps 0.1 and 0.05,
and then at least like $h^5$ down to $10^{-11}$; the mean force changes less regularly.

The displaced bead, the kicked bead and the pair end sooner: at $t = 20$ they keep
[0.0058](cell:dispersal/motion=displaced/t=20/core), [0.0063](cell:dispersal/motion=kicked/t=20/core) and
[0.0063](cell:dispersal/motion=pair/t=20/core). From $t = 20$ on the nine sites never hold more than 4.4 per cent of the
energy at a recorded time, and from one to the next this changes by less than 2 per cent of the energy; a periodic
motion would return to its initial fraction, nearly one, unless its period is longer than the run. */
void report_dispersal(Report& report, const State<double>& breather) {
  Table& table = report.table("dispersal");
  for (const Motion& m : localized(breather, report.quick ? 60 : 200)) {
    const Dispersal coarse = let_go(m, steps_per_unit), fine = let_go(m, 2 * steps_per_unit);
    for (std::size_t i = 0; i < fine.t.size(); ++i)
      table.add({{"motion", m.name},
                 {"t", fine.t[i]},
                 {"core", with_error(coarse.core[i], fine.core[i])},
                 {"mean", with_error(coarse.mean[i], fine.mean[i])}});
  }
}

// How the breather without wells, at t = 60, depends on the step
void report_convergence(Report& report, const Motion& m) {
  Table& table = report.table("convergence");
  Dispersal last = let_go(m, 10);
  for (int steps = 20; steps <= (report.quick ? 40 : 160); steps *= 2) {
    const Dispersal now = let_go(m, steps);
    table.add({{"step", 1. / steps},
               {"core", std::abs(now.core.back() / last.core.back() - 1)},
               {"mean", std::abs(now.mean.back() / last.mean.back() - 1)}});
    last = now;
  }
}

void reproduce(Report& report) {
  const Motion site = breather_in_wells(Centre::site), bond = breather_in_wells(Centre::bond);
  const std::vector<Motion> free = free_motions();
  report_means(report, {free[0], free[1], free[2], bond, site});
  report_dispersal(report, site.start);
  report_convergence(report, localized(site.start, 60).front());
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
beads (an even number, since neighbours start in opposite directions) with `unevenness = 0.3`, or `omega_b = 1.3`.
Another localized state is one more line in `localized`; the program stops if an end of its chain moves.

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
