#pragma once
/**
# The DpS equation in time

The right-hand side of the DpS equation (dps.hpp) is smooth except where two neighbours coincide, so GSL's
adaptive method of order eight can integrate it (gsl_ode.hpp).

Near a stationary state $v_n = u_ne^{i\mu t}$ (stationary.hpp) everything turns with the frequency $\mu$,
and most of the work would go into that turning. With $v_n = w_ne^{i\mu t}$ the equation gains a term,
$i\dot w_n = \mu w_n + \dots$, and a stationary state stands still, so that the integrator has only the
perturbation left to follow: at equal tolerance it needs half the time and keeps the norm some hundred
times better. Moduli are those of $v_n$. */

#include <cstddef>
#include <functional>
#include <vector>

#include "lattice/gsl/gsl_ode.hpp"
#include "lattice/model/dps.hpp"
#include "lattice/numerics/observer.hpp"

namespace lattice {

/// The DpS equation in the frame that turns with e^{i mu t}, and at mu = 0 the equation itself.
struct TurningDps {
  Dps dps;
  double mu;  ///< frequency of the frame, per unit of slow time

  /// Writes dw/dtau into `dw`, real and imaginary parts alternating as in Dps.
  void operator()(double tau, const double* w, double* dw) const;
};

/// Real and imaginary parts alternating, the form in which the integrator carries a field.
std::vector<double> interleaved(const Field& field);

/// Sees a run at its samples: the slow time and the field.
using DpsLook = Observer<double, Field>;

/**
The integrator controls the error of a single step, and errors add up. The norm is conserved by the
equation and cheap to compute, so we watch it at every sample and return how far it drifts; whoever reads
a number from the run can compare the two. */
/// Carries `field` over the slow time `duration` and calls `observe` at the start and after each of
/// `samples` equal intervals; returns the largest relative change of the norm. `equation` is a Dps or a
/// TurningDps. Throws std::runtime_error if GSL cannot go on.
double evolve_dps(const Rhs& equation, Field& field, double duration, std::size_t samples,
                  const Tolerance& tolerance, const DpsLook& observe = {});

}  // namespace lattice
