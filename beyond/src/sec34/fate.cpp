#include "sec34/fate.hpp"

#include <algorithm>
#include <cmath>

#include "lattice/impact/impact.hpp"
#include "lattice/integrators/event_corrected.hpp"

namespace lattice {
namespace {

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

// How often to look and how long to wait, from the fastest rate and from the slowest packet
Timing timing_for(double velocity, double s, double horizon) {
  const double rate =
      std::max({1.0, std::pow(velocity, 0.2), std::pow(s * velocity * velocity, 0.25)});
  const double crossing = horizon / std::min(0.36 * std::sqrt(velocity / 2), 0.4);
  return {0.8 / rate, 10 * crossing / rate, 4 * crossing / rate};
}

}  // namespace

// Strike the chain and follow the packet until its fate is known
Outcome outcome_of(double velocity, double s, double horizon, int halvings) {
  const Timing timing = timing_for(velocity, s, horizon);
  const Chain chain{std::size_t(horizon) + 20, Quartic{s}};
  Outcome out;
  Path period;
  // The mean over one internal period decides: past the horizon, on the way back, or never away
  const auto look = [&](const State<double>& now, const std::vector<double>& density) {
    period.add(now.t, density);
    if (period.t.size() < 8) return true;
    double x = 0;
    for (double c : period.centre) x += c / 8;
    period = {};
    out.apex = std::max(out.apex, x);
    if (x > horizon) out.fate = Fate::escapes;
    if (x < out.apex - 5) out.fate = Fate::turns;
    if (now.t > timing.stays_after && out.apex < 8) out.fate = Fate::stays;
    return out.fate == Fate::undecided;
  };
  // Four steps between two looks resolve the fastest motion; halvings shorten the steps only
  EventCorrected method{timing.interval / 4};
  method.halvings = halvings;
  strike(method, {velocity, chain, timing.time, timing.interval, may_move, false}, look);
  return out;
}

}  // namespace lattice
