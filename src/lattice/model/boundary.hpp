#pragma once
/**
# Where the chain ends

A chain of $N$ beads has $N + 1$ places for a contact: contact $i$ lies between the beads
$i - 1$ and $i$, so that contact $0$ is left of the first bead and contact $N$ right of the
last one. What is there is the boundary condition, and it is decided in this file only:

        free       .   o---o---o   .        contacts 1 .. N-1
        fixed      |---o---o---o---|        0 and N lead to a wall, a bead that never moves
        periodic   (---o---o---o---)        0 and N are one contact, between last and first bead

Forces, energies, curvatures, switchings and the tiles of a long run all ask the same three
questions: is there a contact, how far is it stretched, and which stiffness is its own. */

#include <cstddef>

namespace lattice {

/// What lies beyond the first and last bead: nothing, a rigid bead at rest, or the other end.
enum class Ends { free, fixed, periodic };

/// The names of the ends, in the order of `Ends`.
inline constexpr const char* ends_names[] = {"free", "fixed", "periodic"};

/**
The two ends of `sites` beads are kept apart, though those of a chain are alike: a tile of a chain that
is computed by itself has a free end wherever it was cut, and the chain's own end elsewhere. */
struct Boundary {
  std::size_t sites = 0;
  Ends first = Ends::free, last = Ends::free;

  Ends end_at(std::size_t i) const { return i == 0 ? first : last; }
  bool inside(std::size_t i) const { return i > 0 && i < sites; }

  /// Whether contact `i` exists and acts on the bead or beads next to it.
  bool pushes(std::size_t i) const { return inside(i) || end_at(i) != Ends::free; }

  /// The same with every contact counted once: contact 0 of a ring is its contact `sites`.
  bool counts(std::size_t i) const { return inside(i) || (pushes(i) && i == own(i)); }

  /// The index under which contact `i` has its stiffness.
  std::size_t own(std::size_t i) const { return i == 0 && first == Ends::periodic ? sites : i; }

  /// Stretch of contact `i`, q[i] - q[i - 1], where a wall counts as a bead at rest. `q` may as well
  /// be velocities or accelerations.
  template <class T>
  T stretch(const T* q, std::size_t i) const {
    if (inside(i)) [[likely]]
      return q[i] - q[i - 1];
    if (end_at(i) == Ends::periodic) return q[0] - q[sites - 1];
    return i == 0 ? q[0] : -q[sites - 1];
  }
};

}  // namespace lattice
