#pragma once
/**
# The band of the blow-up

Close to the threshold of section 3.4 impacts that throw a bead out of its soft well lie among others that do not. Each
velocity is followed with two steps up to a stated time, before anything can return from the far end. */

#include <cmath>
#include <vector>

#include "lattice/impact/impact.hpp"

namespace lattice {

/// Whether and when a bead escapes after one impact.
struct Escape {
  double velocity;
  double time[2] = {0, 0};  ///< of the blow-up at two resolutions, infinite if there is none

  void measure(double s, double until, double tolerance) {
    const Impact impact = endless({velocity, {.well = Quartic{s}}, until, 2, 1e-9, false});
    for (int k : {0, 1})
      time[k] = strike(stepper_for(tolerance, largest_step, k), impact).run.escape_time;
  }
  bool gone(int k) const { return std::isfinite(time[k]); }
  bool agreed() const { return gone(0) == gone(1); }
};

/// From the lowest velocity with an escape to the highest without; disputed are the velocities on which two steps disagree.
struct EscapeBand {
  double first_escape, last_survivor, spacing, disputed;
};

/// The band of a scan at equal distances.
EscapeBand band_of(const std::vector<Escape>& trials);

}  // namespace lattice
