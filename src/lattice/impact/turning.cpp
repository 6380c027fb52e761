#include "lattice/impact/turning.hpp"

#include "lattice/numerics/parabola.hpp"

#include <numbers>
#include <numeric>
#include <stdexcept>

namespace lattice {

// Average the internal oscillation away with a raised cosine as wide as several of its periods
Path smooth(const Path& path, double width) {
  if (path.t.size() < 3) throw std::invalid_argument("a path needs at least three samples");
  const double sample = path.t[1] - path.t[0];
  const auto reach = std::size_t(std::lround(width / 2 / sample));
  std::vector<double> weight(2 * reach + 1);
  for (std::size_t k = 0; k < weight.size(); ++k)
    weight[k] = 1 + std::cos(std::numbers::pi * (double(k) - double(reach)) / double(reach + 1));
  const double sum = std::accumulate(weight.begin(), weight.end(), 0.0);
  Path out;
  for (std::size_t i = reach; i + reach < path.t.size(); ++i) {
    const auto mean = [&](const std::vector<double>& x) {
      return std::inner_product(weight.begin(), weight.end(), x.begin() + std::ptrdiff_t(i - reach),
                                0.0) /
             sum;
    };
    out.t.push_back(path.t[i]);
    out.centre.push_back(mean(path.centre));
    out.energy.push_back(mean(path.energy));
  }
  return out;
}

// Locate an extremum between the samples, by the parabola through three of them
Moment vertex(const Path& path, std::size_t i) {
  if (i == 0 || i + 1 >= path.t.size()) return {path.centre[i], path.t[i]};
  const Parabola through(path.centre[i - 1], path.centre[i], path.centre[i + 1]);
  if (through.bend == 0 || std::abs(through.slope) > std::abs(through.bend))
    return {path.centre[i], path.t[i]};
  return {through.extremum(), path.t[i] + through.vertex() * (path.t[1] - path.t[0])};
}

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

// Two errors for every turning point: from the step, and from the width of the smoothing
TurnEstimate estimate_turn(const Voyage& coarse, const Voyage& fine) {
  const Turn a = coarse.turn(), b = fine.turn(), c = fine.turn(path_smoothing / 2);
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
Patience patience(double velocity, double s, double horizon) {
  const double rate =
      std::max({1.0, std::pow(velocity, 0.2), std::pow(s * velocity * velocity, 0.25)});
  const double crossing = horizon / std::min(0.36 * std::sqrt(velocity / 2), 0.4);
  return {0.8 / rate, 10 * crossing / rate, 4 * crossing / rate};
}

// Strike the chain and follow the packet until its fate is known
Outlook probe(double velocity, double s, double horizon, int halvings) {
  const Patience wait = patience(velocity, s, horizon);
  const Chain chain{std::size_t(horizon) + 20, Quartic{s}};
  Outlook out;
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
    if (now.t > wait.tired && out.apex < 8) out.fate = Fate::stays;
    return out.fate == Fate::undecided;
  };
  // Four steps between two looks resolve the fastest motion; halvings shorten the steps only
  ContactAware stepper{wait.interval / 4};
  stepper.halvings = halvings;
  strike(stepper, {velocity, chain, wait.time, wait.interval, may_move, false}, look);
  return out;
}

}  // namespace lattice
