#include "sec33/kick_threshold.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace lattice {

RestingBreather resting_breather(Centre centre, Phase phase, double omega_b, std::size_t sites) {
  const Fitted found =
      fit_chain(centre, omega_b, Quartic{0}, centre == Centre::site ? sites | 1 : sites,
                sites_of(centre, Length::spare), 1e-16, phase);
  return {centre, Chain{found.problem.chain.sites}, found.orbit.start, found.problem.period(),
          found.orbit.energy};
}

EventCorrected fourteen_stages(double step) {
  return {step, nystrom(blanes_moan_6_14())};
}

BreatherPair barriers_at(double omega_b) {
  BreatherPair pair{0, omega_b};
  for (int k : {0, 1}) pair.orbit[k] = find_breather(problem_of(both_centres[k], omega_b));
  measure_in<double>(pair);
  return pair;
}

Prediction predict_threshold(const RestingBreather& at, const Estimate& barrier) {
  std::array<Pinning, 2> found;
  for (std::size_t i = 0; i < 2; ++i) {
    EventTolerance<double> rule;
    if (i == 0) rule.tolerance *= 16;
    found[i] = pinning_of(at.chain, at.centre, at.rest, at.period, rule);
  }
  const auto pair = [&](auto of) { return compare(of(found[0]), of(found[1])); };
  Prediction out;
  out.share = pair([](const Pinning& p) { return p.share; });
  out.barrier = barrier;
  if (!(found[1].frequency2 > 0)) return out;
  out.frequency = pair([](const Pinning& p) { return std::sqrt(p.frequency2); });
  // The threshold goes as the root of the barrier, so the barrier's relative error counts half
  out.threshold = pair([&](const Pinning& p) { return freeing_kick(barrier.value, p); });
  out.threshold.error += 0.5 * out.threshold.value * std::abs(barrier.error / barrier.value);
  const Estimate cosine = pair([](const Pinning& p) { return std::abs(p.cosine); });
  out.along_mode = {out.threshold.value * cosine.value,
                    out.threshold.error * cosine.value + out.threshold.value * cosine.error};
  return out;
}

KickedPath decided_path(const RestingBreather& at, double c, const Method& method, double limit) {
  KickedPath path = at.after(c, method, limit, [](const KickedPath& so_far, auto&...) {
    return mobility_of(so_far) == Mobility::undecided;
  });
  if (mobility_of(path) != Mobility::undecided) return path;
  throw std::runtime_error("a kick neither frees the breather nor leaves it pinned");
}

Estimate freeing_kick_of(const RestingBreather& at, const Prediction& guess,
                         const EventCorrected& method) {
  std::array<double, 3> c{1.05, 1.2, 1.4}, v{};
  for (std::size_t i = 0; i < 3; ++i) {
    c[i] *= guess.threshold.value;
    const KickedPath path = decided_path(at, c[i], method, 10 / guess.frequency.value);
    if (mobility_of(path) != Mobility::free)
      throw std::runtime_error("a kick above the prediction leaves the breather pinned");
    v[i] = hill_speed(path);
  }
  const auto from = [&](std::size_t i, std::size_t k) {
    return threshold_from(c[i], v[i], c[k], v[k]);
  };
  const Estimate one = compare(from(0, 2), from(0, 1)), two = compare(from(1, 2), from(0, 1));
  return {one.value, std::max(one.error, two.error)};
}

}  // namespace lattice
