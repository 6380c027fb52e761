#pragma once
/**
# Numbers of a stationary state in two precisions

Stationary breathers of the DpS equation (stationary.hpp) are computed to the last digit of any number format, so the
error of a number is its difference between double and quadruple precision. Where the exact value is zero, a computed
remainder is pure rounding and belongs to its precision. It is compared with the remainder at the next longer
mantissa, extended for double and 50 digits for quadruple, so its error is about as large as itself. */

#include <algorithm>
#include <limits>

#include "lattice/numerics/estimate.hpp"
#include "lattice/quadruple/extended.hpp"
#include "lattice/standing/stationary.hpp"

namespace lattice {

/// A number of any precision rounded to double.
template <class T>
double rounded(const T& x) {
  return static_cast<double>(x);
}

/// `of` applied to the state in both precisions.
template <class Of>
Estimate in_two_precisions(Centre centre, Of of) {
  return compare(rounded(of(stationary<double>(centre, 1, sites_of(centre)))),
                 rounded(of(stationary<Quadruple>(centre, 1, sites_of(centre)))));
}

/**
Two such remainders may agree by chance, above all where both are zero, and that is no convergence. Those
of numbers of size one are therefore never known better than to one rounding. */
template <class T>
Estimate rounding_at_least(Estimate e) {
  e.error = std::max(e.error, rounded(std::numeric_limits<T>::epsilon()));
  return e;
}

/// The remainder `of` the state in precision T, compared with the one in the longer precision.
template <class T, class Longer, class Of>
Estimate remainder(Centre centre, Of of) {
  const std::size_t sites = sites_of(centre);
  return rounding_at_least<T>(compare(rounded(of(stationary<Longer>(centre, Longer(1), sites))),
                                      rounded(of(stationary<T>(centre, T(1), sites)))));
}

}  // namespace lattice
