// Dense algebra of Newton's method and of the multipliers, compiled once for all programs: Eigen's
// decompositions take longer to compile than a chapter. The headers work without this file as well;
// who defines LATTICE_COMPILED links it.

#include "lattice/orbits/floquet.hpp"

namespace lattice {

template Vector<double> solve_system(const Matrix<double>&, const Vector<double>&, double);
template Vector<long double> solve_system(const Matrix<long double>&, const Vector<long double>&,
                                          double);
template double symplectic_defect(const Matrix<double>&);
template long double symplectic_defect(const Matrix<long double>&);
template Matrix<double> pair_matrix(const Matrix<double>&);
template Matrix<long double> pair_matrix(const Matrix<long double>&);
template Pairs<double> pairs_of(const Matrix<double>&, const Vector<double>&);
template Pairs<long double> pairs_of(const Matrix<long double>&, const Vector<long double>&);
template std::vector<std::complex<double>> eigenvalues_of(const Matrix<double>&);
template std::vector<std::complex<long double>> eigenvalues_of(const Matrix<long double>&);

}  // namespace lattice
