#pragma once
// Statements in words are decided by conditions on numbers: a value must lie on one side of a limit, by more than its error.

#include <algorithm>
#include <string>
#include <vector>

#include "lattice/numerics/estimate.hpp"

/// `value` must be above (or below) `limit`.
struct Bound {
  std::string name;
  lattice::Estimate value;
  bool is_lower;
  double limit;

  bool holds() const {
    return (is_lower ? value.value - limit : limit - value.value) > value.error;
  }
};
using Bounds = std::vector<Bound>;

inline Bound above(std::string name, const lattice::Estimate& value, double limit) {
  return {std::move(name), value, true, limit};
}
inline Bound below(std::string name, const lattice::Estimate& value, double limit) {
  return {std::move(name), value, false, limit};
}
/// Between two limits.
inline Bounds within(const lattice::Estimate& value, double low, double high) {
  return {above("least", value, low), below("most", value, high)};
}

/// Whether there are conditions and all of them hold: a statement without one could never fail.
inline bool holds(const Bounds& all) {
  return !all.empty() &&
         std::all_of(all.begin(), all.end(), [](const Bound& b) { return b.holds(); });
}
