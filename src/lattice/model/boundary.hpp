#pragma once
/**
# Where the chain ends

A chain of $N$ beads, counted from zero, has $N + 1$ places for a contact: contact $i$ lies
between beads $i - 1$ and $i$, so contact $0$ is to the left of the first bead and contact $N$
to the right of the last. What is found at those two places is the boundary condition, and this
is the only file that decides it:

        free       .   o---o---o   .        contacts 1 .. N-1
        fixed      |---o---o---o---|        0 and N lead to a wall, a bead that never moves
        periodic   (---o---o---o---)        0 and N are one contact, between last and first bead

Forces, energies, second derivatives and the search for contacts that open or close all ask the
same three questions: is there a contact, how far is it stretched, and which stiffness belongs to
it? */

#include <cstddef>

#include "lattice/numerics/ieee.hpp"

namespace lattice {

/// What lies beyond the first and last bead: nothing, a rigid bead at rest, or the other end.
enum class Ends { free, fixed, periodic };

/// The names of the ends, in the order of `Ends`.
inline constexpr const char* ends_names[] = {"free", "fixed", "periodic"};

/**
Both ends of a chain obey the same condition, and yet `Boundary` stores one for each: a piece of a
chain that is computed by itself has a free end wherever it was cut, and the chain's own end elsewhere. */
struct Boundary {
  std::size_t sites = 0;                       ///< beads; contacts are numbered from 0 to `sites`
  Ends first = Ends::free, last = Ends::free;  ///< beyond the first and beyond the last bead

  /// The end at which contact `i` lies, for i = 0 and i = sites.
  Ends end_at(std::size_t i) const { return i == 0 ? first : last; }
  /// Whether contact `i` lies between two beads.
  bool inside(std::size_t i) const { return i > 0 && i < sites; }

  /// Whether contact `i` exists, 0 <= i <= sites, and acts on the bead or beads next to it.
  bool pushes(std::size_t i) const { return inside(i) || end_at(i) != Ends::free; }

  /// The same with every contact counted once, as a sum of energies needs it: contact 0 of a ring is
  /// its contact `sites`.
  bool counts(std::size_t i) const { return inside(i) || (pushes(i) && i == own(i)); }

  /// The index under which contact `i` has its stiffness.
  std::size_t own(std::size_t i) const { return i == 0 && first == Ends::periodic ? sites : i; }

  /// Stretch of contact `i`, q[i] - q[i - 1], where a wall counts as a bead at rest. `q` holds `sites`
  /// positions, or velocities or accelerations, whose differences follow the same rule.
  template <class T>
  T stretch(const T* q, std::size_t i) const {
    if (inside(i)) [[likely]]
      return q[i] - q[i - 1];
    if (end_at(i) == Ends::periodic) return q[0] - q[sites - 1];
    return i == 0 ? q[0] : -q[sites - 1];
  }
};

}  // namespace lattice
