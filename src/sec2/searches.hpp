#pragma once
/**
# Random searches for periodic motions

We draw starts at random and let Newton's method turn each into a periodic motion, or fail. Three beads in the middle get
random positions, and for even seeds random velocities too; odd seeds begin at rest. The chain moves by leapfrog steps
(fixed_leapfrog.hpp), which is not quite the chain itself, so every motion that was found must survive the exact flow. */

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "lattice/numerics/estimate.hpp"
#include "sec2/fixed_leapfrog.hpp"

namespace searches {

using namespace lattice;

/// Searches of one kind: the chain, and the size of the starts.
struct Series {
  std::string name;
  std::size_t sites;
  Ends ends;
  bool wells;
  double least, most;  ///< size of the starts
};

/**
To count the outcomes we need a complete list of them. A search can converge to a state of rest, with displacements that
increase with $n$ up to rounding; to a localized motion, whose end beads carry less than a millionth of the energy; to a
motion that is not localized; or to a doubtful case, which somebody would have to look at. Or it does not converge. */
enum class End { rest, localized, extended, doubtful, failed };
/// Their names, in the order of the table.
inline constexpr std::array end_names{"rest", "localized", "extended", "doubtful", "failed"};

/**
The counts depend on the length of the step and on the sample. Their error is the difference between two steps plus the
statistical error: other seeds would give other counts. */
struct EndCounts {
  std::array<std::array<double, end_names.size()>, 2> of{};
  double all = 0;

  /// How many ended in one of these ways.
  Estimate sum(const std::vector<End>& ends) const;
};

/// The searches of the seeds 1, 2, ... side by side, each with 128 and with 256 steps in a period.
EndCounts search_all(const Series& series, unsigned long seeds);

}  // namespace searches
