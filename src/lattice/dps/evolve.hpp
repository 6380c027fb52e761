#pragma once
/**
# The DpS equation in time

Its right-hand side is smooth except where two neighbours coincide, and GSL's adaptive method of
order eight integrates it.

Near a stationary state everything turns with the frequency $\mu$, and most of the work goes into
that turning. With $v_n = w_ne^{i\mu t}$ the equation gains a term, $i\dot w_n = \mu w_n + \dots$,
and a stationary state stands still, so that the integrator is left with the perturbation: at equal
tolerance it needs half the time and keeps the norm some hundred times better. Moduli are those of
$v_n$. */

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

/// Real and imaginary parts in turn, the form in which the integrator carries a field.
inline std::vector<double> interleaved(const Field& field) {
  std::vector<double> x;
  for (const auto& w : field) x.insert(x.end(), {w.real(), w.imag()});
  return x;
}

/**
The integrator controls the error of one step only, and errors add up. The norm costs nothing beside a
step and is conserved by the equation, so we look at it at every sample and return how far it drifts:
who reads a number from the run can compare the two. */
/// Carries `field` over the slow time `duration`, showing (tau, field) to `observe` at `samples`
/// equal intervals and at the start; returns the largest relative change of the norm. `Equation` is
/// Dps or TurningDps.
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
