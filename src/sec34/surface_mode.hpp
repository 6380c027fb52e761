#pragma once
/**
# The first beads after an impact

How they oscillate once the packet has gone: frequencies, amplitudes, and the mean of their displacements at the moments
when the first one turns back towards the end. */

#include <cstddef>
#include <vector>

#include "lattice/impact/impact.hpp"
#include "sec34/packet.hpp"

namespace lattice {

/// A run in which the first beads are watched.
struct WatchedBeads : ImpactRun {
  std::vector<Oscillation> beads{};
  std::vector<double> inner{};  ///< mean displacements where bead 1 turns back
};

/// An impact whose first `beads` are watched after the time `settled`.
WatchedBeads watch_beads(const EventCorrected& method, const Impact& impact, std::size_t beads,
                         double settled);

}  // namespace lattice
