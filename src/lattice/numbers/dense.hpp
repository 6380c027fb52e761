#pragma once
/**
# Dense matrices

Newton's method solves linear systems and stability is decided by eigenvalues, for matrices of at most a
few hundred rows and in several number types. Eigen does both, here under the names that we use, in
`double` and `long double` (and quadruple precision where extended.hpp says so). */

#include <Eigen/Core>
#include <complex>
#include <vector>

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
Where a matrix has no structure that we could use, all of its eigenvalues are computed. */
/// All eigenvalues of a square matrix, in Eigen's order. Throws std::runtime_error where the iteration
/// does not converge.
template <class T>
std::vector<std::complex<T>> eigenvalues_of(const Matrix<T>& matrix);

/// The same for a complex matrix.
std::vector<std::complex<double>> eigenvalues_of(const Matrix<std::complex<double>>& matrix);

}  // namespace lattice
