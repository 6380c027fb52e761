#pragma once
/**
# The chain by an independent route

Our own steppers are compared with a program that shares nothing with them but the forces: the chain of
beads integrated by the GNU Scientific Library (gsl_ode.hpp). */

#include <cstddef>

#include "lattice/gsl/gsl_ode.hpp"
#include "lattice/model/chain.hpp"

namespace lattice {

/**
`evolve_reference` carries `state` forward by `duration` with the given local tolerance and returns the
number of force evaluations. Throws std::runtime_error if GSL cannot go on. */
std::size_t evolve_reference(const Chain& chain, State<double>& state, double duration,
                             const Tolerance& tolerance);

/**
It says whether a state that our own method has reached is right. The local tolerance is so small that GSL's
own error does not matter. */
/// The `distance` (refinement.hpp) of `end` from where GSL arrives that leaves `start` for `duration`.
/// Throws std::runtime_error unless it is below `bound`.
double distance_from_reference(const Chain& chain, State<double> start, double duration,
                               const State<double>& end, double bound);

}  // namespace lattice
