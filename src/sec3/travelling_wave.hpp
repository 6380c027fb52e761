#pragma once
/**
# Exact periodic travelling waves of small amplitude

`sec31_dps_limit` has their equation, with $G_k$ as the harmonics of its bracket. Odd waves $u = \sum_k b_k\sin
k\varphi$ follow by iteration: $b_k = \epsilon^{\alpha-1}G_k/(1-k^2\omega^2)$ is the next one for $k\ge2$. At $k = 1$
it fixes $b_1$ at *equal frequency*, since $G_1$ grows like $b_1^\alpha$, and $\omega$ at *equal amplitude*, $b_1=2$. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "lattice/model/contact.hpp"
#include "lattice/model/dps.hpp"
#include "lattice/numerics/estimate.hpp"

namespace lattice {

/// The harmonics G_k of the contact forces on a bead of the wave with the amplitudes `b`, from its values at equal
/// distances, where `sine` is sin(phi).
inline std::vector<double> force_harmonics(const std::vector<double>& b,
                                           const std::vector<double>& sine, std::size_t sites,
                                           double alpha) {
  const std::size_t points = sine.size(), shift = points / sites;
  std::vector<double> u(points), force(points), G;
  for (std::size_t k = 1; k <= b.size(); ++k)
    for (std::size_t j = 0; j < points; ++j) u[j] += b[k - 1] * sine[k * j % points];
  const auto contact = [&](double x) { return x > 0 ? x * secant_stiffness(x, alpha) : 0; };
  for (std::size_t j = 0; j < points; ++j)
    force[j] =
        contact(u[(j + points - shift) % points] - u[j]) - contact(u[j] - u[(j + shift) % points]);
  for (std::size_t k = 1; k <= b.size(); ++k) {
    double sum = 0;
    for (std::size_t j = 0; j < points; ++j) sum += force[j] * sine[k * j % points];
    G.push_back(2 * sum / double(points));
  }
  return G;
}

/// The largest distance of the exact wave with so many harmonics from the plane wave.
inline double distance(bool equal_frequency, std::size_t sites, double eps, double alpha,
                       std::size_t harmonics) {
  // The frequency of the plane wave, and its profile as first guess
  const double small = secant_stiffness(eps, alpha);                // eps^(alpha-1)
  const double s = 2 * std::sin(std::numbers::pi / double(sites));  // 2 sin(q/2)
  const double plane = 1 + small * (s * s * secant_stiffness(s, alpha)) / (2 * tau_0(alpha));
  std::vector<double> sine(64 * harmonics), b(harmonics);
  for (std::size_t j = 0; j < sine.size(); ++j)
    sine[j] = std::sin(2 * std::numbers::pi * double(j) / double(sine.size()));
  b[0] = 2;
  double omega = plane, change = 1;
  for (int round = 0; change >= 1e-14; ++round) {
    if (round > 200) throw std::runtime_error("the travelling wave does not converge");
    const std::vector<double> G = force_harmonics(b, sine, sites, alpha);
    // The first harmonic: (1 - omega^2) b_1 = eps^(alpha-1) G_1 with G_1 ~ b_1^alpha
    const double ratio = small * G[0] / ((1 - omega * omega) * b[0]);
    double& unknown = equal_frequency ? b[0] : omega;
    const double first = equal_frequency ? b[0] * std::pow(ratio, -1 / (alpha - 1))
                                         : std::sqrt(1 - small * G[0] / b[0]);
    change = std::abs(first - unknown);
    unknown = first;
    for (std::size_t k = 2; k <= harmonics; ++k) {
      const double next = small * G[k - 1] / (1 - omega * omega * double(k * k));
      change = std::max(change, std::abs(next - b[k - 1]));
      b[k - 1] = next;
    }
  }

  // From the plane wave, over all phases, at t = 0 and when the exact wave has run ahead
  double most = 0;
  std::vector<double> leads{0};
  if (!equal_frequency) leads.push_back((omega - plane) / small);
  for (const double ahead : leads)
    for (std::size_t j = 0; j < sine.size(); ++j) {
      const double phase = 2 * std::numbers::pi * double(j) / double(sine.size()) + ahead;
      double u = 0;
      for (std::size_t k = 0; k < harmonics; ++k) u += b[k] * std::sin(double(k + 1) * phase);
      most = std::max(most, std::abs(u - 2 * sine[j]));
    }
  return eps * most;
}

/// Largest distances of the exact wave from the plane wave of the DpS equation, from 24 and 48 harmonics: at equal
/// frequency the same at all times, at equal amplitude the larger one of t = 0 and t = eps^(1-alpha).
struct WaveDistances {
  Estimate largest, at_equal_amplitude;
};

/// For a wavelength of 2, 3, 4, 6 or 8 `sites`. Throws std::invalid_argument unless they divide the samples.
inline WaveDistances wave_distances(std::size_t sites, double eps, double alpha) {
  if (64 * 24 % sites != 0) throw std::invalid_argument("this wavelength does not fit the samples");
  const auto estimate = [&](bool equal_frequency) {
    return with_error(distance(equal_frequency, sites, eps, alpha, 24),
                      distance(equal_frequency, sites, eps, alpha, 48));
  };
  return {estimate(true), estimate(false)};
}

}  // namespace lattice
