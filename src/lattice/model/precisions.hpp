#pragma once
// For sources whose functions have a number type: such a file defines LIST(T), their explicit instantiations, and ends
// with LATTICE_IN_EACH_PRECISION(LIST): in double and, but for the browser, in extended precision. What exists in
// quadruple precision, too, is in an .ipp, which quadruple/orbits.cpp includes.
#include "lattice/numerics/ieee.hpp"

#ifdef __wasm__
#define LATTICE_IN_EACH_PRECISION(LIST) LIST(double)
#else
#define LATTICE_IN_EACH_PRECISION(LIST) LIST(double) LIST(long double)
#endif
