#pragma once
/**
# The chain by an independent route

Our own steppers are compared with a program that shares nothing with them but the forces: the chain of
beads integrated by the GNU Scientific Library (gsl_ode.hpp). */

#include <cstddef>
#include <vector>

#include "lattice/model/chain.hpp"
#include "lattice/numbers/gsl_ode.hpp"

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

}  // namespace lattice
