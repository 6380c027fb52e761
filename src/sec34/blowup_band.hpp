#pragma once
/**
# No blow-up

A blow-up is a displacement that becomes infinite in finite time. Where no energy is negative, as in pendulum wells,
that of the impact bounds the speed of every bead by $v_0$ and its way by $v_0t$: a bead that is thrown off an end
goes away, but no faster than that. A bead that leaves a soft quartic well gains speed without bound. */

#include "lattice/impact/impact.hpp"

namespace lattice {

/// Speed and way of the beads after one impact.
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
