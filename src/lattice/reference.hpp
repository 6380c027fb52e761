#pragma once
/**
# An independent integrator

Nobody should have to trust our steppers alone. This file wraps the adaptive
Prince–Dormand method of order 8 of the GNU Scientific Library (`rk8pd`): a
different method, written by different people, that controls its own error. It
integrates the DpS equation, whose force is smooth except where two neighbours
coincide, and it serves as the reference for the chain in the tests. */

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "chain.hpp"

namespace lattice {

/// Local error allowed, `absolute + relative |x|`, and the method, by default rk8pd.
struct Tolerance {
  double absolute, relative;
  const gsl_odeiv2_step_type* method = gsl_odeiv2_step_rk8pd;
  Tolerance(double both) : absolute(both), relative(both) {}
  Tolerance(double absolute_part, double relative_part, const gsl_odeiv2_step_type* type)
      : absolute(absolute_part), relative(relative_part), method(type) {}
};

/// Integrates `x' = rhs(t, x, dx)` adaptively. `Rhs` is callable as `void(double, const double*,
/// double*)`. Throws std::runtime_error if GSL cannot go on.
template <class Rhs>
class Reference {
 public:
  Reference(Rhs rhs, std::size_t dimension, const Tolerance& tolerance)
      : rhs_(std::move(rhs)), system_{&Reference::call, nullptr, dimension, this} {
    driver_.reset(gsl_odeiv2_driver_alloc_y_new(&system_, tolerance.method, 1e-3,
                                                tolerance.absolute, tolerance.relative));
  }
  Reference(const Reference&) = delete;
  Reference& operator=(const Reference&) = delete;

  /// Carries `x` from time `t` to `t_end`; `t` is updated.
  void advance(double& t, double t_end, std::vector<double>& x) {
    const int status = gsl_odeiv2_driver_apply(driver_.get(), &t, t_end, x.data());
    if (status != GSL_SUCCESS)
      throw std::runtime_error("the reference integrator stopped at t = " + std::to_string(t) +
                               ": " + gsl_strerror(status));
  }
  std::size_t evaluations() const { return evaluations_; }

 private:
  static int call(double t, const double* x, double* dx, void* self) {
    auto* me = static_cast<Reference*>(self);
    ++me->evaluations_;
    me->rhs_(t, x, dx);
    return GSL_SUCCESS;
  }
  struct Free {
    void operator()(gsl_odeiv2_driver* d) const { gsl_odeiv2_driver_free(d); }
  };
  Rhs rhs_;
  gsl_odeiv2_system system_;
  std::unique_ptr<gsl_odeiv2_driver, Free> driver_;
  std::size_t evaluations_ = 0;
};

/// Carries `state` forward by `duration` with GSL; returns the number of force evaluations.
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
