#pragma once
/**
# A packet that turns round

In hard wells, $s > 0$, a travelling breather slows down, turns and comes back to the end where it was
launched. We follow its centre, Eq. (24), around the strongest site, because a packet on its way back need not be the
front-most one, and read the turn from the smoothed path (path.hpp). */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "lattice/impact/impact.hpp"
#include "lattice/integrators/refinement.hpp"
#include "lattice/numerics/estimate.hpp"

namespace lattice {

/// What a turning packet does, in this order.
struct Turn {
  Moment stop;     ///< where the velocity vanishes for the first time
  Moment apex;     ///< the furthest point of the way out
  Moment rebound;  ///< the nearest point of the way back
};

/// The turn of a smoothed path; what it does not show stays `nan`.
Turn find_turn(const Path& path);

/// Sampling every 0.2 units of time resolves the internal oscillation, whose period is that of a bead in its well. The
/// smoothing covers several of these periods, still short compared with the hundreds of units that a packet takes to turn.
inline constexpr double path_smoothing = 15, path_sampling = 0.2;

/// The turn of a path smoothed over `width`. Throws std::invalid_argument for fewer than three samples.
Turn turn_of(const Path& path, double width = path_smoothing);

/// A turn with one error from the step, the difference of two runs, and one from the width of the smoothing, by which a
/// reading of the finer run with half the width differs.
struct TurnEstimate {
  /// Of the first stop and of the apex; the return is the rebound.
  Estimate stop_time, stop_site, apex_time, apex_site, return_time, return_site;
};

/// The turn of the finer of two paths, with both errors.
TurnEstimate estimate_turn(const Path& coarse, const Path& fine);

/// Two runs agree (refinement.hpp) if both have an apex and a rebound at the same site and time, or if neither has one. Two
/// without either would agree at any step, so their end states count as well, with a thousandth of their distance.
struct SameTurn {
  std::string name = "turning points and reflections";
  double operator()(const ImpactRun& a, const ImpactRun& b) const {
    const Turn x = turn_of(a.path), y = turn_of(b.path);
    double worst = 0;
    for (auto [p, q] : {std::pair{x.apex, y.apex}, {x.rebound, y.rebound}}) {
      if (p.found() != q.found()) return std::numeric_limits<double>::infinity();
      if (p.found())
        worst = std::max({worst, std::abs(p.time / q.time - 1), std::abs(p.site / q.site - 1)});
    }
    return std::max(worst, 1e-3 * distance(a.end, b.end));
  }
};

}  // namespace lattice
