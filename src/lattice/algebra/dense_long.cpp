#define LATTICE_LONG
#include "dense.cpp"
