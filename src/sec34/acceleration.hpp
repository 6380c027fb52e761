#pragma once
/**
# The acceleration of a packet

The path of a particle on which a constant force acts is a parabola. We fit one to a part of the smoothed path: its bend
is the mean acceleration, and how far the path is from it shows how constant the force is. */

#include "lattice/impact/turning.hpp"
#include "lattice/numerics/estimate.hpp"

namespace lattice {

/// A part of a path, from sample `first` on and before sample `last`.
struct Stretch {
  std::size_t first = 0, last = 0;
};
/// The samples from time `from` to `to`.
Stretch stretch(const Path& path, double from, double to);

/// The parabola that fits a stretch of a smoothed path best.
struct PathFit {
  double acceleration = 0;  ///< site per squared unit of time
  double deviation = 0;     ///< root mean square of the distance, over the range of the stretch
};
PathFit fit_parabola(const Path& smoothed, Stretch of);

/// The ways of a packet that turns: between two given times on the way out; *between* the ways, while it is above nine
/// tenths of its turning point; and on the way *back*, from there to three tenths.
struct Leg {
  enum class Kind { out, between, back } kind;
  double from = 0, to = 0;  ///< on the way out
};

/// Mean acceleration on a leg; how much it is larger in the second half of the leg than in the first, relative to the mean; and
/// the velocity lost between both ends, as slopes over ten units of time, in a unit of time.
struct Acceleration {
  Estimate mean, change, lost;
};

/// The acceleration on a leg, from the paths of two runs. The errors are what the other step and half the smoothing
/// change.
Acceleration acceleration_of(const Path& coarse, const Path& fine, Leg leg);

}  // namespace lattice
