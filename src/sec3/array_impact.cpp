#include "sec3/array_impact.hpp"

#include <algorithm>
#include <stdexcept>

namespace lattice {

Pulse pulse_of(const Watched& w, const Scales& s) {
  const auto push = strongest_push(w.t, w.force);
  if (!push) throw std::runtime_error("the packet did not pass the observed site");
  return {push->t * s.tau_c(), push->force * s.unit_force(),
          largest_modulus(w.t, w.v) * s.unit_velocity(), largest_modulus(w.t, w.y) * s.xi(),
          push->period * s.tau_c()};
}

WatchedRun pass(const StruckArray& struck, std::size_t n, double until, double step) {
  const Impact impact = struck.impact({.until = until, .sample = step});
  Watched at;
  const auto watch = [&](const State<double>& now, const auto&) {
    at.t.push_back(now.t);
    at.force.push_back(contact_push(impact.chain, now.y.data(), n));
    at.v.push_back(now.v[n - 1]);
    at.y.push_back(now.y[n - 1]);
  };
  return {strike(EventCorrected{step}, impact, watch), std::move(at)};
}

double mean_speed(const WatchedRun& run, const StruckArray& struck, std::size_t n) {
  return double(n) / pulse_of(run.at, struck.scales).arrival;
}

double duration_above(const WatchedRun& run, const StruckArray& struck, double threshold) {
  const double most = *std::max_element(run.at.force.begin(), run.at.force.end());
  return struck.scales.milliseconds(time_above(run.at.t, run.at.force, threshold * most));
}

// Of each contact keep the strongest push in each interval, so that no short push is missed
std::vector<double> strongest_forces(const StruckArray& struck, double ratio, double end,
                                     std::size_t bins) {
  const Impact impact = struck.impact({.ratio = ratio, .until = end, .sample = 0.1});
  const std::size_t contacts = impact.chain.sites - 1;
  std::vector<double> map(bins * contacts, 0.0);
  strike(EventCorrected{0.1}, impact, [&](const State<double>& now, const auto&) {
    const std::size_t bin = std::min(bins - 1, std::size_t(now.t / impact.time * double(bins)));
    for (std::size_t n = 0; n < contacts; ++n) {
      double& most = map[bin * contacts + n];
      const double push = contact_push(impact.chain, now.y.data(), n + 1);
      most = std::max(most, push * struck.scales.unit_force());
    }
  });
  return map;
}

}  // namespace lattice
