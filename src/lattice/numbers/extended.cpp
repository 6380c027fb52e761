#include "lattice/numbers/extended.hpp"

#include <Eigen/LU>

namespace lattice {

template <>
Vector<Quadruple> solve_square(const Matrix<Quadruple>& matrix, const Vector<Quadruple>& right) {
  return matrix.partialPivLu().solve(right);
}

}  // namespace lattice
