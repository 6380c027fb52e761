#pragma once
/**
# The blow-up, and its absence

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
    const Impact impact = on_long_chain({velocity, {.well = Quartic{s}}, until, 2, 1e-9, false});
    for (int k : {0, 1})
      time[k] = strike(method_for(tolerance, largest_step, k), impact).run.escape_time;
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

/**
A blow-up is a displacement that becomes infinite in finite time. Where no energy is negative, as in pendulum wells,
that of the impact bounds the speed of every bead by $v_0$ and its way by $v_0t$: a bead that is thrown off an end
goes away, but no faster than that. A bead that leaves a soft quartic well gains speed without bound. */
struct Confinement {
  Estimate speed;     ///< largest of any bead, over the impact's
  Estimate way;       ///< largest displacement, over v_0 times the time of the run
  Estimate drift;     ///< of the energy, relative
  double lasted;      ///< share of its time after which the run ended
  Estimate furthest;  ///< largest displacement
};

/// An impact followed to its end with two steps.
Confinement confinement(const Impact& impact, const EventCorrected& rough,
                        const EventCorrected& fine);

}  // namespace lattice
