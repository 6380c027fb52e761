#pragma once
/**
# A packet that turns round

In hard wells, $s > 0$, a travelling breather slows down, turns and comes back to the end where it was
launched. We follow its centre, Eq. (24), around the strongest site, because a packet on its way back need not be the
front-most one, and read the turn from the smoothed path (path.hpp). */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
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

/**
A packet has turned once it has come back by `back` sites, which is more than it moves to and fro while
it is caught between two sites; the apex is its furthest point. It has rebounded once it then moves out
again by `again` sites. The first stop is sought beyond site `clear`, where the packet has detached
itself from the end. */
/// The turn of a smoothed path; what it does not show stays `nan`.
Turn find_turn(const Path& path, double back = 5, double again = 3, double clear = 8);

/**
The packets of this file are launched by an impact and followed for a long time. Sampling every 0.2 units
of time resolves the internal oscillation, whose period is about four. The smoothing covers four of these
periods, which removes the ripple and is still short compared with the hundreds of units that a packet
takes to turn. */

/// Width of the smoothing, about four internal periods, and time between two looks at the chain.
inline constexpr double path_smoothing = 15, path_sampling = 0.2;

/// An impact on a chain with quartic wells whose strongest packet is followed, Eqs. (9), (10) and (26).
Impact turning_impact(double velocity, double s, double time = 1000, std::size_t sites = 150);

/// The turn of a path smoothed over `width`. Throws std::invalid_argument for fewer than three samples.
Turn turn_of(const Path& path, double width = path_smoothing);

/**
The time of a turn has one error from the step and one from the width of the smoothing, which is our
choice. The first is the difference of two runs; for the second we read the finer run again with half the
width and add what this changes. */
struct TurnEstimate {
  /// Of the first stop and of the apex; the return is the rebound.
  Estimate stop_time, stop_site, apex_time, apex_site, return_time;
};

/// The turn of the finer of two paths, with both errors.
TurnEstimate estimate_turn(const Path& coarse, const Path& fine);

/**
If a tolerance is stated (refinement.hpp), two runs agree if both have an apex and a rebound at the same site
and time, or if neither has one. Two runs without either would agree at any step, so their end states count
as well, but only with a thousandth of their distance, since the question is the turn. */
struct SameTurn {
  std::string name = "apex and rebound";
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

/**
For a map of which impacts turn round and which do not, the smoothed path is not needed: the mean over one
internal period tells whether a packet has passed a given site, the horizon, has come back by five sites,
or has never left the end. */
enum class Fate : std::int64_t { escapes, turns, stays, undecided };

/// A fate, and how far the packet came.
struct Outcome {
  Fate fate = Fate::undecided;
  double apex = 0;  ///< furthest mean centre so far
};

/**
Impacts over many decades of the velocity $v_0$ need clocks of their own. The fastest motion is that of the
well, of the contact or of the quartic term, with rates one, $v_0^{1/5}$ and $(s v_0^2)^{1/4}$; samples and
steps follow it. How long to wait is decided by the slowest packets, those of the DpS limit, which move at
$0.36\,(v_0/2)^{1/2}$ sites per unit of time (dps.hpp), with 0.4 as an upper limit, and reach the horizon in
the time `crossing`. We wait ten times as long, and say of a packet that has not left the end after four
crossings that it stays. After a strong impact everything is faster, so both times are divided by the
largest rate. */
struct Timing {
  double interval;     ///< between two looks
  double time;         ///< of the whole run
  double stays_after;  ///< when a packet near the end counts as one that stays
};

/// The clock for an impact of `velocity` in wells with anharmonicity `s`.
Timing timing_for(double velocity, double s, double horizon);

/**
A map needs thousands of such runs, so each ends as soon as its fate is known. Eight samples make about one
internal period, and only their mean counts. */

/// The fate of a struck packet before site `horizon`, with steps halved `halvings` times.
Outcome outcome_of(double velocity, double s, double horizon, int halvings);

}  // namespace lattice
