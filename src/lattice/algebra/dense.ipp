#pragma once
#include "lattice/algebra/dense.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>

namespace lattice {

template <class T>
Vector<T> solve_square(const Matrix<T>& matrix, const Vector<T>& right) {
  return matrix.partialPivLu().solve(right);
}

template <class T>
Vector<T> shortest_solution(const Matrix<T>& matrix, const Vector<T>& right, double rank,
                            double scale) {
  Eigen::CompleteOrthogonalDecomposition<Matrix<T>> shortest;
  if (rank > 0) {
    const T largest = matrix.colwise().norm().maxCoeff();
    shortest.setThreshold(T(rank) * std::max(T(1), T(scale) / largest));
  }
  return shortest.compute(matrix).solve(right);
}

}  // namespace lattice
