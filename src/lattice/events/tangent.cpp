#include "lattice/events/tangent.ipp"

#include "lattice/model/precisions.hpp"

namespace lattice {

LATTICE_IN_EACH_PRECISION(LATTICE_TANGENT)

}  // namespace lattice
