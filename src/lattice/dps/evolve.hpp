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

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>
#include "lattice/dps/dps.hpp"
#include "lattice/numbers/gsl_ode.hpp"

namespace lattice {

/// The DpS equation in the frame that turns with e^{i mu t}, and at mu = 0 the equation itself.
struct TurningDps {
  Dps dps;
  double mu;

  void operator()(double t, const double* w, double* dw) const {
    dps(t, w, dw);
    for (std::size_t n = 0; n < dps.sites; ++n) {
      dw[2 * n] += mu * w[2 * n + 1];
      dw[2 * n + 1] -= mu * w[2 * n];
    }
  }
};

/// Real and imaginary parts alternating, the form in which the integrator carries a field.
inline std::vector<double> interleaved(const Field& field) {
  std::vector<double> x;
  for (const auto& w : field) x.insert(x.end(), {w.real(), w.imag()});
  return x;
}

/**
The integrator controls the error of a single step, and errors add up. The norm is conserved by the
equation and cheap to compute, so we watch it at every sample and return how far it drifts; whoever reads
a number from the run can compare the two. */
/// Carries `field` over the slow time `duration` and calls `observe(tau, field)` at the start and after
/// each of `samples` equal intervals; returns the largest relative change of the norm. `Equation` is Dps
/// or TurningDps. Throws std::runtime_error if GSL cannot go on.
template <class Equation, class Observer>
double evolve_dps(const Equation& dps, Field& field, double duration, std::size_t samples,
                  const Tolerance& tolerance, Observer observe) {
  std::vector<double> x = interleaved(field);
  Reference reference(dps, x.size(), tolerance);
  const double start = norm(field);
  double tau = 0, drift = 0;
  observe(tau, std::as_const(field));
  for (std::size_t k = 1; k <= samples; ++k) {
    reference.advance(tau, duration * double(k) / double(samples), x);
    for (std::size_t n = 0; n < field.size(); ++n) field[n] = {x[2 * n], x[2 * n + 1]};
    drift = std::max(drift, std::abs(norm(field) - start) / start);
    observe(tau, std::as_const(field));
  }
  return drift;
}

}  // namespace lattice
