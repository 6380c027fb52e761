#pragma once
/**
# The acceleration of a packet

The velocity of a packet is the slope of its smoothed path over ten units of time. A line that is fitted to it
gives the mean acceleration of the centre on a leg of the way, and `bend`, the difference between the slopes of
the two halves of the leg relative to the whole slope, says how constant it is. */

#include <vector>

#include "lattice/impact/turning.hpp"
#include "lattice/numerics/estimate.hpp"

namespace lattice {

/// The mean acceleration on a leg of the way, and how much it changes there, both with errors.
struct Acceleration {
  Estimate mean, bend;  ///< site per squared unit of time; relative
};

/**
On the way out the packet is watched from $t = 100$, when it has left the end behind, to $t = 220$; on the way
back between sites 18 and 6; and the third leg is what lies between these two. */
enum class Leg { back, out, between };

/// Velocities of a packet at some times.
struct Velocities {
  std::vector<double> t, v;
};

/// The velocities on a smoothed path, one in each five units of time, from sample `first` on and before `last`; `look`
/// is the time between two samples.
Velocities velocities(const Path& smoothed, std::size_t first, std::size_t last, double look);

/// The acceleration on a leg, from the paths of two runs. Its error is that of the fit plus what the other step and half the
/// smoothing change.
Acceleration acceleration_of(const Path& coarse, const Path& fine, Leg leg);

/**
Neighbours in a list of accelerations may be closer than their errors. The list does not fall in modulus if no later one is
smaller than an earlier one beyond the errors of both. */
/// The largest fall of the modulus from one to a later one, less the errors of both.
double largest_fall(const std::vector<Estimate>& list);

}  // namespace lattice
