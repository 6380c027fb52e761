#pragma once
/**
# Symmetries as values

The article's breathers are periodic orbits of the chain (chain.hpp): vibrations that repeat themselves
after a period $T_b = 2\pi/\omega_b$. We find them by *shooting*: some entries of the initial state are
unknown, the chain moves for a part of a period, and certain combinations of entries must vanish when it
ends. Which entries, which part and which combinations is decided by the symmetry of the orbit. All that
knowledge is in this file: a symmetry is a list of unknowns and a list of equations, both linear, from
which Newton's method (newton.hpp) takes what it needs.

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
  std::string name;  ///< for messages
  std::size_t sites = 0;
  Basis unknowns{};                   ///< how the initial state depends on each unknown
  std::vector<Equation> equations{};  ///< what must vanish
  int parts = 1;                      ///< the flight lasts for the period over this number
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
start. So half of the positions are unknown, and half of the equations above remain. */
Symmetry bond_centred(std::size_t sites);

/**
The site-centred ones have a symmetry that is less easy to see. A mirror image of the motion is no motion
of the chain, because beads push and do not pull; but it is one if the signs are changed too. The article
finds these breathers invariant under $S'$, $y_n(t) \to -y_{-n}(t+T_b/2)$. Combined with evenness this
relates the times $T_b/4 \pm t$, and with the reflection $P : n \to -n$ it is enough that
$(1+P)\,y(T_b/4) = 0$ and $(1-P)\,\dot y(T_b/4) = 0$: as many equations as sites, after a quarter of a
period. */
Symmetry site_centred(std::size_t sites);

/**
The article proceeds differently, and for comparison we can do the same: it starts from rest and requires
that the whole state return after the whole period. These are twice as many equations as unknowns, to be
solved in the sense of least squares. */
Symmetry returning(std::size_t sites);

/// The symmetry of a static breather with the given centre.
Symmetry centred(Centre centre, std::size_t sites);

/**
## Travelling orbits

A motion that repeats itself $m$ sites further on (`shift`) after the time $T$ obeys
$y_n(t+T) = y_{n-m}(t)$. All positions and velocities are unknown. On a ring the sites are counted
modulo $N$; in an open chain what comes from beyond its end is at rest. The equations still allow a shift
in time, so Newton's step is the shortest one that solves them (newton.hpp). With $m = 0$ this is a
periodic orbit without any symmetry. */
Symmetry travelling(std::size_t sites, std::size_t shift, bool ring, bool free_period = false);

/**
Some travelling orbits are also invariant under $y_n(t) \to -y_{-n}(-t)$. This fixes the origin of time, so
that no shift is left: at $t = 0$ positions are odd and velocities even in $n$. Together with
$y_n(t+T) = y_{n-1}(t)$ it relates the times $T/2 \pm t$ and the sites $n$ and $1-n$:
$$y_n + y_{1-n} = 0,\qquad \dot y_n - \dot y_{1-n} = 0 \qquad\text{at } t = T/2,\ n = 1,\dots,L+1.$$
The chain has the sites $-L \le n \le L+1$ with $L$ = `reach`, and the last one begins at rest. With the
unknowns $y_1,\dots,y_L$, $\dot y_0,\dots,\dot y_L$ and $T$ there are as many equations as unknowns.

If $T$ is given there is one equation too many. We leave out the first one, that of the positions of 0
and 1. In linear wells and at $T = 2\pi k$ nothing is lost by this: there $\sum_n(y_n + i\dot y_n)$ is
imaginary at the start, only turns, and is imaginary again at $T/2$, so that the $L+1$ equations for
positions add up to zero whatever the unknowns are (travelling.hpp has more on this sum). */
Symmetry travelling_reversible(std::size_t reach, bool free_period);

}  // namespace lattice
