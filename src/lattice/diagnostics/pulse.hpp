#pragma once
/**
# A packet passes

Seen from a fixed contact, a travelling breather is a train of pushes: the contact closes once in each internal period,
harder and harder and then less and less. From such a train, sampled a fraction of a period apart, this file reads what an
experiment would report. Maxima are those of parabolas through three samples, crossings those of straight lines. */

#include <optional>
#include <vector>

#include "lattice/numerics/ieee.hpp"

namespace lattice {

/// A local maximum: when, and how high.
struct Top {
  double t, x;
};

/// The local maxima of equidistant samples, each from the parabola through a sample and its neighbours.
std::vector<Top> maxima(const std::vector<double>& t, const std::vector<double>& x);

/// The highest local maximum of the modulus of `x`, or zero if there is none.
double largest_modulus(const std::vector<double>& t, std::vector<double> x);

/// The strongest push of a train, and half the time between the one before and the one after it.
struct Push {
  double t, force, period;  ///< in the units of the samples
};

/// The strongest push of the samples `force`; nothing if it is the first or the last one, because the
/// packet has then not passed.
std::optional<Push> strongest_push(const std::vector<double>& t, const std::vector<double>& force);

/// The times at which `x` passes `level` upwards, linear between the samples.
std::vector<double> upward_crossings(const std::vector<double>& t, const std::vector<double>& x,
                                     double level = 0);

/// Time from the first upward to the last downward passage of `level`; zero if there is none.
double time_above(const std::vector<double>& t, const std::vector<double>& x, double level);

}  // namespace lattice
