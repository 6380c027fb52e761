// The inner loops, compiled once (tools/once.hpp).

#include "once.hpp"

namespace lattice {
LATTICE_NAMED_LOOPS(template)
}  // namespace lattice
