#pragma once
/**
# Two resolutions of an orbit

What is read from a periodic orbit gets its error from the same orbit found twice, with two tolerances of the flow. */

#include <limits>

#include "lattice/numerics/estimate.hpp"
#include "lattice/orbits/newton.hpp"

namespace lattice {

/// What double precision is checked against: a 64-bit mantissa where the processor has one.
using Wide = long double;

/// With the default tolerance of `EventTolerance`, or with 16 times that.
enum class Resolution { fine, coarse };

/// The rule of Newton's method at a resolution.
template <class T>
NewtonRule<T> rule(Resolution resolution) {
  NewtonRule<T> out;
  out.events.tolerance = T(128) * std::numeric_limits<T>::epsilon();
  if (resolution == Resolution::coarse) out.events.tolerance *= T(16);
  return out;
}

/// The fine rule for the tail: every site to the same relative accuracy, and every contact event, however faint.
template <class T>
NewtonRule<T> scaled_rule() {
  NewtonRule<T> out = rule<T>(Resolution::fine);
  out.scaled = true;
  out.events.slowest_event = T(0);
  return out;
}

/**
The difference of the two is the error, but it may be small by chance. Comparison with quadruple precision shows errors
of the energy of up to ten tolerances, so the error is never below sixteen: 2048 roundings of `size`, which is the
energy or, where it is more, what 1/64 of the frequency changes of it. At equal action a quarter of the energy serves as
size: an orbit makes $E - \mathcal A/T_b$ stationary, and this barrier suffers less from an error of the orbit. */
/// `fine` with that error.
template <class T>
Estimate with_flow_error(const T& coarse, const T& fine, const T& size) {
  const T least = T(2048) * std::numeric_limits<T>::epsilon() * magnitude(size);
  return {double(fine), double(magnitude<T>(fine - coarse) + least)};
}

}  // namespace lattice
