#pragma once
/**
# Where a packet is

A packet passes a contact in a train of pushes, and the strongest one counts as its *arrival*. So a run keeps all maxima
in time of the pushes. From these follow the distance and the speed, and what a run without losses predicts for beams
with friction, by the slow clock that the chapter derives (sec5_experiment.cpp). */

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

/// The strongest push of one contact, and all of them.
struct Arrival {
  double t = 0, period = 0;  ///< period: half the time between the pushes before and after
  bool reached = false;      ///< the push has a period, and is later than those before
  std::vector<Maximum> pushes{};
};

/// What a run has seen. Contact 1, that of the first two beads, has the index 0.
struct Arrivals {
  std::vector<Arrival> contacts{};
  std::vector<Maximum> centres{};  ///< of the chain's energy, as `height`, in sites from one
  double budget = 0;               ///< the largest imbalance, see driven_chain.hpp

  /// Adds the next contact, which is `reached` if its push comes later than those before.
  void add(Arrival next);
};

/// The arrival that belongs to the maxima of a contact's pushes.
Arrival arrival(std::vector<Maximum> pushes);

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

/// What the slow clock predicts for the energy rate nu: each push of a run without losses at the time at which the clock
/// shows it, with the weight (1 - nu theta / 4)^3; the strongest wins.
Arrivals slowed(const Arrivals& undamped, double nu);

}  // namespace lattice
