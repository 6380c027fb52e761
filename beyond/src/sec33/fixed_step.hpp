#pragma once
/**
# A chain seen through a map of fixed steps

Whoever integrates a chain with a fixed step and takes no notice of its contacts computes with another system: a
*map*, the step of the method, which approximates the flow. Breathers, multipliers and thresholds can all be
computed of the map instead of the flow. This file does so for every method that schemes.hpp can write as a
Runge-Kutta-Nystrom scheme. */

#include <array>
#include <cstddef>
#include <functional>

#include "lattice/algebra/dense.hpp"
#include "lattice/integrators/schemes.hpp"
#include "lattice/model/chain.hpp"
#include "lattice/orbits/breather.hpp"
#include "sec33/kick.hpp"

namespace lattice {

/**
`steps` steps make one period of the breather, so that they are *commensurate* with it: every contact opens and closes at
the same place within a step, in every period. */
struct FixedStep {
  Chain chain;
  Nystrom method;
  std::size_t steps = 0;  ///< in a period
  double period = 0;      ///< of the breather
};

/// Carries `state` over `count` periods.
void carry(const FixedStep& map, State<double>& state, std::size_t count = 1);

/**
With variational equations the derivative of the map is exact: the same stages with linearised forces. A program
without them takes difference quotients, in each of which one entry of the state is larger by `increment` times
the largest position; an increment of zero stands for the exact derivative. */
/// The derivative of one period with respect to the first `count` entries of the state, positions first.
Matrix<double> derivative(const FixedStep& map, const State<double>& start, std::size_t count,
                          double increment);

/**
## Breathers of the map

The article solves $Y(T_b) = Y(0)$ for the positions, the velocities being zero: twice as many equations as unknowns,
in the sense of least squares. It prints the residual and the last step, both relative to the largest position.
A map that loses energy has no periodic orbit, and then a residual remains however small the step becomes.

A shift along the chain hardly violates the equations. Where they cannot be met, plain least squares runs away in
that direction; `rank` (linear.hpp) leaves it alone. */
struct MapBreather {
  State<double> start;
  double residual = 0, variation = 0;  ///< by how much it fails to close, and the last step
};

/// How the equations are solved: `increment` of the difference quotients, exact derivatives if zero.
struct GaussNewton {
  int iterations = 5;
  double increment = 0, rank = 0;  ///< the rank as in linear.hpp
};

/// Five iterations, as printed, or as many as `how` says; whether they converge is the question.
MapBreather find_breather(const FixedStep& map, State<double> guess, const GaussNewton& how);

/**
## Where the stability changes

The four eigenvalues next to $+1$ say by the sign of their symmetric function $\kappa$ (floquet.hpp) whether the
pinning pair is off the circle. In three wells $\kappa$ makes a parabola in the anharmonicity, whose zero in $[-1, 1]$
is what a plot of multipliers would show. */
/// The zero of the parabola through `kappa` at s = -1, 0, 1, the one nearest to zero; nan without one.
double zero_in_wells(const std::array<double, 3>& kappa);

/**
## What a kick does

The centre of a kicked breather is looked at once in `every` periods, always at the same phase. A kick frees it if
it gets well beyond the next site before it turns round (depinning.hpp). */
/// The path of the centre, until `stop(path)` or `periods` are over.
Creep path_of(const FixedStep& map, State<double> state, std::size_t periods, std::size_t every,
              const std::function<bool(const Creep&)>& stop);

/// Whether the centre is `sites` from its start, by half a site more or less, at every look from the time
/// `since` on; false for a path that does not lead so far.
bool stays_away(const Creep& path, double sites, double since);

/// Whether the breather at rest in `start` gets free within `periods` after a kick of size `c`.
bool frees(const FixedStep& map, const State<double>& start, double c, std::size_t periods);

}  // namespace lattice
