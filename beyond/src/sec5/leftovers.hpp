#pragma once
/**
# Noisy waves that have broken up

A plane wave with noise of one per cent runs on a ring of 64 sites of the DpS equation, and from a sixth of the run on its
breathers are collected (dps_tracks.hpp). */

#include <vector>

#include "lattice/numerics/estimate.hpp"
#include "sec5/dps_tracks.hpp"

namespace lattice {

/// One run and the breathers that were found.
struct Leftover {
  int waves;  ///< on the ring; zero stands for random amplitudes
  unsigned long seed;
  std::vector<BreatherTrack> found{};

  /// Runs for `duration` and collects what lives for at least `least`.
  void run(double duration, double least, double tolerance);
  /// How many live at a time while they are watched.
  double at_a_time(double watched) const;
};

/// The mean over the seeds of a quantity, with the standard error and the difference of two tolerances as its error.
Estimate over_seeds(const std::vector<std::vector<double>>& values);

/// What is left of one wave at two tolerances: how many breathers live at a time in each run, and of each breather whether it
/// is at rest (within two sites for all of its life), its energy over that of a static one, its speed and the size of that.
struct LeftoverStatistics {
  std::vector<std::vector<double>> number, rest, share, speed, size;
};
LeftoverStatistics statistics_of(const std::vector<Leftover> (&runs)[2], int waves, double watched);

/// How many of the random fields with the seeds 1, 2 and so on have more than `surplus` of energy per site, and by how much
/// their energies scatter.
struct RandomEnergies {
  int above;
  Estimate scatter;
};
RandomEnergies random_energies(unsigned long seeds, double surplus);

}  // namespace lattice
