#include "lattice/impact/turning.hpp"

#include "lattice/integrators/event_corrected.hpp"

namespace lattice {

// Follow the packet to its first stop, out to the apex, and back to where it rebounds
Turn find_turn(const Path& path, double back, double again, double clear) {
  Turn turn;
  std::size_t far = 0, near = 0;
  bool turned = false;
  const std::vector<double>& x = path.centre;
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (!turn.stop.found() && x[i - 1] > clear && x[i] < x[i - 1]) turn.stop = vertex(path, i - 1);
    // On the way out it is caught and released, so only a retreat by `back` sites makes an apex
    if (!turned) {
      if (x[i] > x[far]) far = i;
      turned = x[i] < x[far] - back;
      near = i;
      if (turned) turn.apex = vertex(path, far);
    } else if (x[i] < x[near]) {
      near = i;
    } else if (x[i] > x[near] + again) {
      turn.rebound = vertex(path, near);
      break;
    }
  }
  return turn;
}

Impact turning_impact(double velocity, double s, double time, std::size_t sites) {
  return {.velocity = velocity,
          .chain = {sites, Quartic{s}},
          .time = time,
          .every = path_sampling,
          .denser = false,
          .packet = WhichPacket::strongest};
}

Turn turn_of(const Path& path, double width) {
  return find_turn(smooth(path, width));
}

// Two errors for every turning point: from the step, and from the width of the smoothing
TurnEstimate estimate_turn(const Path& coarse, const Path& fine) {
  const Turn a = turn_of(coarse), b = turn_of(fine), c = turn_of(fine, path_smoothing / 2);
  const auto both = [&](auto of) {
    Estimate e = compare(of(a), of(b));
    e.error += std::abs(of(c) - of(b));
    return e;
  };
  return {both([](const Turn& t) { return t.stop.time; }),
          both([](const Turn& t) { return t.stop.site; }),
          both([](const Turn& t) { return t.apex.time; }),
          both([](const Turn& t) { return t.apex.site; }),
          both([](const Turn& t) { return t.rebound.time; })};
}

// How often to look and how long to wait, from the fastest rate and from the slowest packet
Timing timing_for(double velocity, double s, double horizon) {
  const double rate =
      std::max({1.0, std::pow(velocity, 0.2), std::pow(s * velocity * velocity, 0.25)});
  const double crossing = horizon / std::min(0.36 * std::sqrt(velocity / 2), 0.4);
  return {0.8 / rate, 10 * crossing / rate, 4 * crossing / rate};
}

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
