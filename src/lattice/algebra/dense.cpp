#include "lattice/algebra/dense.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <Eigen/SVD>

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

// One number type at a time (dense_long.cpp is the other): two at once take the compiler a gigabyte
#ifdef LATTICE_LONG
template Vector<long double> solve_square(const Matrix<long double>&, const Vector<long double>&);
template Vector<long double> shortest_solution(const Matrix<long double>&,
                                               const Vector<long double>&, double, double);
#else
template Vector<double> solve_square(const Matrix<double>&, const Vector<double>&);
template Vector<double> shortest_solution(const Matrix<double>&, const Vector<double>&, double,
                                          double);

Vector<double> least_squares(const Matrix<double>& matrix, const Vector<double>& right) {
  return matrix.colPivHouseholderQr().solve(right);
}

// The triangle of the elimination by reflections has the same singular values, and is square
Softness condition_of(const Matrix<double>& matrix) {
  const Eigen::Index n = matrix.cols();
  const auto reflections = matrix.colPivHouseholderQr();
  const Matrix<double> triangle =
      reflections.matrixR().topRows(n).template triangularView<Eigen::Upper>();
  const Eigen::JacobiSVD<Matrix<double>, Eigen::NoQRPreconditioner> svd(triangle,
                                                                        Eigen::ComputeFullV);
  const auto& sizes = svd.singularValues();
  return {sizes[0] / sizes[n - 1], reflections.colsPermutation() * svd.matrixV().col(n - 1)};
}
#endif

}  // namespace lattice
