#include "lattice/orbits/linear.hpp"

#include <stdexcept>
#include <type_traits>

namespace lattice {

template <class T>
Vector<T> solve_system(const Matrix<T>& matrix, const Vector<T>& right, double rank) {
  if (matrix.rows() == matrix.cols() && rank <= 0) return solve_square(matrix, right);
  if constexpr (std::is_floating_point_v<T>) {
    return shortest_solution(matrix, right, rank);
  } else {
    throw std::logic_error("this type solves as many equations as unknowns, no others");
  }
}

#define LATTICE_INSTANCES(T) \
  template Vector<T> solve_system<T>(const Matrix<T>&, const Vector<T>&, double);
#include "lattice/model/instances.hpp"

}  // namespace lattice
