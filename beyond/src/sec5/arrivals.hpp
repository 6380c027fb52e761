#pragma once
/**
# Where a packet is

A packet passes a contact in a train of pushes, and the strongest one counts as its *arrival*. A sensor on a bead sees
the velocity instead. So a run keeps all maxima in time of both, and from these follow the distance, the speed and the
range of a sensor; with friction of the beams also what a run without losses predicts, by the slow clock
$$\theta(t) = \int_0^t e^{-\nu t'/4}\,dt' = \frac4\nu\bigl(1-e^{-\nu t/4}\bigr) < \frac4\nu.$$
Proof for the DpS field: with $a_n = e^{-\nu t/2}b_n$ friction drops out of its equation, and the forces, of degree
$\frac32$, keep the factor $e^{-\nu t/4} = d\theta/dt$. So $b_n$ is a field without friction at the time $\theta$. */

#include <cstddef>
#include <vector>

namespace lattice {

/// The slow clock theta(t) for the energy rate nu; t itself if there is no friction.
double slow_clock(double nu, double t);

/// The time t at which the slow clock shows theta; infinity if it never does.
double true_time(double nu, double theta);

/// A maximum in time.
struct Maximum {
  double t = 0, height = 0;
};

/// The maxima of a signal that is sampled in equal steps, from parabolas through three samples.
class Maxima {
 public:
  void add(double t, double x, double step);

  std::vector<Maximum> all{};

 private:
  double left_ = 0, middle_ = 0;
  std::size_t seen_ = 0;
};

/// The strongest push of one contact and the largest velocity of the bead before it, and all maxima of both.
struct Arrival {
  double t = 0, period = 0,
         velocity = 0;   ///< period: half the time between the pushes before and after
  bool reached = false;  ///< the push has a period, and is later than those before
  std::vector<Maximum> pushes{}, speeds{};
};

/// What a run has seen. Contact 1, that of the first two beads, has the index 0.
struct Arrivals {
  std::vector<Arrival> contacts{};
  std::vector<Maximum> centres{};  ///< of the chain's energy, as `height`, in sites from one
  double budget = 0;               ///< the largest imbalance, see driven_chain.hpp

  /// Adds the next contact, which is `reached` if its push comes later than those before.
  void add(Arrival next);
};

/// The arrival that belongs to the maxima of a contact's pushes and of the velocity of the bead before it.
Arrival arrival(std::vector<Maximum> pushes, std::vector<Maximum> speeds);

/**
The way begins at the first contact at the time of the impact. Between two contacts the packet moves evenly and
oscillates with the period that it has at the later one. How long it takes from one contact to the next depends on the
phase in which it meets them, so its speed is a mean over the last five stretches. A packet that reaches no further
contact stops at the last one. */
struct Travelled {
  double sites = 0, oscillations = 0;  ///< from the first contact on
  double speed = 0, period = 0;        ///< at the end; the speed is zero if the packet has stopped
};

/// How far the packet has come after the time `t`.
Travelled travelled_after(const Arrivals& arrivals, double t);

/// The centre of the energy at the time `t`; throws std::out_of_range if the run has ended before.
double centre_after(const Arrivals& arrivals, double t);

/// The place, between two beads, where the largest velocity falls below `resolution` for the first time, on a
/// logarithmic scale; the last bead if it never does.
double seen_until(const Arrivals& arrivals, double resolution);

/// What the slow clock predicts for the energy rate nu: each maximum of a run without losses at the time at which the
/// clock shows it, with the weight (1 - nu theta / 4)^2 for a speed and its power 3/2 for a force; the strongest wins.
Arrivals slowed(const Arrivals& undamped, double nu);

}  // namespace lattice
