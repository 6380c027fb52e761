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
/// does not converge.
template <class T>
std::vector<std::complex<T>> eigenvalues_of(const Matrix<T>& matrix);

/// A vector of length one that `matrix` multiplies by its simple, real eigenvalue `value`.
template <class T>
Vector<T> eigenvector_of(const Matrix<T>& matrix, const T& value);

}  // namespace lattice
