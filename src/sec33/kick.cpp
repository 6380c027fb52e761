#include "sec33/kick.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace lattice {

std::vector<double> kick_direction(const std::vector<double>& y) {
  std::vector<double> g(y.size());
  double squares = 0;
  for (std::size_t n = 0; n < y.size(); ++n) {
    g[n] = (n + 1 < y.size() ? y[n + 1] : 0) - (n > 0 ? y[n - 1] : 0);
    squares += g[n] * g[n];
  }
  if (!(squares > 0)) throw std::invalid_argument("a chain at rest has no direction for a kick");
  for (double& x : g) x /= std::sqrt(squares);
  return g;
}

State<double> kicked(State<double> state, double c) {
  const std::vector<double> g = kick_direction(state.y);
  for (std::size_t n = 0; n < g.size(); ++n) state.v[n] += c * g[n];
  return state;
}

double sample_of_mean(double period) {
  return period * (std::sqrt(5.0) - 1) / 10;
}

double breather_place(const std::vector<double>& e) {
  const std::size_t peak = std::size_t(std::max_element(e.begin(), e.end()) - e.begin());
  return energy_centre(e, peak) - 0.5 * double(e.size() + 1);
}

// Distances, speeds and the trust that a run deserves are read off a path
double KickedPath::farthest() const {
  double far = 0;
  for (std::size_t k = 0; k < centre.size(); ++k) far = std::max(far, std::abs(moved(k)));
  return far;
}

double KickedPath::mean_speed(double distance, std::size_t start) const {
  for (std::size_t k = start + 1; k < t.size(); ++k) {
    const double now = std::abs(centre[k] - centre[start]),
                 before = std::abs(centre[k - 1] - centre[start]);
    if (now < distance) continue;
    const double since = t[k - 1] + (t[k] - t[k - 1]) * (distance - before) / (now - before);
    return distance / (since - t[start]);
  }
  throw std::runtime_error("the kicked breather does not travel " + std::to_string(distance) +
                           " sites");
}

Estimate when_at(double distance, const TwoRuns<KickedPath>& paths) {
  return paths.of([&](const KickedPath& p) { return p.t[0] + distance / p.mean_speed(distance); });
}

// `run` gives its drift relative to the breather's energy
double KickedPath::drift_margin(double c, double energy) const {
  return c * c / 2 / energy / run.energy_drift;
}

KickedPath follow_kicked(const Method& method, const Chain& chain, const State<double>& start,
                         double sample, double duration, const KickLook& look) {
  const std::size_t means = std::size_t(duration / (sample * double(samples_of_a_mean)) + 0.5);
  TimeGrid grid{sample * double(samples_of_a_mean * means), samples_of_a_mean * means};
  grid.steps = std::max<std::size_t>(1, std::size_t(std::ceil(sample / method.step * (1 - 1e-12))));
  MeanPlace mean{.sample = sample};
  State<double> end = start;
  const Run run = evolve(method, chain, end, grid, [&](const State<double>& now) {
    if (now.t == start.t) return true;
    const std::vector<double> e = energy_density(chain, now);
    return !mean.add(now, e) || look(mean.path, now, e);
  });
  mean.path.run = run;
  mean.path.end = std::move(end);
  return std::move(mean.path);
}

}  // namespace lattice
