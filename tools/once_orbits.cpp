// Flights and orbits, compiled once (tools/once.hpp).

#include "once.hpp"

namespace lattice {
LATTICE_FLIGHTS(template, double, Quartic, Hertz)
LATTICE_FLIGHTS(template, long double, Quartic, Hertz)
LATTICE_FLIGHTS(template, double, Harmonic, Hertz)
LATTICE_ORBITS(template, double, Quartic, Hertz)
LATTICE_ORBITS(template, long double, Quartic, Hertz)
LATTICE_FAMILY(template, Quartic)
}  // namespace lattice
