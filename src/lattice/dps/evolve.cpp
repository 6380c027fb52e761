#include "lattice/dps/evolve.hpp"

#include <algorithm>
#include <cmath>

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

// The packet at one sample, and whether the motion has come to the far end
static void look(DpsOutcome& out, double tau, const Field& field) {
  const auto d = density(field);
  const auto site = front_packet(d);
  if (tau > 0 && site) out.path.add(tau, d, *site);
  out.far_end = std::max(out.far_end, std::abs(field.back()));
}

DpsOutcome follow_dps(const Dps& dps, const Field& start, double duration, std::size_t samples,
                      const Tolerance& tolerance, const DpsObserver& watch) {
  DpsOutcome out{{}, start};
  out.norm_drift =
      evolve_dps(dps, out.end, duration, samples, tolerance, [&](double tau, const Field& field) {
        watch(tau, field);
        look(out, tau, field);
      });
  return out;
}

Estimate packet_amplitude(const Path& path) {
  const double end = path.back().centre;
  Estimate top = path.largest_peak(end - 1, end);
  if (std::isnan(top.value)) top = path.largest_peak(end - 2, end);
  const double amplitude = std::sqrt(top.value);
  return {amplitude, top.error / (2 * amplitude)};
}

}  // namespace lattice
