#include "sec33/kick_threshold.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "lattice/numerics/parallel.hpp"

namespace lattice {

KickedPath decided_path(const RestingBreather& at, double c, const Method& method, double limit) {
  KickedPath path =
      at.after(c, method, limit, [](const KickedPath& so_far, const State<double>&, const auto&) {
        return mobility_of(so_far) == Mobility::undecided;
      });
  if (mobility_of(path) == Mobility::undecided)
    throw std::runtime_error("a kick of " + std::to_string(1e6 * c) +
                             "e-6 neither frees the breather nor leaves it pinned");
  return path;
}

RestingBreather resting_breather(Centre centre, Phase phase, double omega_b, std::size_t sites) {
  const bool site = centre == Centre::site;
  const Fitted found = fit_chain(centre, omega_b, 0, site ? sites | 1 : sites,
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
  // The threshold goes as the root of the barrier, so the barrier's relative error counts half
  const auto pair = [&](auto of) { return compare(of(found[0]), of(found[1])); };
  Prediction out;
  out.share = pair([](const Pinning& p) { return p.share; });
  out.barrier = barrier;
  if (!(found[1].frequency2 > 0)) return out;
  out.frequency = pair([](const Pinning& p) { return std::sqrt(p.frequency2); });
  out.threshold = pair([&](const Pinning& p) { return freeing_kick(barrier.value, p); });
  out.threshold.error += 0.5 * out.threshold.value * std::abs(barrier.error / barrier.value);
  const Estimate cosine = pair([](const Pinning& p) { return std::abs(p.cosine); });
  out.along_mode = {out.threshold.value * cosine.value,
                    out.threshold.error * cosine.value + out.threshold.value * cosine.error};
  return out;
}

FreeingKick freeing_kick_of(const RestingBreather& at, const Prediction& guess,
                            const EventCorrected& method) {
  const double limit = 10 / guess.frequency.value, least = guess.threshold.value;
  const std::array<double, 3> c{1.05 * least, 1.2 * least, 1.4 * least};
  std::array<double, 3> v{};
  FreeingKick out;
  for (std::size_t i = 0; i < 3; ++i) {
    const KickedPath path = decided_path(at, c[i], method, limit);
    if (mobility_of(path) != Mobility::free)
      throw std::runtime_error("a kick above the prediction leaves the breather pinned");
    v[i] = hill_speed(path);
    out.margin = std::min(out.margin, path.drift_margin(c[i], at.energy));
  }
  // The speed at the top vanishes at the threshold: three pairs of kicks extrapolate to it, and the error is by how
  // much they disagree
  const auto from = [&](std::size_t i, std::size_t k) {
    return threshold_from(c[i], v[i], c[k], v[k]);
  };
  out.value = compare(from(0, 2), from(0, 1));
  out.value.error = std::max(out.value.error, compare(from(1, 2), from(0, 1)).error);
  return out;
}

std::vector<FreeingKick> freeing_kicks(const std::vector<RestingBreather>& at,
                                       const std::vector<Prediction>& guess,
                                       const EventCorrected& coarse, const EventCorrected& fine) {
  const std::size_t n = at.size();
  std::vector<FreeingKick> found(2 * n);
  parallel_for("thresholds", 2 * n, [&](std::size_t i) {
    found[i] = freeing_kick_of(at[i % n], guess[i % n], i < n ? fine : coarse);
  });
  for (std::size_t i = 0; i < n; ++i) found[i].value = compare(found[n + i].value, found[i].value);
  found.resize(n);
  return found;
}

void confirm(const RestingBreather& at, const Prediction& guess, const EventCorrected& method,
             FreeingKick& found) {
  std::array<double, 2> margins{};
  parallel_for("bracket", 2, [&](std::size_t i) {
    const double c = (i ? 1.01 : 0.99) * found.value.value;
    const KickedPath path = decided_path(at, c, method, 10 / guess.frequency.value);
    if (mobility_of(path) != (i ? Mobility::free : Mobility::pinned))
      throw std::runtime_error("the threshold is not within one per cent of " +
                               std::to_string(1e6 * found.value.value) + "e-6");
    margins[i] = path.drift_margin(c, at.energy);
  });
  found.margin = std::min({found.margin, margins[0], margins[1]});
}

}  // namespace lattice
