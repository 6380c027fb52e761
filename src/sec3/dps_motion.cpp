#include "sec3/dps_motion.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "lattice/gsl/random.hpp"
#include "lattice/model/sites.hpp"

namespace lattice {

PinnedBreather::PinnedBreather(const Stationary<double>& state)
    : centre(state.centre),
      mu(state.mu),
      u(state.u.begin(), state.u.end()),
      pair(contact_spectrum(state)),
      centre_per_shift(0) {
  // The derivative of the centre along V, which also gives V its sign
  double sum = 0, moment = 0;
  for (std::size_t i = 0; i < u.size(); ++i) {
    const double x = state.u[i], cube = x * x * x;
    const double n = double(site_number(i, u.size())) - (centre == Centre::bond ? 0.5 : 0);
    sum += cube * x;
    moment += 4 * n * cube * pair.V(Eigen::Index(i));
  }
  centre_per_shift = std::abs(moment / sum);
  if (moment < 0) pair.V = -pair.V;
}

double PinnedBreather::pendulum_push() const {
  return pair.rate / (std::numbers::pi * centre_per_shift * (mu - pair.m));
}

double DpsRun::farthest() const {
  double most = 0;
  for (const double x : X) most = std::max(most, std::abs(x));
  return most;
}

// Many runs
int passing(const DpsRuns& runs, double distance) {
  return int(
      std::ranges::count_if(runs, [&](const DpsRun& run) { return run.farthest() > distance; }));
}

double largest_spread(const DpsRuns& runs) {
  double most = 0;
  for (const DpsRun& run : runs)
    most = std::max(most, std::ranges::max(run.participation) / run.participation.front());
  return most;
}

double off_pendulum(const DpsRuns& runs, double threshold) {
  double most = 0;
  for (const DpsRun& run : runs)
    if (run.push < threshold && run.farthest() < 1)
      most = std::max(
          most, std::abs(run.farthest() - std::asin(run.push / threshold) / std::numbers::pi));
  return most;
}

// Noise, real and imaginary parts, site by site; a control loses what it has along V
Field Noise::operator()(const Field& u, std::size_t seed) const {
  Random random(seed);
  Field noise;
  for (const auto& u_n : u) {
    const double re = random.uniform(-1, 1), im = is_complex ? random.uniform(-1, 1) : 0;
    noise.push_back(std::complex(amplitude * re, amplitude * im) * (is_relative ? u_n : 1.0));
  }
  return noise;
}

Field NoiseGroup::perturbed(std::size_t seed) const {
  Field v = noise(breather.u, seed);
  if (start == "control") breather.pair.add(-breather.pair.of(v), v);
  for (std::size_t i = 0; i < v.size(); ++i) v[i] += breather.u[i];
  return v;
}

int NoiseGroup::predicted_by(const Estimate& threshold) const {
  int predicted = 0;
  for (std::size_t i = 0; i < runs.fine.size(); ++i) {
    const double beyond = runs.fine[i].push - threshold.value;
    const bool coarse = runs.coarse[i].farthest() > 1, fine = runs.fine[i].farthest() > 1;
    if (std::abs(beyond) > threshold.error && coarse == fine && fine == (beyond > 0)) ++predicted;
  }
  return predicted;
}

}  // namespace lattice
