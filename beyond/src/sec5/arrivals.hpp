#pragma once
/**
# A packet on a lossy chain

An impact sends a packet through a chain that loses energy (driven_chain.hpp), and we follow it contact by contact.
Each contact has its strongest push, at a time that counts as the packet's arrival, and with a period, half
of the time between the pushes before and after. A sensor on a bead sees its velocity, so we keep the largest
one of every bead.

In the DpS limit friction of the beams only slows down a clock (sec5_experiment.cpp): but for the factor $e^{-\nu t/2}$,
with the energy rate $\nu$, the field is one without friction at the time
$$s(t) = \int_0^t e^{-\nu t'/4}\,dt' = \frac4\nu\bigl(1-e^{-\nu t/4}\bigr) < \frac4\nu.$$ */

#include <cstddef>
#include <vector>

#include "sec5/driven_chain.hpp"

namespace lattice {

/// The slower clock s(t) for the energy rate nu; t itself if there is no friction.
double slow_clock(double nu, double t);

/// The time t at which the slow clock shows s; infinity if it never does.
double true_time(double nu, double s);

/// A maximum in time of a push or of a speed.
struct Maximum {
  double t = 0, height = 0;
};

/// The strongest push of one contact and the largest velocity of the bead before it, and all maxima of both.
struct Arrival {
  double t = 0, force = 0, period = 0, velocity = 0;
  bool reached = false;  ///< there is a strongest push, later than that of the contact before
  std::vector<Maximum> pushes{}, speeds{};
};

/// What a run has seen: contact 1, that of the first two beads, has the index 0.
struct Arrivals {
  std::vector<Arrival> contacts{};
  std::vector<Maximum> centres{};  ///< of the chain's energy, as `height`, in sites from one
  double budget = 0;               ///< the largest imbalance, see driven_chain.hpp
};

/// Strikes the first bead of a driven or damped chain at rest with `velocity` and follows the packet for `duration`, or until
/// it has passed the contact `last`. Maxima are those of parabolas through three neighbouring steps.
Arrivals packet_arrivals(const DrivenChain& driven, double velocity, double duration,
                         std::size_t last, double step);

/**
The way begins at the first contact at the time of the impact, and between two contacts the packet moves evenly
and oscillates with the period that it has at the later one. How long it takes from one contact to the next
depends on the phase in which it meets them; its speed is therefore a mean over the last five stretches. A packet
that reaches no further contact stops at the last one. */
struct Travelled {
  double sites = 0, oscillations = 0;  ///< from the first contact on
  double speed = 0, period = 0;        ///< at the end; the speed is zero if the packet has stopped
};

/// How far the packet has come after the time `t`.
Travelled travelled_after(const Arrivals& arrivals, double t);

/// The centre of the energy at the time `t`.
double centre_after(const Arrivals& arrivals, double t);

/// How far a sensor of this resolution sees the packet: the place, between two beads, where the largest
/// velocity falls below `resolution` for the first time, on a logarithmic scale; the last bead if it never
/// does.
double seen_until(const Arrivals& arrivals, double resolution);

/**
The law takes every maximum of a run without losses to the time at which the slow clock shows it, with
the weight $(1-\nu s/4)^2$ for a speed and its power $\frac32$ for a force, and lets the strongest one win. It has
no free parameter. As maxima are a period apart, the time of the strongest push is that of a parabola through
the logarithms of three of them. */
/// The arrivals at the energy rate nu that the slow clock predicts from those without losses.
Arrivals slowed(const Arrivals& undamped, double nu);

}  // namespace lattice
