#pragma once
/**
# An independent integrator of ordinary differential equations

Nobody should have to trust our own steppers alone. This file wraps the adaptive methods of the GNU
Scientific Library (GSL), by default that of Prince and Dormand of order eight (`rk8pd`): different
methods, written by different people, that control their own error. They solve $\dot x = f(t, x)$ with
$f$ given as a function. */

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace lattice {

/// Local error allowed, `absolute + relative |x|`, and the method, by default rk8pd.
struct Tolerance {
  double absolute, relative;
  const gsl_odeiv2_step_type* method = gsl_odeiv2_step_rk8pd;
  Tolerance(double both) : absolute(both), relative(both) {}
  Tolerance(double absolute_part, double relative_part, const gsl_odeiv2_step_type* type)
      : absolute(absolute_part), relative(relative_part), method(type) {}
};

/**
GSL owns memory that must be freed, calls back a C function, and reports failure by a status that is
easily overlooked. This class takes care of all three while it integrates `x' = rhs(t, x, dx)`. `Rhs` is
callable as `void(double, const double*, double*)`. Throws std::invalid_argument if GSL refuses the
tolerance and std::runtime_error if it cannot go on. */
template <class Rhs>
class Reference {
 public:
  Reference(Rhs rhs, std::size_t dimension, const Tolerance& tolerance)
      : rhs_(std::move(rhs)), system_{&Reference::call, nullptr, dimension, this} {
    gsl_set_error_handler_off();  // GSL would abort; its status is checked below
    driver_.reset(gsl_odeiv2_driver_alloc_y_new(&system_, tolerance.method, 1e-3,
                                                tolerance.absolute, tolerance.relative));
    if (!driver_)
      throw std::invalid_argument(
          "GSL refuses this integration: it needs a dimension of at least 1 and "
          "tolerances >= 0");
  }
  Reference(const Reference&) = delete;
  Reference& operator=(const Reference&) = delete;

  /**
  One call carries `x` from time `t` to `t_end`, and `t` is updated. Apart from the status we check the
  values, because a solution that runs away can become infinite while GSL still reports success. */
  void advance(double& t, double t_end, std::vector<double>& x) {
    const int status = gsl_odeiv2_driver_apply(driver_.get(), &t, t_end, x.data());
    if (status != GSL_SUCCESS)
      throw std::runtime_error("the reference integrator stopped at t = " + std::to_string(t) +
                               ": " + gsl_strerror(status));
    if (!std::all_of(x.begin(), x.end(), [](double value) { return std::isfinite(value); }))
      throw std::runtime_error("the reference integrator left the numbers before t = " +
                               std::to_string(t));
  }
  std::size_t evaluations() const { return evaluations_; }

  /**
  C knows no objects, so this one travels through GSL as a plain pointer from which `call` recovers it.
  Therefore it must stay where it is, and copies are forbidden. */
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

}  // namespace lattice
