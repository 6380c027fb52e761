#pragma once
/**
# Random searches for periodic motions

We draw starts at random and let Newton's method turn each into a periodic motion, or fail. Far from any orbit the
motions are wild, and to end a step at every contact event costs much for nothing. So the searches take leapfrog steps of
fixed length $h$ instead, with accelerations $a(y)$, and the exact derivative of these steps:
$$y \leftarrow y + \tfrac h2 v,\qquad v \leftarrow v + h\,a(y),\qquad y \leftarrow y + \tfrac h2 v.$$
The orbits of this map are off by a share of $(\omega h)^2/24$, so every motion that was found must survive the exact
flow. The argument of section 2 holds for the map, too: over a period the kicks of each bead add up to zero. */

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "lattice/numerics/estimate.hpp"
#include "lattice/orbits/shooting.hpp"

namespace searches {

using namespace lattice;

/// The equations of shooting.hpp with these steps. Unknowns and equations are measured in units of the fixed number
/// `scale`, so that a search whose orbit shrinks to nothing ends there, at rest.
struct LeapfrogShooting : Shooting<double> {
  double scale = 1;
  int steps = 128;  ///< per period; a multiple of the symmetry's parts

  Evaluation<double> evaluate(const Vector<double>& x, bool with_jacobian = true) const;
  Equations<double> equations() const;
  /// Advances a state and its tangent, if there is one, by `count` steps and shows each to `watch(z)`.
  void advance(State<double>& z, Tangent<double>* tangent, int count,
               const std::function<void(const State<double>&)>& watch) const;
};

/// Searches of one kind: the chain, and the size of the starts.
struct Series {
  std::string name;
  std::size_t sites;
  Ends ends;
  bool wells;
  double least, most;  ///< size of the starts
};

/// All outcomes: a state of rest, with displacements that increase with n up to rounding; a localized motion, whose end
/// beads carry less than a millionth of the energy; one that is not localized; a doubtful case; or no convergence.
enum class End { rest, localized, extended, doubtful, failed };
/// Their names, in the order of the table.
inline constexpr std::array end_names{"rest", "localized", "extended", "doubtful", "failed"};

/// The counts of all searches with 128 and with 256 steps in a period.
struct EndCounts {
  std::array<std::array<double, end_names.size()>, 2> of{};
  double all = 0;

  /// How many ended in one of these ways. The error is the difference between the two steps plus the statistical one:
  /// other seeds would give other counts.
  Estimate sum(const std::vector<End>& ends) const;
};

/// The searches of the seeds 1, 2, ... side by side. Three beads in the middle get random positions, and for even seeds
/// random velocities too; odd seeds begin at rest.
EndCounts search_all(const Series& series, unsigned long seeds);

}  // namespace searches
