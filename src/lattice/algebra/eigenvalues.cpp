#include "lattice/algebra/eigenvalues.hpp"

#include <Eigen/Eigenvalues>
#include <stdexcept>

#include "lattice/numerics/progress.hpp"

namespace lattice {

namespace {
/// A stage that cannot be counted.
template <class Matrix>
Progress stage_of(const Matrix& matrix) {
  return Progress("eigenvalues of a matrix of " + std::to_string(matrix.rows()) + " rows");
}

template <class Solver>
const Solver& converged(const Solver& solver) {
  if (solver.info() != Eigen::Success)
    throw std::runtime_error("the eigenvalues of a matrix did not converge");
  return solver;
}
}  // namespace

template <class T>
std::vector<std::complex<T>> eigenvalues_of(const Matrix<T>& matrix) {
  const Progress stage = stage_of(matrix);
  const Eigen::EigenSolver<Matrix<T>> solver(matrix, false);
  return {converged(solver).eigenvalues().begin(), solver.eigenvalues().end()};
}

std::vector<std::complex<double>> eigenvalues_of(const Matrix<std::complex<double>>& matrix) {
  const Progress stage = stage_of(matrix);
  const Eigen::ComplexEigenSolver<Matrix<std::complex<double>>> solver(matrix, false);
  return {converged(solver).eigenvalues().begin(), solver.eigenvalues().end()};
}

template <class T>
Eigenpairs<T> eigenpairs_of(const Matrix<T>& matrix) {
  const Progress stage = stage_of(matrix);
  const Eigen::EigenSolver<Matrix<T>> solver(matrix);
  return {{converged(solver).eigenvalues().begin(), solver.eigenvalues().end()},
          solver.eigenvectors().real()};
}

// The scalars that are used
template std::vector<std::complex<double>> eigenvalues_of(const Matrix<double>&);
template std::vector<std::complex<long double>> eigenvalues_of(const Matrix<long double>&);
template Eigenpairs<double> eigenpairs_of(const Matrix<double>&);
template Eigenpairs<long double> eigenpairs_of(const Matrix<long double>&);

}  // namespace lattice
