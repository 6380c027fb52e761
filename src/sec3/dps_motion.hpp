#pragma once
/**
# DpS breathers that a push or noise sets in motion

`sec33_dps_stability` follows perturbed DpS breathers and records their displacement $X$: the centre of $|v_n|^4$, in
sites from the place of rest. Here are the noise, what a pendulum would do, and what is counted. */

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <string>
#include <vector>

#include "lattice/gsl/random.hpp"
#include "lattice/model/sites.hpp"
#include "lattice/numerics/estimate.hpp"
#include "lattice/standing/spectrum.hpp"

namespace lattice {

/// A breather with its translational mode, of the sign for which a shift a > 0 goes to larger n.
struct PinnedBreather {
  Centre centre;
  double mu;                ///< its frequency
  Field u;                  ///< its profile, real
  PinningMode pair;         ///< with that sign
  double centre_per_shift;  ///< g: how far the centre moves, in sites, for a unit of a

  explicit PinnedBreather(const Stationary<double>& state)
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

  /// b_p, the push at which a pendulum passes the site beside its bond.
  double pendulum_push() const {
    return pair.rate / (std::numbers::pi * centre_per_shift * (mu - pair.m));
  }
};

/// Tolerance of the integrator, and samples per unit of time.
struct Accuracy {
  double tolerance, samples;
};

/// What a run is seen to do, sample by sample.
struct DpsRun {
  double push = 0;                      ///< |b| at the start
  std::vector<double> X{};              ///< displacement
  std::vector<double> participation{};  ///< on how many sites the breather lives
  double drift = 0;                     ///< of norm or energy, whichever is larger

  /// The largest |X|.
  double farthest() const {
    double most = 0;
    for (const double x : X) most = std::max(most, std::abs(x));
    return most;
  }
};
using DpsRuns = std::vector<DpsRun>;

/// How many go beyond a distance.
inline int passing(const DpsRuns& runs, double distance) {
  return int(
      std::ranges::count_if(runs, [&](const DpsRun& run) { return run.farthest() > distance; }));
}

/// By which factor the number of sites on which they live grows at most.
inline double largest_spread(const DpsRuns& runs) {
  double most = 0;
  for (const DpsRun& run : runs)
    most = std::max(most, std::ranges::max(run.participation) / run.participation.front());
  return most;
}

/// Largest difference of |X| from a pendulum with this threshold, of those that are pushed less and do not move on.
inline double off_pendulum(const DpsRuns& runs, double threshold) {
  double most = 0;
  for (const DpsRun& run : runs)
    if (run.push < threshold && run.farthest() < 1)
      most = std::max(
          most, std::abs(run.farthest() - std::asin(run.push / threshold) / std::numbers::pi));
  return most;
}

/// Independent numbers at every site, the real and the imaginary part uniform within `amplitude`.
struct Noise {
  const char* name;
  double amplitude;
  bool is_complex = true;    ///< or real
  bool is_relative = false;  ///< times u_n

  Field operator()(const Field& u, std::size_t seed) const {
    Random random(seed);
    Field noise;
    for (const auto& u_n : u) {
      const double re = random.uniform(-1, 1), im = is_complex ? random.uniform(-1, 1) : 0;
      noise.push_back(std::complex(amplitude * re, amplitude * im) * (is_relative ? u_n : 1.0));
    }
    return noise;
  }
};

/// Breathers that start alike, under the same kind of noise.
struct NoiseGroup {
  Noise noise;
  std::string start;  ///< site, bond, or control: without a component along the translational mode
  const PinnedBreather& breather;
  double time;              ///< of the runs
  std::size_t seeds = 16;   ///< 1, 2 and so on
  TwoRuns<DpsRuns> runs{};  ///< at two tolerances

  /// The breather under the noise of this seed.
  Field perturbed(std::size_t seed) const {
    Field v = noise(breather.u, seed);
    if (start == "control") breather.pair.add(-breather.pair.of(v), v);
    for (std::size_t i = 0; i < v.size(); ++i) v[i] += breather.u[i];
    return v;
  }
  /// How many pass on if and only if their push exceeds the threshold: beyond its error, and at both tolerances.
  int predicted_by(const Estimate& threshold) const {
    int predicted = 0;
    for (std::size_t i = 0; i < runs.fine.size(); ++i) {
      const double beyond = runs.fine[i].push - threshold.value;
      const bool coarse = runs.coarse[i].farthest() > 1, fine = runs.fine[i].farthest() > 1;
      if (std::abs(beyond) > threshold.error && coarse == fine && fine == (beyond > 0)) ++predicted;
    }
    return predicted;
  }
};

}  // namespace lattice
