#pragma once
/**
# The linear problems of orbits

Newton's method (newton.hpp) needs the solution of a linear system even where a direction is left free, and
multipliers (floquet.hpp) need eigenvalues with their vectors. Both are in this file, apart from all that
knows of chains, because they take long to compile. */

#include <complex>
#include <vector>

#include "lattice/numbers/dense.hpp"

namespace lattice {

/**
If there are as many equations as unknowns the system is solved as it stands. Otherwise, or if the problem
leaves a direction free, the step is the shortest one that solves the equations in the sense of least
squares. A direction counts as free if its singular value, relative to the largest, is below `rank`, if
that is positive. Least squares need a built-in type; others throw std::logic_error. */
/// The x with matrix * x = right in that sense.
template <class T>
Vector<T> solve_system(const Matrix<T>& matrix, const Vector<T>& right, double rank = 0);

/// Eigenvalues of a real matrix in Eigen's order, and the real parts of their vectors as columns.
template <class T>
struct Eigenpairs {
  std::vector<std::complex<T>> values;
  Matrix<T> vectors;
};

/// All of them. Throws std::runtime_error if Eigen finds no eigenvalues.
template <class T>
Eigenpairs<T> eigenpairs_of(const Matrix<T>& matrix);

}  // namespace lattice
