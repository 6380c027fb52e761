#pragma once
/**
# Eigenvalues counted for certain

How many eigenvalues of a symmetric tridiagonal matrix are larger than $x$? As many as there are positive pivots
in the elimination of the matrix minus $x$ (Sylvester's law of inertia). In intervals each pivot either has a
certain sign or it does not, and in the second case there is no answer. */

#include <optional>
#include <vector>

#include "sec5/interval.hpp"

namespace lattice {

/// Number of eigenvalues larger than `x`; none of them is `x`. Nothing if a pivot may vanish.
inline std::optional<std::size_t> counted_above(const std::vector<Interval<double>>& diagonal,
                                                const std::vector<Interval<double>>& beside,
                                                double x) {
  std::size_t count = 0;
  Interval<double> pivot{};
  for (std::size_t i = 0; i < diagonal.size(); ++i) {
    const Interval<double> moved = diagonal[i] - x;
    pivot = i == 0 ? moved : moved - beside[i - 1] * beside[i - 1] / pivot;
    if (!(pivot.lower > 0 || pivot.upper < 0)) return std::nullopt;
    count += pivot.lower > 0;
  }
  return count;
}

/**
An eigenvalue is enclosed by two numbers between which the count changes, halving the distance as long as the
counts have an answer. */
/// The k-th largest eigenvalue, if fewer than k are larger than `most` and at least k than `least`;
/// otherwise all numbers.
inline Interval<double> enclosed_eigenvalue(const std::vector<Interval<double>>& diagonal,
                                            const std::vector<Interval<double>>& beside,
                                            std::size_t k, double least, double most) {
  const auto above_at = [&](double x) { return counted_above(diagonal, beside, x); };
  if (above_at(least).value_or(0) < k || above_at(most).value_or(k) >= k)
    return Interval<double>::all();
  Interval<double> found{least, most};
  // Each end moves on its own, because in the middle there is no answer in the end
  for (double* end : {&found.lower, &found.upper}) {
    double good = *end, bad = end == &found.lower ? most : least;
    for (int i = 0; i < 2 * std::numeric_limits<double>::digits; ++i) {
      const double x = good + (bad - good) / 2;
      const auto n = above_at(x);
      const bool still = n && (end == &found.lower ? *n >= k : *n < k);
      (still ? good : bad) = x;
    }
    *end = good;
  }
  return found;
}

}  // namespace lattice
