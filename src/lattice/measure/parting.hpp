#pragma once
/**
# How long two runs stay together

The motion of a chain is chaotic as soon as its contacts open and close, so two runs that differ by
a rounding, by the step or by a digit of the initial state sooner or later part. Until then a
trajectory is a fact about the chain; afterwards it is one possibility among many, and only
statements about ensembles make sense. We say that two states have parted when they differ by
a tenth of the largest displacement or velocity. */

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "lattice/numbers/estimate.hpp"
#include "lattice/stepping/accuracy.hpp"

namespace lattice {

inline constexpr double parted = 0.1;    ///< relative difference of the states
inline constexpr double look_every = 2;  ///< units of time between two comparisons

/// The time by which `a`, moved by `first`, and `b`, moved by `second`, have parted; infinite if
/// they have not by `time`. Both states belong to `chain`.
template <class First, class Second, class Chain>
double parting_time(const First& first, State<double> a, const Second& second, State<double> b,
                    const Chain& chain, double time) {
  double when = std::numeric_limits<double>::infinity();
  std::vector<State<double>> seen;
  evolve(first, chain, a, time, look_every, [&](const State<double>& now) { seen.push_back(now); });
  std::size_t k = 0;
  evolve(second, chain, b, time, look_every, [&](const State<double>& now) {
    if (distance(seen[k], now) > parted) when = now.t;
    return ++k, !std::isfinite(when);
  });
  return when;
}

/**
That time is a number like others: it depends on the steps of both runs, and it has an error. */
/// The time of a parting from two steps. It is seen when we look, no sooner; `nan` if never.
inline Estimate parting(double coarse, double fine) {
  if (!std::isfinite(coarse) || !std::isfinite(fine)) return {std::nan(""), std::nan("")};
  Estimate when = compare(coarse, fine);
  when.error += look_every;
  return when;
}

}  // namespace lattice
