#pragma once
/**
# Periodic travelling waves of small amplitude

The DpS equation has the waves $A_n = e^{i(qn-\Omega\tau)}$ with $-2\tau_0\Omega = (2\sin\frac q2)^{5/2}$. By Eq. (13)
they stand for $y_n = 2\epsilon\cos(qn+\omega t)$ with $\omega = 1-\epsilon^{1/2}\Omega$. An exact wave of the chain
with linear wells and the same frequency is $y_n(t) = \epsilon u(qn+\omega t)$, where $u$ has the period $2\pi$ and
$$\omega^2u'' + u = \epsilon^{1/2}\bigl[(u(\varphi-q)-u(\varphi))_+^{3/2} - (u(\varphi)-u(\varphi+q))_+^{3/2}\bigr].$$
The equation remains true if $\varphi$ and $u$ change their signs, so we look for odd waves,
$u = \sum_k b_k\sin k\varphi$. The right-hand side is small: what it gives for $k\ge2$ follows by iteration,
$b_k = \epsilon^{1/2}G_k/(1-k^2\omega^2)$. At $k = 1$ the left-hand side is small too and fixes the amplitude, since
$G_1$ grows like $b_1^{3/2}$. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "lattice/model/dps.hpp"

namespace lattice {

/// The wave whose wavelength is `beads` sites, q = 2 pi / beads, with the frequency that the DpS equation
/// gives it at the size `eps`; `points` of phase, a multiple of beads, and `harmonics` resolve it.
struct TravellingWave {
  std::size_t beads, points, harmonics;
  double eps, omega;
  std::vector<double> b{}, sine{};  ///< b_1, b_2, ...; sin at the points

  /// Throws std::runtime_error if the iteration does not converge.
  TravellingWave(std::size_t wavelength, double size, std::size_t grid = 3072,
                 std::size_t terms = 48)
      : beads(wavelength), points(grid), harmonics(terms), eps(size), b(terms), sine(grid) {
    const double s = 2 * std::sin(std::numbers::pi / double(beads));
    omega = 1 + std::sqrt(eps) * (s * s * std::sqrt(s)) / (2 * tau_0());
    for (std::size_t j = 0; j < points; ++j)
      sine[j] = std::sin(2 * std::numbers::pi * double(j) / double(points));
    b[0] = 2;
    for (int k = 0; k < 200; ++k)
      if (improve() < 1e-14) return;
    throw std::runtime_error("the iteration for a travelling wave does not converge");
  }

  /// u at the points of phase.
  std::vector<double> profile() const {
    std::vector<double> u(points);
    for (std::size_t k = 1; k <= harmonics; ++k)
      for (std::size_t j = 0; j < points; ++j) u[j] += b[k - 1] * sine[k * j % points];
    return u;
  }

  /// The largest distance of the ansatz from the exact wave, over all phases.
  double from_ansatz() const {
    const std::vector<double> u = profile();
    double most = 0;
    for (std::size_t j = 0; j < points; ++j) most = std::max(most, std::abs(u[j] - 2 * sine[j]));
    return eps * most;
  }

  /// The wave at t = 0 on a ring of `sites` beads, a multiple of the wavelength.
  State<double> on_ring(std::size_t sites) const {
    State<double> state(sites);
    for (std::size_t n = 0; n < sites; ++n)
      for (std::size_t k = 1; k <= harmonics; ++k) {
        const std::size_t j = k * n * (points / beads) % points;
        state.y[n] += eps * b[k - 1] * sine[j];
        state.v[n] += eps * omega * double(k) * b[k - 1] * sine[(j + points / 4) % points];
      }
    return state;
  }

 private:
  // One round: the forces of this wave, harmonic by harmonic, give the next; returns the largest change
  double improve() {
    const std::vector<double> u = profile();
    const std::size_t shift = points / beads;
    const auto push = [](double r) { return r > 0 ? r * std::sqrt(r) : 0; };
    std::vector<double> force(points);
    for (std::size_t j = 0; j < points; ++j)
      force[j] =
          push(u[(j + points - shift) % points] - u[j]) - push(u[j] - u[(j + shift) % points]);
    double change = 0;
    for (std::size_t k = 1; k <= harmonics; ++k) {
      double G = 0;
      for (std::size_t j = 0; j < points; ++j) G += force[j] * sine[k * j % points];
      G *= 2 * std::sqrt(eps) / double(points);
      const double stiffness = 1 - omega * omega * double(k * k), ratio = G / (stiffness * b[0]);
      const double next = k == 1 ? b[0] / (ratio * ratio) : G / stiffness;
      change = std::max(change, std::abs(next - b[k - 1]));
      b[k - 1] = next;
    }
    return change;
  }
};

}  // namespace lattice
