#pragma once
/**
# Which impacts eject a bead

A bead that passes the maximum of a soft well escapes to infinity. Impacts of a scan are run with two steps; where the
outcomes differ an impact is *disputed*. */

#include <cmath>
#include <cstddef>
#include <vector>

#include "lattice/impact/impact.hpp"

namespace lattice {

/// When a bead is seen to have escaped, at two resolutions, infinite if none is.
struct Trial {
  double velocity, coarse = 0, fine = 0;

  bool escaped() const { return std::isfinite(fine); }
  bool agreed() const { return escaped() == std::isfinite(coarse); }
};

/// The impact, on a chain that nothing crosses within its time.
Trial trial_of(const Impact& impact, double tolerance);

/// From the lowest velocity with an escape to the highest without one, disputed ones left out.
struct EscapeBand {
  double first_escape, last_survivor, latest;  ///< velocities; time of the latest escape
  std::size_t disputed = 0;
};

/// Throws std::runtime_error if all impacts have the same outcome.
EscapeBand band_of(const std::vector<Trial>& trials);

}  // namespace lattice
