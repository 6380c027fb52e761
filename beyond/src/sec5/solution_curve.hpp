#pragma once
/**
# A curve of solutions, and its fold

Equations with one unknown more than there are equations, the last one being a parameter, have a curve of solutions.
Where two of them merge as the parameter grows the curve folds back, and cannot be followed in the parameter. So it is
followed in its own length (pseudo-arclength): each point is found by Newton's method on a plane across the tangent. */

#include <functional>
#include <vector>

#include "lattice/orbits/newton.hpp"

namespace lattice {

/// Points from zero on, with the length of the way to each; `fold` is the largest parameter, from a parabola.
struct SolutionCurve {
  std::vector<Vector<double>> points{};
  std::vector<double> length{};
  double fold = 0;
};

/// What the equations leave at x.
using Residual = std::function<Vector<double>(const Vector<double>& x)>;

/// Follows the solutions of residual(x) = 0, of which x = 0 of `unknowns` entries is one, in the direction of the
/// parameter: the first point at the distance `first`, the others `apart`, in units of `unit`, until the parameter has
/// fallen to the share `beyond` of the fold. Throws NewtonFailed, and std::runtime_error without a fold.
SolutionCurve follow_solutions(const Residual& residual, Eigen::Index unknowns, double first,
                               double apart, double unit, double beyond);

}  // namespace lattice
