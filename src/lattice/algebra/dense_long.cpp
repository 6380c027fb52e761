// Apart from dense.cpp, since both number types at once would take the compiler a gigabyte
#include "lattice/algebra/dense.ipp"

namespace lattice {

template Vector<long double> solve_square(const Matrix<long double>&, const Vector<long double>&);
template Vector<long double> shortest_solution(const Matrix<long double>&,
                                               const Vector<long double>&, double, double);

}  // namespace lattice
