#include "lattice/gsl/reference.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "lattice/integrators/refinement.hpp"

namespace lattice {

std::size_t evolve_reference(const Chain& chain, State<double>& state, double duration,
                             const Tolerance& tolerance) {
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

double distance_from_reference(const Chain& chain, State<double> start, double duration,
                               const State<double>& end, double bound) {
  evolve_reference(chain, start, duration, 1e-13);
  start.t = end.t;
  const double apart = distance(start, end);
  if (apart < bound) return apart;
  std::ostringstream text;
  text << "our integrator and GSL's disagree by " << apart << " (allowed: " << bound << ")";
  throw std::runtime_error(text.str());
}

}  // namespace lattice
