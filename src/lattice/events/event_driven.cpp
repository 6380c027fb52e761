#include "lattice/events/event_driven.ipp"

#include "lattice/events/location.ipp"
#include "lattice/events/tangent.ipp"
#include "lattice/model/precisions.hpp"

namespace lattice {

LATTICE_IN_EACH_PRECISION(LATTICE_TANGENT)
LATTICE_IN_EACH_PRECISION(LATTICE_LEAPFROG)
LATTICE_IN_EACH_PRECISION(LATTICE_FLOW)

}  // namespace lattice
