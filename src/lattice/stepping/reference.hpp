#pragma once
/**
# The chain by an independent route

Our own steppers are compared with a program that shares nothing with them but the forces: the chain of
beads integrated by the GNU Scientific Library (gsl_ode.hpp). */

#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "lattice/model/chain.hpp"
#include "lattice/numbers/gsl_ode.hpp"
#include "lattice/stepping/accuracy.hpp"

namespace lattice {

/**
`evolve_reference` carries `state` forward by `duration` with the given local tolerance and returns the
number of force evaluations. Throws std::runtime_error if GSL cannot go on. */
template <class Onsite, class Contact>
std::size_t evolve_reference(const Chain<Onsite, Contact>& chain, State<double>& state,
                             double duration, const Tolerance& tolerance) {
  const std::size_t n = chain.sites;
  std::vector<double> x(state.y);
  x.insert(x.end(), state.v.begin(), state.v.end());
  Reference reference(
      [&chain, n](double, const double* z, double* dz) {
        Window all{0, n};
        std::copy(z + n, z + 2 * n, dz);
        accelerate(chain, z, dz + n, all);
      },
      2 * n, tolerance);
  double t = state.t;
  reference.advance(t, state.t + duration, x);
  std::copy_n(x.begin(), n, state.y.begin());
  std::copy_n(x.begin() + std::ptrdiff_t(n), n, state.v.begin());
  state.t = t;
  return reference.evaluations();
}

/**
A chapter asks it whether a state that our own stepper has reached is right. The local tolerance is so small
that GSL's own error does not matter. */
/// The `distance` (accuracy.hpp) of `end` from where GSL arrives that leaves `start` for `duration`.
/// Throws std::runtime_error unless it is below `bound`.
template <class Onsite, class Contact>
double distance_from_reference(const Chain<Onsite, Contact>& chain, State<double> start,
                               double duration, const State<double>& end, double bound) {
  evolve_reference(chain, start, duration, 1e-13);
  start.t = end.t;
  const double apart = distance(start, end);
  if (apart < bound) return apart;
  std::ostringstream text;
  text << "our integrator and GSL's disagree by " << apart << " (allowed: " << bound << ")";
  throw std::runtime_error(text.str());
}

}  // namespace lattice
