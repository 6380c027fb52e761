#pragma once
/**
# Statements that can fail

Many claims of the article are words: stable, localized, nearly constant. Such a statement is decided by
conditions on numbers: a value must lie on one side of a limit, error bar included. A condition knows its
margin, the distance that is left, so that a reader sees how narrowly it holds, and a test can check that
a wrong input fails it. */

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

/// The condition that `value` lies above `limit`, by more than its error.
inline Condition above(std::string name, const Estimate& value, double limit) {
  return {std::move(name), value, Condition::Side::above, limit};
}
/// The condition that `value` lies below `limit`, by more than its error.
inline Condition below(std::string name, const Estimate& value, double limit) {
  return {std::move(name), value, Condition::Side::below, limit};
}

/**
A statement often needs several conditions, and holds if all of them do. One without conditions could not
fail, and so does not hold. */
using Criterion = std::vector<Condition>;

/// The value lies between two limits, by more than its error on either side.
inline Criterion within(const Estimate& value, double low, double high) {
  return {above("least", value, low), below("most", value, high)};
}

/// The same conditions, their names after `prefix`.
inline Criterion named(const std::string& prefix, Criterion criterion) {
  for (Condition& c : criterion) c.name = prefix + "_" + c.name;
  return criterion;
}

/// Adds the conditions of `more` to `all`.
inline void append(Criterion& all, const Criterion& more) {
  all.insert(all.end(), more.begin(), more.end());
}

/// Whether there are conditions and all of them hold.
inline bool holds(const Criterion& criterion) {
  return !criterion.empty() && std::all_of(criterion.begin(), criterion.end(),
                                           [](const Condition& c) { return c.holds(); });
}

}  // namespace lattice
