#pragma once
/**
# DpS breathers under noise

`sec33_dps_stability` follows breathers under noise, seed by seed. Here are the noise, definitions of it that the
article's words admit beside the main one, and what is counted. */

#include <cstddef>
#include <vector>

#include "report/table.hpp"
#include "sec33/dps_motion.hpp"

namespace lattice {

/// Independent numbers at every site, the real and the imaginary part uniform within `amplitude`.
struct Noise {
  double amplitude;
  bool is_complex = true;    ///< or real
  bool is_relative = false;  ///< times u_n

  Field operator()(const Field& u, std::size_t seed) const;
};

/// The fraction of a thousand draws of this noise whose push on the breather is larger than `threshold`.
double fraction_beyond(double threshold, const Noise& noise, const PinnedBreather& breather);

/// Breathers that start alike, under the same kind of noise.
struct NoiseGroup {
  const char *noise,
      *start;  ///< as tables name them: complex, narrow, real or relative; site, bond or control
  const PinnedBreather& breather;
  Noise of;
  std::size_t seeds;
  double time, counted_by;  ///< of the runs, and by when a departure counts
  bool without_mode =
      false;  ///< a control, whose noise has no component along the translational mode
  NoiseTrials trials{};

  /// The breather under the noise of this seed; writes shift and push to the trial.
  Field perturbed(NoiseTrial& trial) const;
};

/// Sixteen seeds each of two more definitions, until t = 750: real noise, since the profile is real, and noise
/// proportional to the breather.
std::vector<NoiseGroup> real_and_relative_noise(const PinnedBreather& site,
                                                const PinnedBreather& bond, double amplitude);

/// The rows of tables: run by run, group by group, and whether each control moves later than the breather under all of
/// the noise.
void add_runs(Table& table, const std::vector<NoiseGroup>& groups);
void add_departures(Table& table, const std::vector<NoiseGroup>& groups);
void add_controls(Table& table, const NoiseGroup& all_of_it, const NoiseGroup& controls);

}  // namespace lattice
