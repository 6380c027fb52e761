#pragma once
/**
# The DpS equation in time

Its right-hand side is smooth except where two neighbours coincide, and GSL's adaptive method of
order eight integrates it. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>
#include "lattice/dps/dps.hpp"
#include "lattice/numbers/gsl_ode.hpp"

namespace lattice {

/**
Carries `field` over the slow time `duration`, showing (tau, field) to `observe` at `samples`
equal intervals and at the start; returns the largest relative change of the norm. */
template <class Observer>
double evolve_dps(const Dps& dps, Field& field, double duration, std::size_t samples,
                  const Tolerance& tolerance, Observer observe) {
  std::vector<double> x(2 * field.size());
  const auto pack = [&] {
    for (std::size_t n = 0; n < field.size(); ++n) {
      x[2 * n] = field[n].real();
      x[2 * n + 1] = field[n].imag();
    }
  };
  pack();
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
