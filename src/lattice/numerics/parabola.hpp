#pragma once
/**
# Between the samples

The largest value of a sampled quantity lies between two samples, and so does the instant at which a
packet turns. The parabola through a sample and its two neighbours finds both: the instant to second order in
the distance of the samples, the value to third. */

#include "lattice/numerics/ieee.hpp"

namespace lattice {

/// The parabola through three values at -1, 0 and 1, in units of the distance between samples.
struct Parabola {
  double middle;  ///< value at 0
  double slope;   ///< derivative at 0
  double bend;    ///< second derivative

  Parabola(double before, double here, double after)
      : middle(here), slope((after - before) / 2), bend(after - 2 * here + before) {}

  /// Where the vertex lies; there is none where `bend` is zero.
  double vertex() const { return -slope / bend; }
  /// The value at the vertex.
  double extremum() const { return middle + slope * vertex() / 2; }
};

}  // namespace lattice
