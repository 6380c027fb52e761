#pragma once
/**
# The packet of an array, watched twice

Every number of the packet at a site comes from two runs, the second with half the step and half the sampling
interval; the error is the difference of the two. */

#include <array>
#include <cstddef>

#include "lattice/numerics/estimate.hpp"
#include "sec3/array_impact.hpp"

namespace lattice {

/// A coarse run and a fine one.
using WatchedRuns = std::array<WatchedRun, 2>;

/// Both runs until 60 ms, watched at site `n`.
WatchedRuns pass_twice(const StruckArray& blow, std::size_t n);

/// Least-squares speed between two sites, in sites per second.
Estimate speed_between(const WatchedRuns& runs, const StruckArray& blow, double from, double to);

}  // namespace lattice
