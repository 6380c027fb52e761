#include "lattice/gsl/reference.hpp"

#include <gsl/gsl_errno.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "lattice/integrators/refinement.hpp"

namespace lattice {

Reference::Reference(Rhs rhs, std::size_t dimension, const Tolerance& tolerance)
    : rhs_(std::move(rhs)), system_{&Reference::call, nullptr, dimension, this} {
  gsl_set_error_handler_off();  // GSL would abort; its status is checked below
  driver_.reset(gsl_odeiv2_driver_alloc_y_new(&system_, tolerance.method, 1e-3, tolerance.absolute,
                                              tolerance.relative));
  if (!driver_)
    throw std::invalid_argument(
        "GSL rejects this integration: it needs a dimension of at least 1 and tolerances >= 0");
}

// A solution that runs away can become infinite while GSL still reports success
void Reference::advance(double& t, double t_end, std::vector<double>& x) {
  const int status = gsl_odeiv2_driver_apply(driver_.get(), &t, t_end, x.data());
  if (status != GSL_SUCCESS)
    throw std::runtime_error("the reference integrator stopped at t = " + std::to_string(t) + ": " +
                             gsl_strerror(status));
  if (!std::all_of(x.begin(), x.end(), [](double value) { return std::isfinite(value); }))
    throw std::runtime_error(
        "the solution of the reference integrator is no longer finite at t = " + std::to_string(t));
}

int Reference::call(double t, const double* x, double* dx, void* self) {
  auto* me = static_cast<Reference*>(self);
  ++me->evaluations_;
  me->rhs_(t, x, dx);
  return GSL_SUCCESS;
}

// The chain as a system of first order, by the same forces
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
