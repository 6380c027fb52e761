// Eigen's decompositions in double precision, compiled once (tools/once.hpp).

#include "once.hpp"

namespace lattice {
LATTICE_DENSE(template, double)
LATTICE_DOUBLE(template)
}  // namespace lattice
