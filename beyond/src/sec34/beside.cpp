#include "sec34/beside.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <string>

#include "lattice/gsl/random.hpp"

namespace lattice {

constexpr double wave_amplitude = 0.15, wave_time = 300;

Path expose(const ExposedBreather& trial, const Orbit<double>& orbit, double step) {
  const std::size_t length = 160, first = 64, centre = first + orbit.start.y.size() / 2;
  const Chain chain{length, Quartic{trial.well}};
  State<double> state(length);
  for (std::size_t i = 0; i < orbit.start.y.size(); ++i)
    if (std::abs(orbit.start.y[i]) > 1e-30) state.y[first + i] = orbit.start.y[i];
  for (std::size_t k = 0; k < trial.phase.size(); ++k) {
    const std::size_t n = trial.side < 0 ? centre - 6 - k : centre + 5 + k;
    state.y[n] += wave_amplitude * std::cos(trial.phase[k]);
    state.v[n] += wave_amplitude * std::sin(trial.phase[k]);
  }
  Path path;
  evolve(EventCorrected{step}, chain, state, wave_time, path_sampling,
         [&](const State<double>& now) {
           path.add(now.t, energy_density(chain, now));
           path.centre.back() -= double(centre) + 0.5;
         });
  return path;
}

std::vector<ExposedBreather> exposed_breathers(std::size_t count) {
  Random random(phase_seed);
  std::vector<ExposedBreather> list;
  for (std::size_t k = 0; k < count; ++k) {
    std::vector<double> phase(15);
    for (double& x : phase) x = random.uniform(0, 2 * std::numbers::pi);
    for (const auto& [well, omega] : {std::pair{1.0, 1.68}, {0.0, 1.6045}})
      for (int side : {-1, 1}) list.push_back({well, omega, side, phase});
  }
  return list;
}

// Counted are, at both steps, the breathers that moved towards the waves by more than a tenth of a site; the largest
// difference between two steps in any trial must be far below the mean
void add_pull(Quantities& facts, const std::vector<ExposedBreather>& list, double well) {
  std::vector<double> draws(list.size() / 4, 0.0);
  std::array<std::int64_t, 2> towards{};
  double steps = 0;
  for (std::size_t k = 0; k < list.size(); ++k) {
    const ExposedBreather& t = list[k];
    if (t.well != well) continue;
    const double x = t.side * t.moved(t.path), rough = t.side * t.moved(t.coarse);
    draws[k / 4] += x / 2;
    towards[0] += rough > 0.1, towards[1] += x > 0.1;
    steps = std::max(steps, std::abs(x - rough));
  }
  const double n = double(draws.size()),
               mean = std::accumulate(draws.begin(), draws.end(), 0.0) / n;
  double square = 0;
  for (double x : draws) square += (x - mean) * (x - mean);
  const double error = std::sqrt(square / (n - 1) / n);
  const std::string name = well > 0 ? "_hard" : "_linear";
  facts.add("pull" + name, {mean, error}, "site towards the waves");
  facts.add("pull_steps" + name, compare(0.0, steps), "largest difference of two steps");
  const Estimate pulled = compare(towards[0], towards[1]);
  facts.add("pulled" + name, quotient(pulled, exact(2 * n)), "share of the trials");
}

}  // namespace lattice
