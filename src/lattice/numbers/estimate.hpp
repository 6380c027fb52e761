#pragma once
/**
# A value with its error

Every number that leaves a program either carries an error, the difference between two really different
computations of it, or is exact: counted, decided, or given. An error of zero in a number that nobody has
called exact is an omission. */

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>

namespace lattice {

/// A value with the error from two resolutions, or without one because it is exact.
struct Estimate {
  double value = 0, error = 0;
  bool is_exact = false;
};

/// A number that no resolution can change.
inline Estimate exact(double value) {
  return {value, 0, true};
}

/**
The usual error is that of two resolutions: `compare` returns the finer result with its difference from
the coarser one. Two results that agree to the last digit are known to that digit and no better. If either
is not a number, so is the error. */
inline Estimate compare(double coarse, double fine) {
  const double rounding = std::numeric_limits<double>::epsilon() * std::abs(fine);
  const double least = std::max(rounding, std::numeric_limits<double>::min());
  const double apart = std::abs(fine - coarse);
  return {fine, apart > least ? apart : std::isnan(apart) ? apart : least};
}

/// The same for results that have errors of their own: that of the finer one is added.
inline Estimate compare(const Estimate& coarse, const Estimate& fine) {
  Estimate both = compare(coarse.value, fine.value);
  both.error += fine.error;
  return both;
}

/**
Estimates are compared with each other and with what is expected; errors go along. */
/// a / b with the errors of both.
inline Estimate quotient(const Estimate& a, const Estimate& b) {
  const double ratio = a.value / b.value;
  return {ratio, (a.error + std::abs(ratio) * b.error) / std::abs(b.value),
          a.is_exact && b.is_exact};
}

/// How far `e` is from `expected`, as a fraction of `expected`.
inline Estimate relative_distance(const Estimate& e, double expected) {
  return {std::abs(e.value / expected - 1), e.error / std::abs(expected), e.is_exact};
}

/// Whichever of two estimates may be the larger one, its error included.
inline Estimate larger(const Estimate& a, const Estimate& b) {
  return a.value + a.error < b.value + b.error ? b : a;
}

/// Whichever of two estimates may be the smaller one.
inline Estimate smaller(const Estimate& a, const Estimate& b) {
  return b.value - b.error < a.value - a.error ? b : a;
}

/// Counts are exact as soon as two resolutions agree on them.
template <std::integral Count>
Estimate compare(Count coarse, Count fine) {
  if (coarse == fine) return exact(double(fine));
  return {double(fine), std::abs(double(fine) - double(coarse))};
}

}  // namespace lattice
