#pragma once
/**
# An independent integrator

The adaptive methods of the GNU Scientific Library (GSL), by default that of Prince and Dormand of order eight
(`rk8pd`): different methods, written by different people, that control their own error. With our own integrators they
share nothing but the forces. */

#include <gsl/gsl_odeiv2.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "lattice/model/chain.hpp"

namespace lattice {

/// The right-hand side f of an equation: writes dx/dt into `dx`, given `t` and `x`.
using Rhs = std::function<void(double t, const double* x, double* dx)>;

/// Local error allowed, `absolute + relative |x|`, and the method, by default rk8pd.
struct Tolerance {
  double absolute, relative;
  const gsl_odeiv2_step_type* method = gsl_odeiv2_step_rk8pd;
  /// The same number for both parts.
  Tolerance(double both) : absolute(both), relative(both) {}
  Tolerance(double absolute_part, double relative_part, const gsl_odeiv2_step_type* type)
      : absolute(absolute_part), relative(relative_part), method(type) {}
};

/// Solves dx/dt = f(t, x). GSL calls it back through a plain pointer, so it stays where it is and is not copied.
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

/// Carries `state` forward by `duration` with the given local tolerance; returns the number of force evaluations. Throws
/// std::runtime_error if GSL cannot go on.
std::size_t evolve_reference(const Chain& chain, State<double>& state, double duration,
                             const Tolerance& tolerance);

/// The `distance` (refinement.hpp) of `end` from where GSL arrives that leaves `start` for `duration`.
/// Throws std::runtime_error unless it is below `bound`.
double distance_from_reference(const Chain& chain, State<double> start, double duration,
                               const State<double>& end, double bound);

}  // namespace lattice
