#pragma once
/**
# The acceleration of a packet

The velocity of a packet is the slope of its smoothed path over ten units of time, its acceleration the slope of a line
that is fitted to these velocities on a leg of the way. */

#include <vector>

#include "lattice/impact/turning.hpp"
#include "lattice/numerics/estimate.hpp"

namespace lattice {

/// Velocities of a packet at some times.
struct Velocities {
  std::vector<double> t, v;
};

/// The velocities on a smoothed path, one in each five units of time, from sample `first` on and before `last`; `look`
/// is the time between two samples.
Velocities velocities(const Path& smoothed, std::size_t first, std::size_t last, double look);

/// On the way out 100 < t < 220, on the way back sites 18 to 6, and what lies between these two.
enum class Leg { back, out, between };

/// The mean acceleration (site per squared unit of time), and the slopes of both halves of the leg: their difference
/// over the whole slope.
struct Acceleration {
  Estimate mean, bend;
};

/// The acceleration on a leg, from the paths of two runs. The error of the mean is that of the fit plus what the other
/// step and half the smoothing change.
Acceleration acceleration_of(const Path& coarse, const Path& fine, Leg leg);

}  // namespace lattice
