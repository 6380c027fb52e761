#pragma once
/**
# Other definitions of what the packet does

The article prints a speed, a duration, a wave train and two reflections without saying over which sites, above which force
or in which energy they are measured. The chapter chooses one definition of each; this file computes the others, for the
statements. */

#include <cstddef>
#include <vector>

#include "lattice/numerics/estimate.hpp"
#include "report/program.hpp"
#include "sec3/array_impact.hpp"

namespace lattice {

/// Steps of the coarser and of the finer run, in units of tau_c.
struct TwoSteps {
  double coarse, fine;
};

/// Table `experiment`: what an experiment would see in 10 ms, from the struck end on and from `watched` on.
void report_experiment(Report& report, const StruckArray& struck, std::size_t watched,
                       const TwoRuns<WatchedRun>& runs);

/// Table `speeds`: sites over the time of the largest force at `watched`, and slopes of X(t) on several stretches.
void report_speeds(Report& report, const StruckArray& struck, std::size_t watched,
                   const TwoRuns<WatchedRun>& runs);

/// Table `durations`: how long the force at the watched contact is above several fractions of its maximum.
void report_durations(Report& report, const StruckArray& struck, const TwoRuns<WatchedRun>& runs);

/// The part of the wave train and of the packet in a density.
struct Train {
  double sites;   ///< participation number of the sites up to ten behind the packet's largest one
  double share;   ///< fraction of the impact's energy `all` on them
  double packet;  ///< participation number of the packet
  std::size_t first,
      last;  ///< sites behind which and before which 95 per cent of the train's energy lies

  Train(std::vector<double> density, double all);
};

/// Table `wave_train`: when the packet is at site 50, and just before it meets the defect.
void report_wave_train(Report& report, const StruckArray& struck, const TwoSteps& steps);

/// Table `packets`: energy of the packet alone, back at site 80 or passed to site 120, over that on its way at site 80.
void report_packets(Report& report, const StruckArray& struck, const TwoSteps& steps);

}  // namespace lattice
