#pragma once
/// Eigenvalues of matrices without a structure that we could use.

#include <complex>
#include <vector>

#include "lattice/algebra/dense.hpp"

namespace lattice {

/// All eigenvalues of a square matrix, in Eigen's order. Throws std::runtime_error where the iteration
/// does not converge.
template <class T>
std::vector<std::complex<T>> eigenvalues_of(const Matrix<T>& matrix);

}  // namespace lattice
