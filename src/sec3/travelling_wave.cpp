#include "sec3/travelling_wave.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "lattice/model/contact.hpp"
#include "lattice/model/dps.hpp"

namespace lattice {
namespace {

enum class Equal { frequency, amplitude };

struct Wave {
  std::vector<double> sine, b;  // sin(phi) at equal distances, and all amplitudes
  double lead;                  // by how much its frequency exceeds that of the plane wave

  /// u less the plane wave, at each phase, when the exact wave is ahead by `ahead`.
  std::vector<double> differences(double ahead) const {
    std::vector<double> out;
    for (std::size_t j = 0; j < sine.size(); ++j) {
      const double phase = 2 * std::numbers::pi * double(j) / double(sine.size()) + ahead;
      double u = 0;
      for (std::size_t k = 0; k < b.size(); ++k) u += b[k] * std::sin(double(k + 1) * phase);
      out.push_back(u - 2 * sine[j]);
    }
    return out;
  }
};

/// The harmonics G_k of the contact forces that act on a bead of the wave.
std::vector<double> force_harmonics(const Wave& wave, std::size_t sites, double alpha) {
  const std::size_t points = wave.sine.size(), shift = points / sites;
  std::vector<double> u(points), force(points), G;
  for (std::size_t k = 1; k <= wave.b.size(); ++k)
    for (std::size_t j = 0; j < points; ++j) u[j] += wave.b[k - 1] * wave.sine[k * j % points];
  const auto contact = [&](double x) { return x > 0 ? x * secant_stiffness(x, alpha) : 0; };
  for (std::size_t j = 0; j < points; ++j)
    force[j] =
        contact(u[(j + points - shift) % points] - u[j]) - contact(u[j] - u[(j + shift) % points]);
  for (std::size_t k = 1; k <= wave.b.size(); ++k) {
    double sum = 0;
    for (std::size_t j = 0; j < points; ++j) sum += force[j] * wave.sine[k * j % points];
    G.push_back(2 * sum / double(points));
  }
  return G;
}

Wave exact_wave(Equal equal, std::size_t sites, double eps, double alpha, std::size_t points,
                std::size_t harmonics) {
  // The frequency of the plane wave, and its profile as first guess
  const double small = secant_stiffness(eps, alpha);                // eps^(alpha-1)
  const double s = 2 * std::sin(std::numbers::pi / double(sites));  // 2 sin(q/2)
  const double plane = 1 + small * (s * s * secant_stiffness(s, alpha)) / (2 * tau_0(alpha));
  double omega = plane, change = 1;
  Wave wave{std::vector<double>(points), std::vector<double>(harmonics), 0};
  for (std::size_t j = 0; j < points; ++j)
    wave.sine[j] = std::sin(2 * std::numbers::pi * double(j) / double(points));
  std::vector<double>& b = wave.b;
  b[0] = 2;
  for (int round = 0; change >= 1e-14; ++round) {
    if (round > 200)
      throw std::runtime_error("the iteration for a travelling wave does not converge");
    const std::vector<double> G = force_harmonics(wave, sites, alpha);
    // The first harmonic: (1 - omega^2) b_1 = eps^(alpha-1) G_1 with G_1 ~ b_1^alpha
    if (equal == Equal::frequency) {
      const double ratio = small * G[0] / ((1 - omega * omega) * b[0]);
      const double next = b[0] * std::pow(ratio, -1 / (alpha - 1));
      change = std::abs(next - b[0]);
      b[0] = next;
    } else {
      const double next = std::sqrt(1 - small * G[0] / b[0]);
      change = std::abs(next - omega);
      omega = next;
    }
    // The others
    for (std::size_t k = 2; k <= harmonics; ++k) {
      const double next = small * G[k - 1] / (1 - omega * omega * double(k * k));
      change = std::max(change, std::abs(next - b[k - 1]));
      b[k - 1] = next;
    }
  }
  wave.lead = omega - plane;
  return wave;
}

}  // namespace

// Two resolutions of either wave
WaveDistances wave_distances(std::size_t sites, double eps, double alpha) {
  const auto largest = [&](const Wave& wave, double ahead) {
    double most = 0;
    for (const double x : wave.differences(ahead)) most = std::max(most, std::abs(x));
    return eps * most;
  };
  const auto at_the_end = [&](const Wave& wave) {
    return std::max(largest(wave, 0), largest(wave, wave.lead / secant_stiffness(eps, alpha)));
  };
  const Wave coarse = exact_wave(Equal::frequency, sites, eps, alpha, 1536, 24),
             fine = exact_wave(Equal::frequency, sites, eps, alpha, 3072, 48),
             coarse_ahead = exact_wave(Equal::amplitude, sites, eps, alpha, 1536, 24),
             fine_ahead = exact_wave(Equal::amplitude, sites, eps, alpha, 3072, 48);
  return {compare(largest(coarse, 0), largest(fine, 0)),
          compare(at_the_end(coarse_ahead), at_the_end(fine_ahead))};
}

}  // namespace lattice
