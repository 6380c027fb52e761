#pragma once
/**
# Symmetries as values

A periodic orbit is found by shooting: some entries of the initial state are unknown, the chain
moves for a part of a period, and some combinations of entries must vanish at its end. Which
entries, which part and which combinations is what a symmetry of the orbit decides. This file
holds that knowledge, and nowhere else is it needed: a symmetry is a list of unknowns and a list
of equations, both linear, and Newton's method reads them off.

The state of $N$ sites is one vector of $2N$ entries, the positions and then the velocities. A
`Term` is an entry with a sign, a sum of terms is a `Combination`. */

#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "lattice/model/sites.hpp"

namespace lattice {

struct Term {
  std::size_t index;
  double sign;
};
using Combination = std::vector<Term>;
/// Directions in phase space, one a column.
using Basis = std::vector<Combination>;

/// A sum of entries at the end of the flight and of entries at its start, which must vanish.
struct Equation {
  Combination end{}, start{};
};

struct Symmetry {
  std::string name;
  std::size_t sites = 0;
  Basis unknowns{};  ///< how the initial state depends on each unknown
  std::vector<Equation> equations{};
  int parts = 1;             ///< the flight lasts for the period over this number
  bool free_period = false;  ///< the period is the last unknown
  bool decays = true;        ///< a localized orbit; its tail is scaled site by site
};

/**
## Static breathers

A breather that is even in time starts from rest, so that the positions are the only unknowns,
and it is even about $T_b/2$ as well. In a chain without any symmetry of its own (a defect, say)
this is all there is: $\dot y_n(T_b/2) = 0$, as many equations as sites. */
inline Symmetry even_in_time(std::size_t sites) {
  Symmetry s{.name = "time-even", .sites = sites, .parts = 2};
  for (std::size_t n = 0; n < sites; ++n) {
    s.unknowns.push_back({{n, 1}});
    s.equations.push_back({{{sites + n, 1}}});
  }
  return s;
}

/**
Around a bond $y_{1-n} = -y_n$ holds for all times once it holds at the start. Half of the
positions are unknown, and half of the equations above remain. */
inline Symmetry bond_centred(std::size_t sites) {
  Symmetry s{.name = "bond-centred", .sites = sites, .parts = 2};
  for (std::size_t n = sites / 2; n < sites; ++n) {
    s.unknowns.push_back({{n, 1}, {sites - 1 - n, -1}});
    s.equations.push_back({{{sites + n, 1}}});
  }
  return s;
}

/**
Around a site the orbit is invariant under $y_n(t) \to -y_{-n}(t+T_b/2)$. Combined with evenness
this relates the times $T_b/4 \pm t$, and with the reflection $P : n \to -n$ it is enough that
$(1+P)\,y(T_b/4) = 0$ and $(1-P)\,\dot y(T_b/4) = 0$: as many equations as sites, after a quarter of
a period. */
inline Symmetry site_centred(std::size_t sites) {
  Symmetry s{.name = "site-centred", .sites = sites, .parts = 4};
  for (std::size_t n = 0; n < sites; ++n) {
    const std::size_t mirror = sites - 1 - n;
    s.unknowns.push_back({{n, 1}});
    if (n >= sites / 2)
      s.equations.push_back({{{n, 1}, {mirror, 1}}});
    else
      s.equations.push_back({{{sites + n, 1}, {sites + mirror, -1}}});
  }
  return s;
}

/**
For comparison: the article asks of positions at rest that the whole state returns after the whole
period, twice as many equations as unknowns, solved in the sense of least squares. */
inline Symmetry returning(std::size_t sites) {
  Symmetry s{.name = "returning", .sites = sites};
  for (std::size_t n = 0; n < sites; ++n) s.unknowns.push_back({{n, 1}});
  for (std::size_t i = 0; i < 2 * sites; ++i) s.equations.push_back({{{i, 1}}, {{i, -1}}});
  return s;
}

/// The symmetry of a static breather with the given centre.
inline Symmetry centred(Centre centre, std::size_t sites) {
  return centre == Centre::bond ? bond_centred(sites) : site_centred(sites);
}

/**
## Travelling orbits

A motion that repeats itself $m$ sites further after the time $T$ obeys
$y_n(t+T) = y_{n-m}(t)$. All positions and velocities are unknown. On a ring the sites are counted
modulo $N$; on an open chain what comes from beyond its end is at rest. The equations allow a
shift in time, and Newton's step is the shortest one that solves them (see newton.hpp). With
$m = 0$ this is a periodic orbit without any symmetry. */
inline Symmetry travelling(std::size_t sites, std::size_t shift, bool ring,
                           bool free_period = false) {
  Symmetry s{.name = shift == 0 ? "periodic" : "travelling",
             .sites = sites,
             .free_period = free_period,
             .decays = !ring};
  for (std::size_t i = 0; i < 2 * sites; ++i) {
    const std::size_t half = i / sites * sites, n = i - half;
    s.unknowns.push_back({{i, 1}});
    Equation equation{{{i, 1}}, {}};
    if (n >= shift)
      equation.start = {{half + n - shift, -1}};
    else if (ring)
      equation.start = {{half + n + sites - shift, -1}};
    s.equations.push_back(equation);
  }
  return s;
}

/**
If the travelling orbit is also invariant under $y_n(t) \to -y_{-n}(-t)$, which fixes the origin of
time and removes the shift, its positions at $t = 0$ are odd and its velocities even in $n$. Together
with $y_n(t+T) = y_{n-1}(t)$ this relates the times $T/2 \pm t$ and the sites $n$ and $1-n$:
$$y_n + y_{1-n} = 0,\qquad \dot y_n - \dot y_{1-n} = 0 \qquad\text{at } t = T/2,\ n = 1,\dots,L+1.$$
The chain has the sites $-L \le n \le L+1$, the last of which begins at rest. With the unknowns
$y_1,\dots,y_L$, $\dot y_0,\dots,\dot y_L$ and $T$ there are as many equations as unknowns.

In a linear well $\sum_n(y_n + i\dot y_n)$ only turns. At $T = 2\pi k$ it returns, and the first
equations, $n = 1,\dots,L+1$, then add up to zero whatever the unknowns are. So where the period is
given, as $2\pi k$ in the linear well, we leave out the first one, and all is square again. */
inline Symmetry travelling_reversible(std::size_t reach, bool free_period) {
  const std::size_t n0 = reach, sites = 2 * reach + 2;
  Symmetry s{.name = "travelling", .sites = sites, .parts = 2, .free_period = free_period};
  for (std::size_t n = 1; n <= reach; ++n) s.unknowns.push_back({{n0 + n, 1}, {n0 - n, -1}});
  s.unknowns.push_back({{sites + n0, 1}});
  for (std::size_t n = 1; n <= reach; ++n)
    s.unknowns.push_back({{sites + n0 + n, 1}, {sites + n0 - n, 1}});
  for (std::size_t n = 1; n <= reach + 1; ++n) {
    if (n > 1 || free_period) s.equations.push_back({{{n0 + n, 1}, {n0 + 1 - n, 1}}});
    s.equations.push_back({{{sites + n0 + n, 1}, {sites + n0 + 1 - n, -1}}});
  }
  return s;
}

/**
## Blocks of perturbations

A reflection that maps an orbit to itself splits its perturbations into even and odd ones, which
the linearised flow does not mix. The columns of a block are $e_n \pm e_{mirror}$ for the right half
of the chain (and $e_n$ alone for a central site), first for positions and then for velocities; the
coefficients of a perturbation in the block are its entries on the right half. */
inline Basis mirror_block(std::size_t sites, double sign) {
  Basis basis;
  for (std::size_t half : {std::size_t(0), sites})
    for (std::size_t n = sites / 2; n < sites; ++n) {
      const std::size_t mirror = sites - 1 - n;
      if (mirror != n)
        basis.push_back({{half + n, 1}, {half + mirror, sign}});
      else if (sign > 0)
        basis.push_back({{half + n, 1}});
    }
  return basis;
}

/// All perturbations, in the order of the state's entries.
inline Basis all_directions(std::size_t sites) {
  Basis basis;
  for (std::size_t i = 0; i < 2 * sites; ++i) basis.push_back({{i, 1}});
  return basis;
}

}  // namespace lattice
