#pragma once
/**
# A value with its error

Every number that leaves a program either carries an error, the difference between two really different
computations of it, or is exact: counted, decided, or given. An error of zero in a number that nobody has
called exact is an omission. */

#include <concepts>

#include "lattice/numerics/ieee.hpp"

namespace lattice {

/// A value with the error from two resolutions, or without one because it is exact.
struct Estimate {
  double value = 0, error = 0;  ///< the error is absolute and not negative
  bool is_exact = false;        ///< counted, decided or given; the error is then zero
};

/// A number that no resolution can change.
inline Estimate exact(double value) {
  return {value, 0, true};
}

/// The finer result with its difference from the coarser one. Results that agree to the last digit are known to that digit
/// and no better; if either is not a number, so is the error.
Estimate compare(double coarse, double fine);

/// The same for results that have errors of their own: that of the finer one is added.
Estimate compare(const Estimate& coarse, const Estimate& fine);

/// Counts are exact as soon as two resolutions agree on them.
template <std::integral Count>
Estimate compare(Count coarse, Count fine) {
  if (coarse == fine) return exact(double(fine));
  return {double(fine),
          coarse < fine ? double(fine) - double(coarse) : double(coarse) - double(fine)};
}

/// The same computation at two resolutions, and numbers with errors from it.
template <class Result>
struct TwoRuns {
  Result coarse, fine;

  /// What `number` reads from the finer one, with its difference from the coarser one.
  template <class Number>
  Estimate of(Number number) const {
    return compare(number(coarse), number(fine));
  }
};

/// a / b with the errors of both.
Estimate quotient(const Estimate& a, const Estimate& b);

/// How far `e` is from `expected`, as a fraction of `expected`.
Estimate relative_distance(const Estimate& e, double expected);

/// Whichever of two estimates may be the larger one, its error included.
Estimate larger(const Estimate& a, const Estimate& b);

/// Whichever of two estimates may be the smaller one.
Estimate smaller(const Estimate& a, const Estimate& b);

}  // namespace lattice
