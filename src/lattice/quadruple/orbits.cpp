#include "lattice/quadruple/orbits.hpp"

#include "lattice/events/event_driven.ipp"
#include "lattice/events/location.ipp"
#include "lattice/events/tangent.ipp"
#include "lattice/integrators/integrate.ipp"
#include "lattice/model/chain.ipp"
#include "lattice/orbits/newton.ipp"
#include "lattice/orbits/shooting.ipp"

namespace lattice {

LATTICE_CHAIN(Quadruple)
LATTICE_STEPPING(Quadruple)
LATTICE_TANGENT(Quadruple)
LATTICE_LEAPFROG(Quadruple)
LATTICE_FLOW(Quadruple)
LATTICE_NEWTON(Quadruple)
LATTICE_SHOOTING(Quadruple)

template Orbit<Quadruple> newton<Quadruple, long double>(const Shooting<Quadruple>&,
                                                         const Orbit<long double>&,
                                                         const NewtonRule<Quadruple>&);

}  // namespace lattice
