#include "lattice/gsl/gsl_ode.hpp"

#include <gsl/gsl_errno.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

namespace lattice {

Reference::Reference(Rhs rhs, std::size_t dimension, const Tolerance& tolerance)
    : rhs_(std::move(rhs)), system_{&Reference::call, nullptr, dimension, this} {
  gsl_set_error_handler_off();  // GSL would abort; its status is checked below
  driver_.reset(gsl_odeiv2_driver_alloc_y_new(&system_, tolerance.method, 1e-3, tolerance.absolute,
                                              tolerance.relative));
  if (!driver_)
    throw std::invalid_argument(
        "GSL refuses this integration: it needs a dimension of at least 1 and tolerances >= 0");
}

/**
Apart from GSL's status we check the values, because a solution that runs away can become infinite while
GSL still reports success. */
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

}  // namespace lattice
