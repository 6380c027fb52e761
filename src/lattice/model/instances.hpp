// Included at the end of a `.cpp`, inside the namespace, after LATTICE_INSTANCES(T) has listed what there
// is for a number type T. The library is compiled in double and extended precision; where there is Boost
// the same files are compiled once more, in quadruple precision alone (numbers/extended.hpp).
#ifdef LATTICE_QUADRUPLE
LATTICE_INSTANCES(Quadruple)
#else
LATTICE_INSTANCES(double)
LATTICE_INSTANCES(long double)
#endif
#undef LATTICE_INSTANCES
