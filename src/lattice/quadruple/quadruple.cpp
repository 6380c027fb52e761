#include "lattice/quadruple/quadruple.hpp"

#include <Eigen/LU>

namespace lattice {

template <>
Vector<Quadruple> solve_square(const Matrix<Quadruple>& matrix, const Vector<Quadruple>& right) {
  return matrix.partialPivLu().solve(right);
}

template <>
Vector<FiftyDigits> solve_square(const Matrix<FiftyDigits>& matrix,
                                 const Vector<FiftyDigits>& right) {
  return matrix.partialPivLu().solve(right);
}

}  // namespace lattice
