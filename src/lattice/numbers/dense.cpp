#include "lattice/numbers/dense.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <stdexcept>

namespace lattice {

template <class T>
Vector<T> solve_square(const Matrix<T>& matrix, const Vector<T>& right) {
  return matrix.partialPivLu().solve(right);
}

Vector<double> least_squares(const Matrix<double>& matrix, const Vector<double>& right) {
  return matrix.colPivHouseholderQr().solve(right);
}

template <class T>
std::vector<std::complex<T>> eigenvalues_of(const Matrix<T>& matrix) {
  const Eigen::EigenSolver<Matrix<T>> solver(matrix, false);
  if (solver.info() != Eigen::Success)
    throw std::runtime_error("the eigenvalues of a matrix did not converge");
  return {solver.eigenvalues().begin(), solver.eigenvalues().end()};
}

std::vector<std::complex<double>> eigenvalues_of(const Matrix<std::complex<double>>& matrix) {
  const Eigen::ComplexEigenSolver<Matrix<std::complex<double>>> solver(matrix, false);
  if (solver.info() != Eigen::Success)
    throw std::runtime_error("the eigenvalues of a complex matrix did not converge");
  return {solver.eigenvalues().begin(), solver.eigenvalues().end()};
}

// The scalars that are used
template Vector<double> solve_square(const Matrix<double>&, const Vector<double>&);
template Vector<long double> solve_square(const Matrix<long double>&, const Vector<long double>&);
template std::vector<std::complex<double>> eigenvalues_of(const Matrix<double>&);
template std::vector<std::complex<long double>> eigenvalues_of(const Matrix<long double>&);

}  // namespace lattice
