#include "lattice/numerics/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace lattice {

Estimate with_error(double coarse, double fine) {
  return {fine, std::abs(fine - coarse)};
}

Estimate with_error(const Estimate& coarse, const Estimate& fine) {
  Estimate both = with_error(coarse.value, fine.value);
  both.error += fine.error;
  return both;
}

Estimate after_halving(const Estimate& before, Estimate last, double gain) {
  const double least = before.error / gain;
  if (!last.is_exact && std::isfinite(least)) last.error = std::max(last.error, least);
  return last;
}

Estimate quotient(const Estimate& a, const Estimate& b) {
  const double ratio = a.value / b.value;
  if (a.is_exact && b.is_exact) return exact(ratio);
  return {ratio, (a.error + std::abs(ratio) * b.error) / std::abs(b.value)};
}

Estimate relative_distance(const Estimate& e, double expected) {
  const double apart = std::abs(e.value / expected - 1);
  return e.is_exact ? exact(apart) : Estimate{apart, e.error / std::abs(expected)};
}

// What is not a number comes out of either, so that it cannot hide among the members of which the worst is taken
Estimate larger(const Estimate& a, const Estimate& b) {
  return std::isnan(a.value + a.error) || b.value + b.error <= a.value + a.error ? a : b;
}

Estimate smaller(const Estimate& a, const Estimate& b) {
  return std::isnan(a.value + a.error) || a.value - a.error <= b.value - b.error ? a : b;
}

}  // namespace lattice
