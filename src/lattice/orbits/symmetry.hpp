#pragma once
/**
# Symmetries as values

Periodic orbits are found by *shooting*: some entries of the initial state are unknown, the chain moves for a part of a
period, and certain combinations of entries must vanish when it ends. A symmetry of the orbit decides which entries,
which part and which combinations: it is a list of unknowns and a list of equations, both linear.

The state of $N$ sites is one vector of $2N$ entries, first the positions, then the velocities. A `Term`
is an entry with a sign, and a sum of terms is a `Combination`. */

#include <cstddef>
#include <string>
#include <vector>

#include "lattice/model/sites.hpp"

namespace lattice {

/// An entry of the state, by its index, with a sign.
struct Term {
  std::size_t index;
  double sign;  ///< 1 or -1
};
/// A sum of entries.
using Combination = std::vector<Term>;
/// Directions in phase space, each of them a column of the tangent map (tangent.hpp).
using Basis = std::vector<Combination>;

/// A sum of entries of the state at the end of the shooting segment (the part of the period that is computed)
/// and of the state at its start. It must vanish.
struct Equation {
  Combination end{}, start{};
};

/// All that Newton's method has to know of an orbit's symmetry.
struct Symmetry {
  std::string name;                   ///< for messages
  Basis unknowns{};                   ///< how the initial state depends on each unknown
  std::vector<Equation> equations{};  ///< what must vanish
  int parts = 1;                      ///< the segment lasts for the period over this number
  bool free_period = false;           ///< the period is the last unknown
  bool decays = true;                 ///< a localized orbit; its tail is scaled site by site
};

/**
## Static breathers

A breather that is even in time starts from rest, so that the positions are the only unknowns, and it is
even about $T_b/2$ as well. If the chain has no symmetry of its own (because of a defect, say), this is all
we have: $\dot y_n(T_b/2) = 0$, as many equations as sites, after half a period. */
Symmetry even_in_time(std::size_t sites);

/**
The article's bond-centred breathers obey $y_{1-n} = -y_n$, which holds at all times if it holds at the
start. So half of the positions are unknown, and half of the equations above remain.

The site-centred ones have a symmetry that is less easy to see. A mirror image of the motion is no motion
of the chain, because beads push and do not pull; but it is one if the signs are changed too. The article
finds these breathers invariant under $S'$, $y_n(t) \to -y_{-n}(t+T_b/2)$. Combined with evenness this
relates the times $T_b/4 \pm t$, and with the reflection $P : n \to -n$ it is enough that
$(1+P)\,y(T_b/4) = 0$ and $(1-P)\,\dot y(T_b/4) = 0$: as many equations as sites, after a quarter of a
period. */
/// That of a static breather with the given centre.
Symmetry centred(Centre centre, std::size_t sites);

/// The article's own: the start is at rest, and the whole state returns after the whole period. These are twice as many
/// equations as unknowns, to be solved in the sense of least squares.
Symmetry returning(std::size_t sites);

}  // namespace lattice
