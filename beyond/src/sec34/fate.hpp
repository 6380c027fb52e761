#pragma once
/**
# The fate of a struck packet

For a map of which impacts turn round and which do not, the smoothed path is not needed: the mean over one
internal period tells whether a packet has passed a given site, the horizon, has come back by five sites,
or has never left the end. */

#include <cstdint>

namespace lattice {

/// What becomes of a packet.
enum class Fate : std::int64_t { escapes, turns, stays, undecided };

/// A fate, and how far the packet came.
struct Outcome {
  Fate fate = Fate::undecided;
  double apex = 0;  ///< furthest mean centre so far
};

/// The fate of a struck packet before site `horizon`, with steps halved `halvings` times. A map needs thousands of
/// such runs, so each ends as soon as its fate is known.
Outcome outcome_of(double velocity, double s, double horizon, int halvings);

}  // namespace lattice
