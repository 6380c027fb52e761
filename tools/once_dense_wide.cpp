// Eigen's decompositions in wider types, compiled once (tools/once.hpp).

#include "once.hpp"

namespace lattice {
LATTICE_DENSE(template, long double)
}  // namespace lattice
