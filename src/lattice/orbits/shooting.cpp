#include "lattice/orbits/shooting.ipp"

#include "lattice/model/precisions.hpp"

namespace lattice {

LATTICE_IN_EACH_PRECISION(LATTICE_SHOOTING)

#ifndef __wasm__
// An orbit begins at one of double precision, or of extended precision
template Orbit<long double> newton<long double, long double>(const Shooting<long double>&,
                                                             const Orbit<long double>&,
                                                             const NewtonRule<long double>&);
#endif

}  // namespace lattice
