#include "lattice/events/location.ipp"

#include "lattice/model/precisions.hpp"

namespace lattice {

LATTICE_IN_EACH_PRECISION(LATTICE_LEAPFROG)

}  // namespace lattice
