#pragma once
/**
# Dense matrices

Newton's method solves linear systems, for matrices of at most a few hundred rows and in several number
types. Eigen does it, here under the names that we use, in `double` and `long double` (and quadruple
precision where extended.hpp says so). Its solvers take the compiler a quarter of a minute each, so they are
compiled once, these here and those of eigenvalues.hpp. */

#include <Eigen/Core>

#include "lattice/numerics/ieee.hpp"

namespace lattice {

/// Dense vectors and matrices of any number type.
template <class T>
using Vector = Eigen::Matrix<T, Eigen::Dynamic, 1>;
template <class T>
using Matrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;

/**
Elimination with row exchanges is enough where there are as many equations as unknowns. */
/// The solution of matrix * x = right for a square, regular matrix.
template <class T>
Vector<T> solve_square(const Matrix<T>& matrix, const Vector<T>& right);

/**
With more equations than unknowns we take the solution of least squares. */
/// The x for which the norm of matrix * x - right is least; the columns of `matrix` are independent.
Vector<double> least_squares(const Matrix<double>& matrix, const Vector<double>& right);

/**
Where the equations leave a direction free, as Newton's method along a family of orbits does, the step is the
shortest one that solves them in the sense of least squares. */
/// The shortest x for which the norm of matrix * x - right is least. A direction counts as free if its
/// singular value, relative to the largest, is below `rank`; zero stands for the rounding errors.
template <class T>
Vector<T> shortest_solution(const Matrix<T>& matrix, const Vector<T>& right, double rank = 0);

/// How unequally a matrix changes what it multiplies.
struct Softness {
  double condition;        ///< largest over smallest singular value
  Vector<double> softest;  ///< the unit vector that it shrinks most
};

/// Of a matrix with independent columns, from its singular values; it may have more rows than columns.
Softness condition_of(const Matrix<double>& matrix);

}  // namespace lattice
