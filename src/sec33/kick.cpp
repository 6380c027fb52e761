#include "sec33/kick.hpp"

#include <stdexcept>
#include <string>

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

double creep_sample(double period) {
  return period * (std::sqrt(5.0) - 1) / 10;
}

double breather_place(const std::vector<double>& e) {
  const std::size_t peak = std::size_t(std::max_element(e.begin(), e.end()) - e.begin());
  return energy_centre(e, peak) - 0.5 * double(e.size() + 1);
}

// Distances, speeds and the trust that a run deserves are read off a path
double Creep::farthest() const {
  double far = 0;
  for (std::size_t k = 0; k < X.size(); ++k) far = std::max(far, std::abs(moved(k)));
  return far;
}

Estimate Creep::speed(double from, double to) const {
  std::vector<double> ts, xs;
  for (std::size_t k = 0; k < t.size(); ++k)
    if (t[k] >= from && t[k] <= to) ts.push_back(t[k]), xs.push_back(X[k]);
  return fit_line(ts, xs).estimate();
}

double Creep::mean_speed(double distance, std::size_t start) const {
  for (std::size_t k = start + 1; k < t.size(); ++k) {
    const double now = std::abs(X[k] - X[start]), before = std::abs(X[k - 1] - X[start]);
    if (now < distance) continue;
    const double since = t[k - 1] + (t[k] - t[k - 1]) * (distance - before) / (now - before);
    return distance / (since - t[start]);
  }
  throw std::runtime_error("the kicked breather does not travel " + std::to_string(distance) +
                           " sites");
}

// `run` gives its drift relative to the breather's energy
double Creep::drift_margin(double c, double energy) const {
  return c * c / 2 / energy / run.energy_drift;
}

}  // namespace lattice
