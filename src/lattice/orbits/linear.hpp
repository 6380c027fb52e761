#pragma once
/**
# The linear problem of orbits

Newton's method (newton.hpp) needs the solution of a linear system even where a direction is left free. */

#include "lattice/algebra/dense.hpp"

namespace lattice {

/**
If there are as many equations as unknowns the system is solved as it stands. Otherwise, or if the problem
leaves a direction free, the step is the shortest one that solves the equations in the sense of least
squares. A direction counts as free if its singular value, relative to the largest, is below `rank`, if
that is positive. Least squares need a built-in type; others throw std::logic_error. */
/// The x with matrix * x = right in that sense.
template <class T>
Vector<T> solve_system(const Matrix<T>& matrix, const Vector<T>& right, double rank = 0);

}  // namespace lattice
