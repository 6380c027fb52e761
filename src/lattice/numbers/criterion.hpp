#pragma once
/**
# Statements that can fail

A statement in words is decided by conditions on numbers: a value with its error must lie on one
side of a limit, error bar and all. A condition knows its margin, the distance that is left, so
that a reader sees how narrowly it holds, and a test sees that a wrong input fails it. */

#include <algorithm>
#include <string>
#include <vector>

#include "lattice/numbers/estimate.hpp"

namespace lattice {

/// `value` must be above (or below) `limit`.
struct Condition {
  std::string name;
  Estimate value;
  enum class Side { below, above } side;
  double limit;

  /// Distance from the limit, positive on the right side, with the error of the value.
  Estimate margin() const {
    const double left = side == Side::above ? value.value - limit : limit - value.value;
    return {left, value.error, value.is_exact};
  }
  bool holds() const { return margin().value > margin().error; }
};

inline Condition above(std::string name, const Estimate& value, double limit) {
  return {std::move(name), value, Condition::Side::above, limit};
}
inline Condition below(std::string name, const Estimate& value, double limit) {
  return {std::move(name), value, Condition::Side::below, limit};
}

/**
A statement holds if all its conditions do. */
using Criterion = std::vector<Condition>;

inline bool holds(const Criterion& criterion) {
  return !criterion.empty() && std::all_of(criterion.begin(), criterion.end(),
                                           [](const Condition& c) { return c.holds(); });
}

}  // namespace lattice
