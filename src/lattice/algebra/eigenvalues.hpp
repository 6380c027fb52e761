#pragma once
/**
# Eigenvalues

Stability is decided by eigenvalues. Where a matrix has no structure that we could use, all of them are
computed, by Eigen, in the order in which it finds them. */

#include <complex>
#include <vector>

#include "lattice/algebra/dense.hpp"

namespace lattice {

/// All eigenvalues of a square matrix, in Eigen's order. Throws std::runtime_error where the iteration
/// does not converge, as all functions here.
template <class T>
std::vector<std::complex<T>> eigenvalues_of(const Matrix<T>& matrix);

/// The same for a complex matrix.
std::vector<std::complex<double>> eigenvalues_of(const Matrix<std::complex<double>>& matrix);

/// Eigenvalues of a real matrix in Eigen's order, and the real parts of their vectors as columns.
template <class T>
struct Eigenpairs {
  std::vector<std::complex<T>> values;
  Matrix<T> vectors;
};

/// All of them.
template <class T>
Eigenpairs<T> eigenpairs_of(const Matrix<T>& matrix);

}  // namespace lattice
