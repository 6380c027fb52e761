#pragma once
/**
# Statements that can fail

Many claims of the article are made in words: stable, localized, nearly constant. Such a statement is decided by
conditions on numbers: a value must lie on one side of a limit, error bar included. A condition knows its
margin, the distance that is left to the limit, so that a reader sees how narrowly it holds and a test can
check that wrong input violates it. */

#include <string>
#include <vector>

#include "lattice/numerics/estimate.hpp"

namespace lattice {

/// `value` must be above (or below) `limit`.
struct Condition {
  std::string name;                       ///< by which a report calls it
  Estimate value;                         ///< what is judged
  enum class Side { below, above } side;  ///< of the limit on which it must lie
  double limit;

  /// Distance from the limit, positive on the right side, with the error of the value.
  Estimate margin() const;
  /// Whether the value lies on the right side by more than its error.
  bool holds() const { return margin().value > margin().error; }
};

/// The condition that `value` lies above `limit`, by more than its error.
Condition above(std::string name, const Estimate& value, double limit);
/// The condition that `value` lies below `limit`, by more than its error.
Condition below(std::string name, const Estimate& value, double limit);

/**
A statement often needs several conditions, and holds if all of them do. A statement without conditions
could never fail; it therefore counts as one that does not hold. */
using Criterion = std::vector<Condition>;

/// The value lies between two limits, by more than its error on either side.
Criterion within(const Estimate& value, double low, double high);

/**
A quantity increases along a sequence if in modulus each value exceeds the one before and none has another
sign, since what changes its sign vanishes in between. So the smallest ratio of neighbours must be above one,
errors included; a sequence has at least two values. */
Criterion increasing(const std::vector<Estimate>& values);

/// The same conditions, their names after `prefix`.
Criterion named(const std::string& prefix, Criterion criterion);

/// Adds the conditions of `more` to `all`.
void append(Criterion& all, const Criterion& more);

/// Whether there are conditions and all of them hold.
bool holds(const Criterion& criterion);

}  // namespace lattice
