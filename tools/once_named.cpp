// What has its well or its whole chain chosen by name, compiled once (tools/once.hpp).

#include "once.hpp"

namespace lattice {
LATTICE_FLIGHTS(template, double, NamedWell, Hertz)
LATTICE_FLIGHTS(template, long double, NamedWell, Hertz)
LATTICE_ORBITS(template, double, NamedWell, Hertz)
LATTICE_ORBITS(template, long double, NamedWell, Hertz)
LATTICE_FAMILY(template, NamedWell)
LATTICE_CHOSEN(template)
}  // namespace lattice
