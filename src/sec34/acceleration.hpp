#pragma once
/**
# How a packet moves

Speeds, returns and accelerations are read from the smoothed path of its centre. The path of a particle on which a
constant force acts is a parabola. We fit one to a part of the smoothed path: its second derivative is the mean
acceleration, and its distance from the path shows how constant the force is. */

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

/// How far a smoothed path is from a parabola (`PathFit`) until the first reflection, arc 1, or from there to the
/// second one, arc 2.
double deviation_of_arc(const Path& smoothed, int arc);

/// Mean speed between two times, from two runs; half the smoothing shows what the smoothing does.
Estimate mean_speed(const Path& coarse, const Path& fine, double from, double to);
/// Mean speed in a quarter of the whole time, 1 to 4.
double speed_in_quarter(const Path& smoothed, std::size_t quarter);
/// Speed over the last `duration`.
double last_speed(const Path& smoothed, double duration);
/// The most that the centre has ever fallen back from the farthest site reached before, in sites.
double farthest_return(const Path& smoothed);

/// A part of the way of a packet: between two times; *at the turn*, while it is above nine tenths of its turning
/// point; and on the way *back*, from there to three tenths.
struct WayPart {
  const char* name;
  enum class Kind { times, turn, back } kind;
  double from = 0, to = 0;  ///< of `times`
};

/// Mean acceleration on a part of the way, and the velocity lost between its ends, as slopes over ten units of time, in
/// a unit of time.
struct Acceleration {
  Estimate mean, mean_change;
};

/// From the paths of two runs. The errors are what the other step and half the smoothing change.
Acceleration acceleration_of(const Path& coarse, const Path& fine, WayPart part);

}  // namespace lattice
