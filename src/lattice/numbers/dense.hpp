#pragma once
/**
# Dense matrices

Newton's method solves linear systems and stability is decided by eigenvalues, for matrices of at most a
few hundred rows and in several number types. Eigen does both; here are the names that we use for it. */

#include <Eigen/Dense>
#include <complex>
#include <stdexcept>
#include <vector>

namespace lattice {

template <class T>
using Vector = Eigen::Matrix<T, Eigen::Dynamic, 1>;
template <class T>
using Matrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;

/**
Elimination with row exchanges serves where there are as many equations as unknowns. */
/// The solution of matrix * x = right for a square, regular matrix.
template <class T>
Vector<T> solve_square(const Matrix<T>& matrix, const Vector<T>& right) {
  return matrix.partialPivLu().solve(right);
}

/**
More equations than unknowns are met as well as possible. */
/// The x for which the norm of matrix * x - right is least; the columns of `matrix` are independent.
template <class T>
Vector<T> least_squares(const Matrix<T>& matrix, const Vector<T>& right) {
  return matrix.colPivHouseholderQr().solve(right);
}

/**
For matrices whose structure we do not use, all eigenvalues are computed. */
/// All eigenvalues of a square matrix, in Eigen's order. Throws std::runtime_error where the iteration
/// does not converge.
template <class T>
std::vector<std::complex<T>> eigenvalues_of(const Matrix<T>& matrix) {
  const Eigen::EigenSolver<Matrix<T>> solver(matrix, false);
  if (solver.info() != Eigen::Success)
    throw std::runtime_error("the eigenvalues of a matrix did not converge");
  return {solver.eigenvalues().begin(), solver.eigenvalues().end()};
}

/// The same for a complex matrix.
template <class T>
std::vector<std::complex<T>> eigenvalues_of(const Matrix<std::complex<T>>& matrix) {
  const Eigen::ComplexEigenSolver<Matrix<std::complex<T>>> solver(matrix, false);
  if (solver.info() != Eigen::Success)
    throw std::runtime_error("the eigenvalues of a complex matrix did not converge");
  return {solver.eigenvalues().begin(), solver.eigenvalues().end()};
}

}  // namespace lattice
