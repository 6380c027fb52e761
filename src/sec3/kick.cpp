#include "sec3/kick.hpp"

#include <cmath>
#include <stdexcept>

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

State<double> kicked(State<double> state, double c, const std::vector<double>& g) {
  for (std::size_t n = 0; n < g.size(); ++n) state.v[n] += c * g[n];
  return state;
}
State<double> kicked(const State<double>& state, double c) {
  return kicked(state, c, kick_direction(state.y));
}

double sample_of_mean(double period) {
  return period * (std::sqrt(5.0) - 1) / 10;
}

static std::size_t strongest(const std::vector<double>& e) {
  return std::size_t(std::max_element(e.begin(), e.end()) - e.begin());
}
double breather_place(const std::vector<double>& e) {
  return energy_centre(e, strongest(e)) - 0.5 * double(e.size() + 1);
}

// What is read off a path
double KickedPath::farthest() const {
  double far = 0;
  for (std::size_t k = 0; k < size(); ++k) far = std::max(far, std::abs(moved(k)));
  return far;
}

double KickedPath::mean_speed(double distance, std::size_t start) const {
  for (std::size_t k = start + 1; k < size(); ++k) {
    const auto &first = samples[start], &last = samples[k - 1], &here = samples[k];
    const double now = std::abs(here.centre - first.centre),
                 before = std::abs(last.centre - first.centre);
    if (now < distance) continue;
    const double since = last.t + (here.t - last.t) * (distance - before) / (now - before);
    return distance / (since - first.t);
  }
  throw std::runtime_error("the kicked breather does not travel that far");
}

double KickedPath::speed_at(double distance) const {
  const double since = (distance - 0.1) / mean_speed(distance - 0.1);
  return 0.2 / ((distance + 0.1) / mean_speed(distance + 0.1) - since);
}

// `run` gives its drift relative to the breather's energy
double KickedPath::drift_margin(double c, double energy) const {
  return c * c / 2 / energy / run.energy_drift;
}

Mobility mobility_of(const KickedPath& path) {
  const double far = path.farthest();
  if (far > free_beyond) return Mobility::free;
  return std::abs(path.travelled()) < far - turned_back ? Mobility::pinned : Mobility::undecided;
}

KickedPath follow_kicked(const Method& method, const Chain& chain, const State<double>& start,
                         double sample, double duration, const KickLook& look) {
  constexpr auto many = double(samples_of_a_mean);
  KickedPath path;
  State<double> now = start;
  double sum = 0;
  std::size_t samples = 0;
  const auto see = [&](const State<double>& state) {
    if (state.t == start.t) return true;
    const std::vector<double> e = energy_density(chain, state);
    sum += breather_place(e);
    path.share = std::min(path.share, window_sum(e, strongest(e)) / window_sum(e, 0, e.size()));
    if (++samples % samples_of_a_mean != 0) return true;
    path.add(state.t - sample * 0.5 * double(samples_of_a_mean - 1), sum / many);
    sum = 0;
    return look(path, state, e);
  };
  const double means = std::round(duration / (sample * many));
  path.run = evolve(method, chain, now, sample * (many * means), Every{sample}, see);
  path.energy = energy(chain, now);
  return path;
}

}  // namespace lattice
