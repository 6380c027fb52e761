// Eigen's decompositions, compiled once (tools/once.hpp).

#include "once.hpp"

namespace lattice {
LATTICE_DENSE(template, double)
LATTICE_DENSE(template, long double)
}  // namespace lattice
