#include "lattice/quadruple/quadruple.hpp"

#include "lattice/algebra/dense.ipp"

namespace lattice {

template Vector<Quadruple> solve_square(const Matrix<Quadruple>&, const Vector<Quadruple>&);

}  // namespace lattice
