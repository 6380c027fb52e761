#include "lattice/algebra/dense.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "lattice/numerics/progress.hpp"

namespace lattice {

namespace {
// The two eigenvalues of a block that the real Schur form leaves where they are complex: p + q +- iz
template <class T>
std::complex<T> upper_of(const Eigen::Ref<const Matrix<T>>& block) {
  const T q = block(1, 1), p = T(0.5) * (block(0, 0) - q);
  // Divided by the largest of the three, so that no square overflows
  const T size = std::max(std::abs(p), std::max(std::abs(block(1, 0)), std::abs(block(0, 1))));
  const T low = block(1, 0) / size, high = block(0, 1) / size, middle = p / size;
  return {q + p, size * std::sqrt(std::abs(middle * middle + low * high))};
}
}  // namespace

// Eigen's solver would also prepare vectors, which takes the compiler as long again
template <class T>
std::vector<std::complex<T>> eigenvalues_of(const Matrix<T>& matrix) {
  const Progress stage("eigenvalues of a matrix of " + std::to_string(matrix.rows()) + " rows");
  const Eigen::Index n = matrix.rows();
  const T size = n ? matrix.cwiseAbs().maxCoeff() : T(0);
  if (size < std::numeric_limits<T>::min()) return std::vector<std::complex<T>>(std::size_t(n));
  const Eigen::HessenbergDecomposition<Matrix<T>> hessenberg(matrix / size);
  const Matrix<T> reduced = hessenberg.matrixH();
  Eigen::RealSchur<Matrix<T>> schur(n);
  schur.computeFromHessenberg(reduced, reduced, false);
  if (schur.info() != Eigen::Success)
    throw std::runtime_error("the eigenvalues of a matrix did not converge");
  const Matrix<T> form = size * schur.matrixT();
  std::vector<std::complex<T>> values;
  for (Eigen::Index i = 0; i < n; ++i) {
    if (i == n - 1 || form(i + 1, i) == T(0)) {
      values.push_back(form(i, i));
    } else {
      values.push_back(upper_of<T>(form.block(i, i, 2, 2)));
      values.push_back(std::conj(values.back()));
      ++i;
    }
  }
  return values;
}

// The scalars that are used
template std::vector<std::complex<double>> eigenvalues_of(const Matrix<double>&);
template std::vector<std::complex<long double>> eigenvalues_of(const Matrix<long double>&);

}  // namespace lattice
