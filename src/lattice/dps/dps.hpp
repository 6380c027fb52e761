#pragma once
/**
# The discrete p-Schrödinger equation

At small amplitude the contacts are much weaker than the wells. Every bead then oscillates at the
frequency of its well, and the contacts change its complex amplitude $A_n$ only slowly. With Eq. (13),
$$y_n(t) = 2\epsilon\,\mathrm{Re}\,[A_n(\tau)\,e^{it}],\qquad \tau = \epsilon^{1/2}t,$$
averaging over the fast oscillation gives an equation in the slow time $\tau$, the discrete p-Schrödinger
(DpS) equation, Eq. (12),
$$2i\tau_0\,\dot A_n = D_n - D_{n-1}, \qquad
  D_n = (A_{n+1}-A_n)\,|A_{n+1}-A_n|^{1/2},\qquad
  \tau_0 = \frac{5\,\Gamma(\frac14)^2}{24\sqrt\pi}.$$
It has no linear part, conserves the norm $\sum|A_n|^2$ and the energy
$\frac{2}{5}\sum|A_{n+1}-A_n|^{5/2}$, and does not contain $\epsilon$. */

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "lattice/model/chain.hpp"

namespace lattice {

/// Gamma(1/4).
inline constexpr double gamma_quarter = 3.6256099082219083119;

/// Time constant of the DpS equation, tau_0 = 5 Gamma(1/4)^2 / (24 sqrt(pi)), below Eq. (12).
inline double tau_0() {
  return 5 * gamma_quarter * gamma_quarter / (24 * std::sqrt(std::numbers::pi));
}

/// The amplitude scale epsilon of the static breathers of frequency `omega_b`, Eq. (20) inverted.
inline double breather_eps(double omega_b) {
  return std::pow(2 * tau_0() * (omega_b - 1), 2);
}

/// The complex amplitudes A_n, one entry per site.
using Field = std::vector<std::complex<double>>;

/**
An integrator wants the right-hand side as a function. The boundary condition decides what stands in for
the missing neighbour at the first site: a free end has no contact there, a fixed one has $A_0 = 0$. The
far end is always free. Differences below $10^{-60}$ count as zero, for the reason given at `Hertz` in
contact.hpp. */
struct Dps {
  std::size_t sites;
  Ends near_end = Ends::free;
  double rate = 1 / (2 * tau_0());  ///< inverse time constant

  /// |x + i y|^{1/2}
  static double root_modulus(double x, double y) {
    const double square = x * x + y * y;
    if (!(square > 1e-120)) return 0;
    return std::sqrt(std::sqrt(square));
  }

  /**
  A contact acts on its two beads with opposite forces, so each is computed once: walking along the chain
  we keep that of the contact behind and find that of the contact in front. Real and imaginary parts
  alternate in `a` and `da`, because the integrators know real numbers only. */
  void operator()(double, const double* a, double* da) const {
    double re = 0, im = 0;
    if (near_end == Ends::fixed) {
      const double m = root_modulus(a[0], a[1]);
      re = m * a[0];
      im = m * a[1];
    }
    for (std::size_t n = 0; n < sites; ++n) {
      double re_next = 0, im_next = 0;
      if (n + 1 < sites) {
        const double x = a[2 * n + 2] - a[2 * n], y = a[2 * n + 3] - a[2 * n + 1];
        const double m = root_modulus(x, y);
        re_next = m * x;
        im_next = m * y;
      }
      da[2 * n] = rate * (im_next - im);
      da[2 * n + 1] = -rate * (re_next - re);
      re = re_next;
      im = im_next;
    }
  }
};

/**
The method of integration knows nothing of the two conserved quantities, so their drift is an independent
check of every run. The figures show the density $|A_n|^2$, whose sum is the norm. */
/// Norm sum |A_n|^2, conserved.
inline double norm(const Field& field) {
  double sum = 0;
  for (const auto& a : field) sum += std::norm(a);
  return sum;
}

/// Energy 2/5 sum |A_{n+1} - A_n|^{5/2} with free ends, conserved.
inline double energy(const Field& field) {
  double sum = 0;
  for (std::size_t n = 0; n + 1 < field.size(); ++n) {
    const double d = std::abs(field[n + 1] - field[n]);
    sum += 0.4 * (d * d * std::sqrt(d));
  }
  return sum;
}

/// |A_n|^2, one entry per site.
inline std::vector<double> density(const Field& field) {
  std::vector<double> d;
  for (const auto& a : field) d.push_back(std::norm(a));
  return d;
}

/**
A DpS field describes the chain by way of Eq. (13). An impact on the first bead becomes a field with a
single nonzero entry, and `dps_state` leads back to displacements and velocities, which can be compared
with those of the chain itself. */
/// Impact on the first of `sites`: A_1(0) = -i, all others zero (Eq. (25)).
inline Field dps_impact(std::size_t sites) {
  Field field(sites);
  field[0] = {0, -1};
  return field;
}

/// The approximation of the chain that a DpS field stands for, Eq. (13), at time `t`. Velocities
/// keep the leading order only, as the approximation does.
inline State<double> dps_state(const Field& field, double eps, double t) {
  State<double> state(field.size());
  const std::complex<double> phase(std::cos(t), std::sin(t));
  for (std::size_t n = 0; n < field.size(); ++n) {
    state.y[n] = 2 * eps * (field[n] * phase).real();
    state.v[n] = -2 * eps * (field[n] * phase).imag();
  }
  state.t = t;
  return state;
}

}  // namespace lattice
