#pragma once
/**
# Any periodic orbit of any chain

From a guess Newton's method finds an orbit that begins at rest, in a chain with masses, contacts, wells and ends of the
reader's own, and of every orbit, at rest or not, the multipliers tell how stable it is. In Python these are `Chain.orbit`
and `Chain.multipliers`. */

#include <complex>
#include <utility>
#include <vector>

#include "lattice/numerics/estimate.hpp"
#include "lattice/orbits/breather.hpp"

namespace lattice {

/// The orbit of this period near one that is at rest at the positions of `guess`; it is even in time. Throws NewtonFailed.
Fitted orbit_from_rest(const Chain& chain, const State<double>& guess, double period);

/// Its positions at t = 0, from a wider number type; the error is the distance of those in double precision.
std::vector<Estimate> positions_of(const Fitted& found);

/// All multipliers with their errors, the two of the time-translation pair first, then by their distance from +1.
struct OrbitMultipliers {
  std::vector<std::pair<std::complex<double>, double>> all;
  Estimate largest_modulus;
};

/// The multipliers of the orbit nearest to `start`, in two precisions. Throws std::invalid_argument where none passes
/// within a thousandth of the amplitude, NewtonFailed.
OrbitMultipliers multipliers_through(const Chain& chain, const State<double>& start, double period);

}  // namespace lattice
