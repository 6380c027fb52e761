// Included at the end of a `.cpp`, inside the namespace, after LATTICE_INSTANCES(T) has listed what there
// is for a number type T: in double and, but for the browser, in extended precision. A few files are
// compiled once more in quadruple precision, which needs Boost (CMakeLists.txt, quadruple/quadruple.hpp).
#ifdef LATTICE_QUADRUPLE
LATTICE_INSTANCES(Quadruple)
#else
LATTICE_INSTANCES(double)
#ifndef __wasm__
LATTICE_INSTANCES(long double)
#endif
#endif
#undef LATTICE_INSTANCES
