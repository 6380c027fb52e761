#pragma once
/**
# DpS breathers under noise

`sec33_dps_stability` follows breathers under noise, seed by seed. Here are the noise and what is counted. */

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
  const char* noise;  ///< as tables name it: main, narrow, real or relative
  const char* start;  ///< site, bond or control
  const PinnedBreather& breather;
  Noise of;
  double time;               ///< of the runs
  double counted_by = time;  ///< by when a departure counts
  std::size_t seeds = 16;
  bool without_mode =
      false;  ///< a control: its noise has no component along the translational mode
  NoiseTrials trials{};

  /// The breather under the noise of this seed; writes shift and push to the trial.
  Field perturbed(NoiseTrial& trial) const;
};

/// How many of these breathers pass on if and only if their push exceeds the threshold: beyond its error, and at both
/// tolerances.
int predicted_by(const Estimate& threshold, const NoiseGroup& group);

/// The rows of tables: run by run, for the group, and whether each control moves later than the breather under all of the
/// noise.
void add_runs(Table& table, const NoiseGroup& group);
void add_departures(Table& table, const NoiseGroup& group);
void add_controls(Table& table, const NoiseGroup& all_of_it, const NoiseGroup& controls);

}  // namespace lattice
