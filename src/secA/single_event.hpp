#pragma once
/**
# One contact event

Two beads in hard wells, one with the mass 1, the other with 4, have one contact. At the event both are at the position
0.7, but for the overlap, and only the lighter one moves. */

#include <vector>

#include "lattice/integrators/event_corrected.hpp"

namespace lattice {

/// At the event: the overlap, and the velocity of the lighter bead.
struct Event {
  const char* name;
  double overlap, rate;
};

/// A start before the event, and the exact positions one unit of time later.
struct Passage {
  State<double> start{2};
  std::vector<double> end{};
};

/// Starts between 0.4 and 0.6 before the event, spread evenly.
std::vector<Passage> passages_of(const Event& event, int count);

/// Root mean square over the passages of the largest error of a displacement.
double passage_error(const EventCorrected& method, const std::vector<Passage>& passages);

}  // namespace lattice
