#pragma once
/**
# Exact travelling breathers in other wells

An orbit of the linear well continues to wells with $s \ne 0$: with $T$ as an unknown there are as many equations as
unknowns, and a regular solution persists. Its branch is followed by pseudo-arclength, so that it passes *folds*, at which
it turns back in $s$ (continuation.hpp), within $|s| \le 3$ and $T \ge \pi$, which are our choice. Newton's method fails
where beads of the tail only just touch; a branch is shown up to there. */

#include <vector>

#include "sec5/travelling.hpp"

namespace lattice {

/// A point of a branch.
struct Place {
  double s, turns, energy;  ///< turns: shift time over 2 pi
};

/// The branch of an orbit of type I at s = 0 into hard (direction 1) or soft (-1) wells, in steps up to `longest`.
/// Throws NewtonFailed.
Branch branch_in_s(const Orbit<double>& start, int direction, double longest = 0.25);

/// Its points, so many steps far.
std::vector<Place> follow_branch(const Orbit<double>& start, int direction, int steps);

}  // namespace lattice
