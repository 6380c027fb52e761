#include "lattice/algebra/dense.ipp"

#include <Eigen/SVD>

namespace lattice {

template Vector<double> solve_square(const Matrix<double>&, const Vector<double>&);
template Vector<double> shortest_solution(const Matrix<double>&, const Vector<double>&, double,
                                          double);

Vector<double> least_squares(const Matrix<double>& matrix, const Vector<double>& right) {
  return matrix.colPivHouseholderQr().solve(right);
}

Eigen::Vector3d fit_columns(const Eigen::MatrixX3d& matrix, const Vector<double>& right) {
  return matrix.householderQr().solve(right);
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

}  // namespace lattice
