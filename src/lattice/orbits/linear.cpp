#include "lattice/orbits/linear.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <stdexcept>
#include <type_traits>

namespace lattice {

template <class T>
Vector<T> solve_system(const Matrix<T>& matrix, const Vector<T>& right, double rank) {
  if (matrix.rows() == matrix.cols() && rank <= 0) return solve_square(matrix, right);
  if constexpr (std::is_floating_point_v<T>) {
    Eigen::CompleteOrthogonalDecomposition<Matrix<T>> shortest;
    if (rank > 0) shortest.setThreshold(T(rank));
    return shortest.compute(matrix).solve(right);
  } else {
    throw std::logic_error("this type solves as many equations as unknowns, no others");
  }
}

#ifndef LATTICE_QUADRUPLE
template <class T>
Eigenpairs<T> eigenpairs_of(const Matrix<T>& matrix) {
  const Eigen::EigenSolver<Matrix<T>> solver(matrix);
  if (solver.info() != Eigen::Success) throw std::runtime_error("no eigenvalues");
  return {{solver.eigenvalues().begin(), solver.eigenvalues().end()}, solver.eigenvectors().real()};
}

template Eigenpairs<double> eigenpairs_of(const Matrix<double>&);
#ifndef __wasm__
template Eigenpairs<long double> eigenpairs_of(const Matrix<long double>&);
#endif
#endif

#define LATTICE_INSTANCES(T) \
  template Vector<T> solve_system<T>(const Matrix<T>&, const Vector<T>&, double);
#include "lattice/model/instances.hpp"

}  // namespace lattice
