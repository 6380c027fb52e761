#pragma once
/**
# A value with its error

Every number that leaves a program either carries an error, the difference between two really different
computations of it, or is exact: counted, decided, or given. An error of zero in a number that nobody has
called exact is an omission. */

#include <algorithm>
#include <concepts>
#include <functional>
#include <limits>

#include "lattice/numerics/ieee.hpp"

namespace lattice {

/// A value with the error from two resolutions, or without one because it is exact. What is not exact is known to the last
/// digit of a double and no better, so that no error of zero can be written.
struct Estimate {
  double value = 0, error = 0;  ///< the error is absolute and not negative
  bool is_exact = false;        ///< counted, decided or given; the error is then zero

  /// Not yet a number: the beginning of a sum or of a search.
  Estimate() = default;
  /// With at least the error of a rounding.
  constexpr Estimate(double number, double known_to = 0) : value(number), error(known_to) {
    using Limits = std::numeric_limits<double>;
    const double size = number < 0 ? -number : number,
                 rounding = std::max(Limits::epsilon() * size, Limits::min());
    if (size <= Limits::max() && error < rounding) error = rounding;
  }
};

/// A number that no resolution can change.
inline Estimate exact(double value) {
  Estimate out;
  out.value = value, out.is_exact = true;
  return out;
}

/// The finer result with its difference from the coarser one; if either is not a number, so is the error.
Estimate with_error(double coarse, double fine);

/// The same for results that have errors of their own: that of the finer one is added.
Estimate with_error(const Estimate& coarse, const Estimate& fine);

/// Counts are exact as soon as two resolutions agree on them.
template <std::integral Count>
Estimate with_error(Count coarse, Count fine) {
  if (coarse == fine) return exact(double(fine));
  return {double(fine),
          coarse < fine ? double(fine) - double(coarse) : double(coarse) - double(fine)};
}

/**
Two resolutions can agree by chance, and the error would then be too small by any factor. The step before tells: halving
the step of a method of order six divides a difference by 64 at most, and at contact events by less. */
inline constexpr double largest_gain = 64;
/// `last` with an error that is at least the part 1/gain of that of `before`, the comparison of two steps twice as long. An
/// exact number, and a `before` without a finite error, change nothing.
Estimate after_halving(const Estimate& before, Estimate last, double gain = largest_gain);

/// The same computation at two resolutions, and numbers with errors from it.
template <class Result>
struct TwoRuns {
  Result coarse, fine;

  /// What `number`, a function or a member, reads from the finer one, with its difference from the coarser one.
  template <class Number>
  Estimate of(Number number) const {
    return with_error(std::invoke(number, coarse), std::invoke(number, fine));
  }
};

/// The modulus, where a sign means nothing.
inline Estimate modulus(Estimate e) {
  e.value = e.value < 0 ? -e.value : e.value;
  return e;
}

/// a / b with the errors of both.
Estimate quotient(const Estimate& a, const Estimate& b);

/// How far `e` is from `expected`, as a fraction of `expected`.
Estimate relative_distance(const Estimate& e, double expected);

/// Whichever of two estimates may be the larger one, its error included.
Estimate larger(const Estimate& a, const Estimate& b);

/// Whichever of two estimates may be the smaller one.
Estimate smaller(const Estimate& a, const Estimate& b);

}  // namespace lattice
