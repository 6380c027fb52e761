#include "lattice/events/event_driven.ipp"

#include "lattice/model/precisions.hpp"

namespace lattice {

LATTICE_IN_EACH_PRECISION(LATTICE_FLOW)

}  // namespace lattice
