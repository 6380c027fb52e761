#pragma once
/**
# Any periodic orbit of any chain

From a guess Newton's method finds an orbit that begins at rest, in a chain with masses, contacts, wells and ends of the
reader's own, and of every orbit, at rest or not, the multipliers tell how stable it is. In Python these are `Chain.orbit`
and `Chain.multipliers`. */

#include <complex>
#include <utility>
#include <vector>

#include "commands/one_breather.hpp"

namespace lattice {
using namespace report;

/// An orbit that begins at rest. Far from y = 0, and where a shift of the whole chain costs nothing, its amplitude is that
/// of the motion: half the distance between the two extreme positions of the bead that moves most.
struct RestingOrbit : FoundOrbit {
  Estimate amplitude;
  int repeats;  ///< how many times the motion repeats itself in the given period

  Table quantities() const;
};

/// The orbit of this period near one that is at rest at the positions of `guess`; it is even in time. Where several are
/// equally near, as with a shift of a chain without wells, the shortest step leads there. Throws NewtonFailed, and
/// std::invalid_argument if nothing moves.
RestingOrbit orbit_from_rest(const Chain& chain, const State<double>& guess, double period);

/// All multipliers with their errors, the two of the time-translation pair first, then by their distance from +1.
struct OrbitMultipliers {
  std::vector<std::pair<std::complex<double>, double>> all;
  Estimate largest_modulus;
};

/// The multipliers of the orbit nearest to `start`, in two precisions. Throws std::invalid_argument where none passes
/// within a thousandth of the amplitude or nothing moves, NewtonFailed.
OrbitMultipliers multipliers_through(const Chain& chain, const State<double>& start, double period);

}  // namespace lattice
