#pragma once
/**
# Dense matrices

Eigen's solvers, in `double` and `long double` (and quadruple precision where quadruple.hpp says so). They take the compiler a
quarter of a minute each, so they are compiled once. */

#include <Eigen/Core>
#include <complex>
#include <vector>

#include "lattice/numerics/ieee.hpp"

namespace lattice {

/// Dense vectors and matrices of any number type.
template <class T>
using Vector = Eigen::Matrix<T, Eigen::Dynamic, 1>;
template <class T>
using Matrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;

/// The solution of matrix * x = right for a square, regular matrix.
template <class T>
Vector<T> solve_square(const Matrix<T>& matrix, const Vector<T>& right);

/// The x for which the norm of matrix * x - right is least; the columns of `matrix` are independent.
Vector<double> least_squares(const Matrix<double>& matrix, const Vector<double>& right);

/// The same for three columns that are far from dependent, which need not be exchanged.
Eigen::Vector3d fit_columns(const Eigen::MatrixX3d& matrix, const Vector<double>& right);

/// The shortest x for which the norm of matrix * x - right is least. A direction counts as free if its singular value,
/// relative to the largest or to `scale` if that is more, is below `rank`; zero stands for the rounding errors.
template <class T>
Vector<T> shortest_solution(const Matrix<T>& matrix, const Vector<T>& right, double rank = 0,
                            double scale = 0);

/// How unequally a matrix changes what it multiplies.
struct Softness {
  double condition;        ///< largest over smallest singular value
  Vector<double> softest;  ///< the unit vector that it shrinks most
};

/// Of a matrix with independent columns, from its singular values; it may have more rows than columns.
Softness condition_of(const Matrix<double>& matrix);

/// All eigenvalues of a square matrix, in Eigen's order. Throws std::runtime_error where the iteration
/// does not converge.
template <class T>
std::vector<std::complex<T>> eigenvalues_of(const Matrix<T>& matrix);

}  // namespace lattice
