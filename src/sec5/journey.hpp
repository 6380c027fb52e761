#pragma once
/**
# A packet on a lossy chain

An impact sends a packet through a chain that loses energy (bench.hpp), and we follow it contact by contact.
Each contact has its strongest push, at a time that counts as the packet's arrival, and with a period, half
of the time between the pushes before and after. A sensor on a bead sees its velocity, so we keep the largest
one of every bead.

What should we expect? In the DpS limit (dps.hpp) friction of the beams can be removed altogether. With the
energy rate $\nu$ the amplitudes obey $2i\tau_0\dot A_n = \dots - i\tau_0\nu A_n$ in units of $\epsilon$, and
$A_n = e^{-\nu t/2}B_n$ leaves the equation without friction for $B_n$, with its right-hand side times
$e^{-\nu t/4}$, because that is of degree $3/2$. Hence $B_n$ is a field without friction at the time of a
slower clock,
$$s(t) = \int_0^t e^{-\nu t'/4}\,dt' = \frac4\nu\bigl(1-e^{-\nu t/4}\bigr) < \frac4\nu.$$
A packet comes as far as one without losses in the time $s$, so never farther than that one does in four
lifetimes. The law has no free parameter, and holds for whatever else happens in the limit: instabilities,
collisions and modulations, too, take place at the time of the slower clock. */

#include <cstddef>
#include <vector>

#include "sec5/bench.hpp"

namespace lattice {

/// The slower clock s(t) for the energy rate nu; t itself if there is no friction.
double slow_clock(double nu, double t);

/// The time t at which the slow clock shows s; infinity if it never does.
double true_time(double nu, double s);

/// The strongest push of one contact and the largest velocity of the bead before it.
struct Passing {
  double t = 0, force = 0, period = 0, velocity = 0;
  bool reached = false;  ///< there is a strongest push, later than that of the contact before
};

/// What a run has seen: contact 1, that of the first two beads, has the index 0.
struct Journey {
  std::vector<Passing> contacts{};
  double ledger = 0;    ///< see run_bench
  double duration = 0;  ///< of the run
};

/// Strikes the first bead of a bench at rest with `velocity` and follows the packet for `duration`, or until
/// it has passed the contact `last`. Maxima are those of parabolas through three neighbouring steps.
Journey follow_packet(const Bench& bench, double velocity, double duration, std::size_t last,
                      double step);

/**
As in section 3.6 (array_impact.hpp) the way begins at the first contact at the time of the impact, and
between two contacts the packet moves evenly and oscillates with the period that it has at the later one. How
long it takes from one contact to the next depends on the phase in which it meets them; its speed is therefore
a mean over the last five stretches. A packet that reaches no further contact stops at the last one. */
struct Progressed {
  double sites = 0, oscillations = 0;  ///< from the first contact on
  double speed = 0, period = 0;        ///< at the end; the speed is zero if the packet has stopped
};

/// How far the packet has come after the time `t`.
Progressed way_after(const Journey& journey, double t);

/// The same as the slow clock predicts it from a journey without losses.
Progressed predicted_way(const Journey& undamped, double nu, double t);

/// How far a sensor of this resolution sees the packet: the place, between two beads, where the largest
/// velocity falls below `resolution` for the first time, on a logarithmic scale; the last bead if it never
/// does.
double seen_until(const Journey& journey, double resolution);

/// The same as the slow clock predicts it.
double predicted_sight(const Journey& undamped, double nu, double resolution);

}  // namespace lattice
