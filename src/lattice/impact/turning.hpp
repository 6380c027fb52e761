#pragma once
/**
# A packet that turns round

In hard wells, $s > 0$, a travelling breather slows down, turns and comes back to the end where it was
launched. We follow its centre, Eq. (24), around the strongest site, because a packet on its
way back need not be the front-most one. The centre trembles with the internal oscillation, so that its
velocity vanishes twice per period, and a turning point has a meaning only for a smoothed path: the mean
over a stated width with the weight $1+\cos(2\pi t/\text{width})$. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "lattice/impact/impact.hpp"
#include "lattice/integrators/accuracy.hpp"
#include "lattice/numerics/estimate.hpp"

namespace lattice {

/// Centre and energy of the strongest packet at equally spaced times.
struct Path {
  std::vector<double> t, centre, energy;  ///< centres in sites, from one

  /// Appends the packet around the strongest site of the density `e`.
  void add(double time, const std::vector<double>& e) {
    add(time, e, std::size_t(std::max_element(e.begin(), e.end()) - e.begin()));
  }
  /// The same where the strongest site is known.
  void add(double time, const std::vector<double>& e, std::size_t peak) {
    t.push_back(time);
    centre.push_back(energy_centre(e, peak));
    energy.push_back(window_sum(e, peak));
  }
};

/**
This weight and its slope fall to zero at the ends of the window, so that an oscillation with more than a
few periods per window is strongly suppressed; a plain mean does so only if the window happens to hold
whole periods. At the ends of a path, where no window fits, the smoothed path has no values: half a
window would shift the centre of a moving packet. */

/// The weighted mean of a path over windows of the given width in time, shorter by one width.
/// Throws std::invalid_argument for fewer than three samples.
Path smooth(const Path& path, double width);

/**
A turning point is an extremum of the smoothed path. The parabola through three samples places it between
them, so that its time is not limited by the sampling. If the three do not enclose an extremum, the sample
itself is taken. */

/// A site and a time, `nan` where there are none.
struct Moment {
  double site = std::numeric_limits<double>::quiet_NaN(),
         time = std::numeric_limits<double>::quiet_NaN();
  /// Whether there is one.
  bool found() const { return !std::isnan(time); }
};

/// The extremum of the parabola through sample `i` and its neighbours.
Moment vertex(const Path& path, std::size_t i);

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

/// An impact on the first bead of a resting chain with quartic wells, Eqs. (9), (10) and (26).
struct Strike {
  double velocity = 1.9, s = 1, time = 1000;
  std::size_t sites = 150;
};

/// Width of the smoothing, about four internal periods, and time between two looks at the chain.
inline constexpr double path_smoothing = 15, path_sampling = 0.2;

/// One struck chain, followed (impact.hpp).
struct Voyage {
  Path path;  ///< as sampled, not smoothed
  State<double> end;
  Run run;
  /// The turn of the path smoothed over `width`. Throws std::invalid_argument for fewer than three samples.
  Turn turn(double width = path_smoothing) const { return find_turn(smooth(path, width)); }
};

/**
A run keeps the path of the packet and the chain as it is at the end; whatever else is needed, such as a
map of densities, `watch` collects. */

/// Follows the strongest packet after an impact on any `chain`; `watch(state, density)` sees every sample.
template <class Watch = Unwatched>
Voyage voyage(const ContactAware& stepper, const Chain& chain, double velocity, double time,
              Watch watch = {}) {
  Path path;
  const Impact impact{velocity, chain, time, path_sampling, 1e-9, false};
  ImpactRun run = strike(stepper, impact, [&](const State<double>& now, const auto& density) {
    path.add(now.t, density);
    watch(now, density);
  });
  return {std::move(path), std::move(run.end), run.run};
}

/// The same in quartic wells.
template <class Watch = Unwatched>
Voyage voyage(const ContactAware& stepper, const Strike& strike, Watch watch = {}) {
  const Chain chain{strike.sites, Quartic{strike.s}};
  return voyage(stepper, chain, strike.velocity, strike.time, watch);
}

/**
The time of a turn has one error from the step and one from the width of the smoothing, which is our
choice. The first is the difference of two runs; for the second we read the finer run again with half the
width and add what this changes. */
struct TurnEstimate {
  /// Of the first stop and of the apex; the return is the rebound.
  Estimate stop_time, stop_site, apex_time, apex_site, return_time;
};

/// The turn of the finer of two runs, with both errors.
TurnEstimate estimate_turn(const Voyage& coarse, const Voyage& fine);

/**
If a tolerance is stated (accuracy.hpp), two runs agree if both have an apex and a rebound at the same site
and time, or if neither has one. Two runs without either would agree at any step, so their end states count
as well, but only with a thousandth of their distance, since the question is the turn. */
struct SameTurn {
  std::string name = "apex and rebound";
  double operator()(const Voyage& a, const Voyage& b) const {
    const Turn x = a.turn(), y = b.turn();
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
struct Outlook {
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
struct Patience {
  double interval;  ///< between two looks
  double time;      ///< of the whole run
  double tired;     ///< when a packet near the end counts as one that stays
};

/// The clock for an impact of `velocity` in wells with anharmonicity `s`.
Patience patience(double velocity, double s, double horizon);

/**
A map needs thousands of such runs, so each ends as soon as its fate is known. Eight samples make about one
internal period, and only their mean counts. */

/// The fate of a struck packet before site `horizon`, with steps halved `halvings` times.
Outlook probe(double velocity, double s, double horizon, int halvings);

}  // namespace lattice
