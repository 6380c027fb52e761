#include "lattice/algebra/dense.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

namespace lattice {

template <class T>
Vector<T> solve_square(const Matrix<T>& matrix, const Vector<T>& right) {
  return matrix.partialPivLu().solve(right);
}

Vector<double> least_squares(const Matrix<double>& matrix, const Vector<double>& right) {
  return matrix.colPivHouseholderQr().solve(right);
}

template <class T>
Vector<T> shortest_solution(const Matrix<T>& matrix, const Vector<T>& right, double rank) {
  Eigen::CompleteOrthogonalDecomposition<Matrix<T>> shortest;
  if (rank > 0) shortest.setThreshold(T(rank));
  return shortest.compute(matrix).solve(right);
}

Softness condition_of(const Matrix<double>& matrix) {
  const Eigen::JacobiSVD<Matrix<double>> svd(matrix, Eigen::ComputeFullV);
  const auto& sizes = svd.singularValues();
  const Eigen::Index last = matrix.cols() - 1;
  return {sizes[0] / sizes[last], svd.matrixV().col(last)};
}

// The scalars that are used
template Vector<double> solve_square(const Matrix<double>&, const Vector<double>&);
template Vector<long double> solve_square(const Matrix<long double>&, const Vector<long double>&);
template Vector<double> shortest_solution(const Matrix<double>&, const Vector<double>&, double);
template Vector<long double> shortest_solution(const Matrix<long double>&,
                                               const Vector<long double>&, double);

}  // namespace lattice
