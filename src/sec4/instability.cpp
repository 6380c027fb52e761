#include "sec4/instability.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lattice/model/contact.hpp"
#include "lattice/model/well.hpp"
#include "sec4/plane_wave.hpp"

namespace lattice {

// How fast a modulation of the exact wave grows
double PhaseOfWave::growth(double a, double modulation, std::size_t harmonics) const {
  const Quartic well{s};
  const CompressedHertz contact{d};
  return growth_rate(plane_wave(well, contact, q, a, harmonics), well, contact, modulation);
}

// Phi from the fastest growth over |A|^2 = a^2 / 4, in the limit of small amplitude
Estimate PhaseOfWave::phi_from_growth(double a) const {
  const auto c = nls();
  return at_zero_amplitude(a, [&](double x) {
    return growth(x, fastest_modulation(c, x)) / (x * x / 4) * c.omega * std::abs(c.omega_2);
  });
}

// Growth against the largest rate of the NLS equation
double growth_over_nls(const PhaseOfWave& at, double a, double modulation, std::size_t harmonics) {
  return at.growth(a, modulation, harmonics) / (std::abs(at.nls().h()) * a * a / 4);
}

// Try a slower, an equal and a faster modulation than the NLS equation's fastest one
double slow_growth(const PhaseOfWave& at, double a, std::size_t harmonics) {
  const auto c = at.nls();
  const double slow = std::sqrt(std::abs(c.h() * a * a / (2 * c.curvature)));
  double growth = 0;
  for (double m : {0.5, 1.0, 1.5}) growth = std::max(growth, at.growth(a, m * slow, harmonics));
  return growth;
}

BandEdges band_edges(double d, double threshold) {
  const double a = 0.005, beside = 0.05, pi = std::numbers::pi;
  // The formulas for Phi at both edges of the band, in soft and in hard wells
  double formula = 0, leftover = 0;
  for (double s = -4; s <= 4; s += 0.25)
    formula = std::max({formula, std::abs(coefficients(0.0, d, s).phi + 1.5 * s),
                        std::abs(coefficients(pi, d, s).phi - 1.5 * (s - threshold))});
  // A little beyond either threshold exact waves grow as the NLS equation says ...
  Estimate apart{};
  for (const PhaseOfWave& phase : {PhaseOfWave{0, d, -beside}, {pi, d, threshold + beside}}) {
    const double nls = std::abs(phase.nls().h()) * a * a / 4;
    apart = larger(apart, compare(std::abs(slow_growth(phase, a, 6) / nls - 1),
                                  std::abs(slow_growth(phase, a) / nls - 1)));
  }
  // ... and a little before it they do not grow at all
  for (const PhaseOfWave& phase : {PhaseOfWave{0, d, beside}, {pi, d, threshold - beside}})
    leftover = std::max(leftover, slow_growth(phase, a));
  return {compare(0.0, formula), apart, compare(0.0, leftover)};
}

}  // namespace lattice
