#pragma once
/**
# How far equal packets spread

Impacts that differ in late digits only make packets whose paths differ more and more. We compare the centres of
smoothed paths; otherwise the phases of the oscillations would count as a spread. */

#include <vector>

#include "lattice/diagnostics/path.hpp"
#include "lattice/numerics/estimate.hpp"

namespace lattice {

/// The centres at one time: mean, standard deviation, lower and upper decile.
struct Spread {
  double t, mean, deviation, low, high;
};

/// The spread of smoothed paths with equal times, at every sample whose number is a multiple of `every`.
std::vector<Spread> spread_of(const std::vector<Path>& smoothed, std::size_t every);

/// The first time at which the deviation exceeds `sites`. Throws std::runtime_error if it never does.
double time_to_spread(const std::vector<Spread>& all, double sites);

/// Rate of growth of the deviation: the slope of its logarithm between two times.
Estimate growth(const std::vector<Spread>& all, double from, double to);

/// Mean of the deviation over the times between `from` and `to`.
double mean_deviation(const std::vector<Spread>& all, double from, double to);

}  // namespace lattice
