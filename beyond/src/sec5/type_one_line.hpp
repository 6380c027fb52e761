#pragma once
/**
# The line of the orbits of type I

For seven orbits of type I we take the speed $c$ and two quantities that change little along the line: the scaled speed
$cE^{-1/4}$, and the mean contact energy over a shift divided by $c^5$. The powers are those of the DpS
limit. A polynomial through the seven gives the line at the speed of the packet; without the slowest orbit it
gives the error of the interpolation. */

#include <cstddef>
#include <vector>

namespace lattice {

/// The orbits k = 7 to 1.
struct ExactLine {
  std::vector<double> speed{}, scaled_speed{}, scaled_contact{};

  /// The quantity `y` at the speed c, by all orbits from number `from` on.
  double at(double c, const std::vector<double>& y, std::size_t from = 0) const;
};

/// Computes them.
ExactLine exact_line();

}  // namespace lattice
