#define LATTICE_LONG
#include "dense.cpp"  // NOLINT(bugprone-suspicious-include)
