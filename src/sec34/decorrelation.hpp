#pragma once
/**
# How long two runs stay together

The motion of a chain whose contacts open and close is in general chaotic: two runs that differ by a
rounding, by the step or by the last digit of the initial state will part sooner or later. Until then a
trajectory is a fact about the chain; afterwards it is one possibility among many, and only statements
about ensembles make sense. We say that two states have parted when they differ by a tenth of the largest
displacement or velocity. */

#include <cstddef>
#include <limits>
#include <optional>

#include "lattice/impact/impact.hpp"
#include "lattice/integrators/refinement.hpp"
#include "lattice/numerics/estimate.hpp"
#include "lattice/numerics/progress.hpp"

namespace lattice {

inline constexpr double parting_distance = 0.1;   ///< relative difference of the states
inline constexpr double comparison_interval = 2;  ///< units of time between two comparisons

/**
The two runs go on side by side from look to look, so that no more is kept than the two states. */
/// The time at which the states `a`, advanced by the method `first`, and `b`, advanced by `second`, are
/// first seen to have parted; infinite if they have not by `time`. Both belong to `chain`.
inline double decorrelation_time(const Method& first, State<double> a, const Method& second,
                                 State<double> b, const Chain& chain, double time) {
  const TimeGrid one = time_grid(first, time, comparison_interval),
                 other = time_grid(second, time, comparison_interval);
  Window of_a = waking(chain, a), of_b = waking(chain, b);
  const Advance advance_a = first.on(chain), advance_b = second.on(chain);
  const double start = a.t;
  Progress progress("two runs", 1);
  for (std::size_t k = 0;; ++k) {
    a.t = b.t = start + one.interval() * double(k);
    if (!bounded(a) || !bounded(b) || distance(a, b) > parting_distance) return a.t;
    progress.reach(double(k) / double(one.samples));
    if (k == one.samples) return std::numeric_limits<double>::infinity();
    advance_a(a, of_a, one.step(), one.steps);
    advance_b(b, of_b, other.step(), other.steps);
  }
}

/// The same for two chains that are struck with the velocities `one` and `other`.
inline double decorrelation_of_impacts(const EventCorrected& first, double one,
                                       const EventCorrected& second, double other,
                                       const Chain& chain, double time) {
  return decorrelation_time(first, struck(chain.sites, one), second, struck(chain.sites, other),
                            chain, time);
}

/**
This time is a number like any other: it depends on the steps of the two runs, and has an error. */
/// The decorrelation time, from two pairs of runs with different steps. A parting is noticed up to
/// `comparison_interval` late, which is added to the error; `nan` if there was none.
Estimate decorrelation_of(double coarse, double fine);

/**
Steps that are too long part the runs as well, and two agreeing pairs of runs may both be wrong. So the two impacts are
also run with different steps, one of which is half the other: where this lets them part at another time, what
parts them is the step. */
/// The decorrelation time of two impacts whose velocities differ by a fraction `delta`, infinite if they do not part by
/// `time`. The steps are those of `largest`, or are halved until equal steps, half of them, and both beside each other
/// part the impacts within one `comparison_interval`; nothing if none is short enough.
std::optional<Estimate> decorrelation_to(const EventCorrected& largest, double velocity,
                                         double delta, const Chain& chain, double time);

}  // namespace lattice
