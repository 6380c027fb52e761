#include "lattice/dps/evolve.hpp"

#include <algorithm>
#include <cmath>

#include "lattice/numerics/interrupt.hpp"
#include "lattice/numerics/progress.hpp"

namespace lattice {

void RotatingDps::operator()(double tau, const double* w, double* dw) const {
  dps(tau, w, dw);
  for (std::size_t n = 0; n < dps.sites; ++n) {
    dw[2 * n] += mu * w[2 * n + 1];
    dw[2 * n + 1] -= mu * w[2 * n];
  }
}

std::vector<double> interleaved(const Field& field) {
  std::vector<double> x;
  for (const auto& w : field) x.insert(x.end(), {w.real(), w.imag()});
  return x;
}

double evolve_dps(const Rhs& equation, Field& field, double duration, std::size_t samples,
                  const Tolerance& tolerance, const DpsObserver& observe) {
  std::vector<double> x = interleaved(field);
  Reference reference(equation, x.size(), tolerance);
  const double start = norm(field);
  double tau = 0, drift = 0;
  observe(tau, field);
  Progress progress(number_label("tolerance", tolerance.relative), 1);
  for (std::size_t k = 1; k <= samples; ++k) {
    heed_stop();
    reference.advance(tau, duration * double(k) / double(samples), x);
    for (std::size_t n = 0; n < field.size(); ++n) field[n] = {x[2 * n], x[2 * n + 1]};
    drift = std::max(drift, std::abs(norm(field) - start) / start);
    observe(tau, field);
    progress.reach(double(k) / double(samples));
  }
  return drift;
}

}  // namespace lattice
