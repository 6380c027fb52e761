#pragma once
/**
# Any periodic orbit of any chain

From a guess Newton's method finds an orbit that begins at rest, in a chain with masses, contacts, wells and ends of the
reader's own, and its multipliers tell how stable it is. In Python these are `Chain.orbit` and `Chain.multipliers`. */

#include "commands/multipliers.hpp"
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

/// The multipliers of the orbit nearest to these positions at rest, in two precisions. Throws std::invalid_argument where none
/// begins within a thousandth of the amplitude or nothing moves, NewtonFailed.
Spectrum multipliers_from_rest(const Chain& chain, const State<double>& start, double period);

}  // namespace lattice
