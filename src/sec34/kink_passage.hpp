#pragma once
/**
# A kink passes

Speed, length and energy of a kink, or of a pulse without wells, while it passes some beads of a long chain. */

#include <cstddef>

#include "lattice/model/chain.hpp"

namespace lattice {

/// Beads from the first to the last one, counted from one.
struct Beads {
  std::size_t first, last;
};

/// Where and how to watch: a chain that is long enough, two stretches, and the displacement that counts as a passage.
struct KinkWatch {
  Chain chain;
  Beads near, far;
  double passed_at;
};

/// What passes. A speed is the slope of the times at which the beads of a stretch pass `passed_at`.
struct KinkPassage {
  double speed = 0;    ///< on the near stretch
  double later = 0;    ///< on the far one
  double largest = 0;  ///< largest velocity of a bead, mean over the near stretch
  double spread = 0;   ///< its largest value less its smallest, over the mean
  double length = 0;   ///< speed times the time above half of the largest velocity, mean there
  double way = 0;      ///< displacement of the last bead of the near stretch at the end

  /// The speed over the fifth root of the largest velocity, constant for Nesterenko's soliton.
  double scaled() const;
};

/// The passage after an impact of this velocity, with steps and samples of `step`. Throws Failure if nothing passes.
KinkPassage passage(const KinkWatch& watch, double v0, double step);

/// The energy from three beads behind `bead` on, sum of e_m over m >= bead - 3, Eq. (23), when it passes `passed_at`.
double kink_energy(const KinkWatch& watch, double v0, std::size_t bead, double step);

}  // namespace lattice
