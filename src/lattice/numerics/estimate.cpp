#include "lattice/numerics/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lattice {

Estimate compare(double coarse, double fine) {
  const double rounding = std::numeric_limits<double>::epsilon() * std::abs(fine);
  const double least = std::max(rounding, std::numeric_limits<double>::min());
  const double apart = std::abs(fine - coarse);
  return {fine, apart > least ? apart : std::isnan(apart) ? apart : least};
}

Estimate compare(const Estimate& coarse, const Estimate& fine) {
  Estimate both = compare(coarse.value, fine.value);
  both.error += fine.error;
  return both;
}

Estimate quotient(const Estimate& a, const Estimate& b) {
  const double ratio = a.value / b.value;
  return {ratio, (a.error + std::abs(ratio) * b.error) / std::abs(b.value),
          a.is_exact && b.is_exact};
}

Estimate relative_distance(const Estimate& e, double expected) {
  return {std::abs(e.value / expected - 1), e.error / std::abs(expected), e.is_exact};
}

// What is not a number comes out of either, so that it cannot hide among the members of which the worst is taken
Estimate larger(const Estimate& a, const Estimate& b) {
  return std::isnan(a.value + a.error) || b.value + b.error <= a.value + a.error ? a : b;
}

Estimate smaller(const Estimate& a, const Estimate& b) {
  return std::isnan(a.value + a.error) || a.value - a.error <= b.value - b.error ? a : b;
}

}  // namespace lattice
