#pragma once
/**
# How long two runs stay together

The motion of a chain whose contacts open and close is in general chaotic: two runs that differ by a
rounding, by the step or by the last digit of the initial state will part sooner or later. Until then a
trajectory is a fact about the chain; afterwards it is one possibility among many, and only statements
about ensembles make sense. We say that two states have parted when they differ by a tenth of the largest
displacement or velocity. */

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "lattice/numbers/estimate.hpp"
#include "lattice/stepping/accuracy.hpp"

namespace lattice {

inline constexpr double parted = 0.1;    ///< relative difference of the states
inline constexpr double look_every = 2;  ///< units of time between two comparisons

/// The time at which the states `a`, advanced by the stepper `first`, and `b`, advanced by `second`, are
/// first seen to have parted; infinite if they have not by `time`. Both belong to `chain`.
template <class First, class Second>
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
This time is a number like any other: it depends on the steps of the two runs, and has an error. */
/// The time of parting, from two pairs of runs with different steps. A parting is noticed up to
/// `look_every` late, which is added to the error; `nan` if there was none.
Estimate parting(double coarse, double fine);

}  // namespace lattice
