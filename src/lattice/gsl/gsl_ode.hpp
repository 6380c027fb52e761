#pragma once
/**
# An independent integrator of ordinary differential equations

Nobody should have to trust our own steppers alone. This file wraps the adaptive methods of the GNU
Scientific Library (GSL), by default that of Prince and Dormand of order eight (`rk8pd`): different
methods, written by different people, that control their own error. They solve $\dot x = f(t, x)$ with
$f$ given as a function. */

#include <gsl/gsl_odeiv2.h>

#include <cstddef>
#include <memory>
#include <vector>

#include "lattice/numerics/rhs.hpp"

namespace lattice {

/// Local error allowed, `absolute + relative |x|`, and the method, by default rk8pd.
struct Tolerance {
  double absolute, relative;
  const gsl_odeiv2_step_type* method = gsl_odeiv2_step_rk8pd;
  /// The same number for both parts.
  Tolerance(double both) : absolute(both), relative(both) {}
  Tolerance(double absolute_part, double relative_part, const gsl_odeiv2_step_type* type)
      : absolute(absolute_part), relative(relative_part), method(type) {}
};

/**
GSL owns memory that must be freed, calls back a C function, and reports failure by a status that is
easily overlooked. This class takes care of all three. C knows no objects, so this one travels through GSL
as a plain pointer from which `call` recovers it; it must therefore stay where it is, and copies are
forbidden. */
class Reference {
 public:
  /// For an equation of `dimension` unknowns. Throws std::invalid_argument if GSL refuses the tolerance.
  Reference(Rhs rhs, std::size_t dimension, const Tolerance& tolerance);
  Reference(const Reference&) = delete;
  Reference& operator=(const Reference&) = delete;

  /// Carries `x` from time `t` to `t_end`, and updates `t`. Throws std::runtime_error if GSL cannot go
  /// on or a value is no longer finite.
  void advance(double& t, double t_end, std::vector<double>& x);

  /// How often the right-hand side has been evaluated.
  std::size_t evaluations() const { return evaluations_; }

 private:
  static int call(double t, const double* x, double* dx, void* self);
  struct Free {
    void operator()(gsl_odeiv2_driver* d) const { gsl_odeiv2_driver_free(d); }
  };
  Rhs rhs_;
  gsl_odeiv2_system system_;
  std::unique_ptr<gsl_odeiv2_driver, Free> driver_;
  std::size_t evaluations_ = 0;
};

}  // namespace lattice
