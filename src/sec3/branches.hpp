#pragma once
/**
# Branches from rest to a fold

A family of breathers is a branch of periodic orbits. It bifurcates from the chain at rest, some quantities grow along
it, and in soft wells it turns back. */

#include <cmath>
#include <cstddef>
#include <vector>

#include "lattice/numerics/estimate.hpp"
#include "lattice/orbits/breather_pairs.hpp"
#include "lattice/orbits/continuation.hpp"

namespace lattice {

/// The exponent of the amplitude in omega_b - 1 between two breathers: two near a bifurcation from rest, by Eq. (20),
/// zero where a family begins at a finite amplitude.
inline double growth_exponent(const Orbit<double>& lower, const Orbit<double>& upper) {
  return std::log(upper.amplitude / lower.amplitude) /
         std::log((upper.omega - 1) / (lower.omega - 1));
}

/// The smallest ratio of neighbours: above one if the modulus grows at every step and the sign stays; nan for less than
/// two values.
inline Estimate least_ratio(const std::vector<Estimate>& values) {
  if (values.size() < 2) return {std::nan(""), std::nan("")};
  Estimate least = quotient(values[1], values[0]);
  for (std::size_t k = 2; k < values.size(); ++k)
    least = smaller(least, quotient(values[k], values[k - 1]));
  return least;
}

/// By which factor a curve that crosses zero again and again grows from arch to arch at least. Its arches, the pieces between
/// two changes of sign, are as high as the largest of their values; of a single arch the values count.
inline Estimate least_growth_of_arches(const std::vector<Estimate>& values) {
  std::vector<Estimate> heights, sizes;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const Estimate size{std::abs(values[k].value), values[k].error};
    if (k > 0 && values[k].value * values[k - 1].value > 0)
      heights.back() = larger(heights.back(), size);
    else
      heights.push_back(size);
    sizes.push_back(size);
  }
  return least_ratio(heights.size() < 2 ? sizes : heights);
}

/// The mean modulus of a curve; that of every second value tells how well it is known.
inline Estimate mean_size(const std::vector<Estimate>& values) {
  const auto mean = [&](std::size_t step) {
    Estimate sum{};
    double count = 0;
    for (std::size_t k = 0; k < values.size(); k += step, ++count)
      sum = {sum.value + std::abs(values[k].value), sum.error + values[k].error};
    return Estimate{sum.value / count, sum.error / count};
  };
  return compare(mean(2), mean(1));
}

}  // namespace lattice
