#pragma once
/**
# DpS breathers that a push or noise sets in motion

`sec33_dps_stability` follows perturbed DpS breathers and records their displacement $X$: the centre of $|v_n|^4$, in
sites from the place of rest. Here are the noise, what a pendulum would do, and what is counted. */

#include <cstddef>
#include <string>
#include <vector>

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

  explicit PinnedBreather(const Stationary<double>& state);

  /// b_p, the push at which a pendulum passes the site beside its bond.
  double pendulum_push() const;
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
  double farthest() const;
};
using DpsRuns = std::vector<DpsRun>;

/// How many go beyond a distance, and by which factor the number of sites on which they live grows at most.
int passing(const DpsRuns& runs, double distance);
double largest_spread(const DpsRuns& runs);
/// Largest difference of |X| from a pendulum with this threshold, of those that are pushed less and do not move on.
double off_pendulum(const DpsRuns& runs, double threshold);

/// Independent numbers at every site, the real and the imaginary part uniform within `amplitude`.
struct Noise {
  const char* name;
  double amplitude;
  bool is_complex = true;    ///< or real
  bool is_relative = false;  ///< times u_n

  Field operator()(const Field& u, std::size_t seed) const;
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
  Field perturbed(std::size_t seed) const;
  /// How many pass on if and only if their push exceeds the threshold: beyond its error, and at both tolerances.
  int predicted_by(const Estimate& threshold) const;
};

}  // namespace lattice
