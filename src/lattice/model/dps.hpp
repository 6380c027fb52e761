#pragma once
/**
# The discrete p-Schrödinger equation

At small amplitude the contacts are much weaker than the wells. Every bead then oscillates at the
frequency of its well, and the contacts change its complex amplitude $A_n$ only slowly. With Eq. (13),
$$y_n(t) = 2\epsilon\,\mathrm{Re}\,[A_n(\tau)\,e^{it}],\qquad \tau = \epsilon^{\alpha-1}t,$$
averaging over the fast oscillation gives an equation in the slow time $\tau$, the discrete p-Schrödinger
(DpS) equation, Eq. (12),
$$2i\tau_0\,\dot A_n = D_n - D_{n-1}, \qquad
  D_n = (A_{n+1}-A_n)\,|A_{n+1}-A_n|^{\alpha-1}.$$
The article's contacts are those of spheres, $\alpha = 3/2$; here the force may grow with any power
$\alpha > 1$ of the overlap. The equation has no linear part, conserves the norm $\sum|A_n|^2$ and the energy
$\frac1{\alpha+1}\sum|A_{n+1}-A_n|^{\alpha+1}$, and does not contain $\epsilon$. */

#include <complex>
#include <cstddef>
#include <vector>

#include "lattice/model/chain.hpp"

namespace lattice {

/**
A contact pushes during one half of the period only, and of its push the part at the frequency of the wells has
a lasting effect. Its mean gives the time constant,
$$\frac1{\tau_0} = \frac1{2\pi}\int_{-\pi/2}^{\pi/2}(2\cos t)^\alpha\cos t\,dt
  = \frac{2^{\alpha-1}\,\Gamma(\frac\alpha2+1)}{\sqrt\pi\,\Gamma(\frac{\alpha+3}2)},\qquad
  \tau_0\bigl(\tfrac32\bigr) = \frac{5\,\Gamma(\frac14)^2}{24\sqrt\pi}.$$
A static breather turns with $\omega_b = 1 + \epsilon^{\alpha-1}/(2\tau_0)$. */
/// Time constant of the DpS equation for contacts of exponent `alpha`, that of spheres as below Eq. (12).
double tau_0(double alpha = 1.5);

/// The amplitude scale epsilon of the static breathers of frequency `omega_b`, Eq. (20) inverted.
double breather_eps(double omega_b, double alpha = 1.5);

/// The complex amplitudes A_n, one entry per site.
using Field = std::vector<std::complex<double>>;

/// The right-hand side as a function. What stands in for the missing neighbour at the first site is no contact (free),
/// A_0 = 0 (fixed) or the last site (periodic); otherwise the far end is free. Differences below 1e-60 count as zero, for
/// the reason given at `Hertz` in contact.hpp.
struct Dps {
  std::size_t sites;
  Ends near_end = Ends::free;               ///< at the first site
  double exponent = 1.5;                    ///< alpha > 1, of the contact force
  double rate = 1 / (2 * tau_0(exponent));  ///< inverse time constant

  /// Writes dA/dtau into `da`. Real and imaginary parts alternate in `a` and `da`, because the
  /// integrators know real numbers only.
  void operator()(double tau, const double* a, double* da) const;
};

/// Norm sum |A_n|^2, conserved.
double norm(const Field& field);

/// Energy sum |A_{n+1} - A_n|^{alpha+1} / (alpha + 1), conserved; a ring has the contact of last and first
/// site too.
double energy(const Field& field, bool ring = false, double alpha = 1.5);

/// |A_n|^2, one entry per site.
std::vector<double> density(const Field& field);

/// Impact on the first of `sites`: A_1(0) = -i, all others zero (Eq. (25)).
Field dps_impact(std::size_t sites);

/// The approximation of the chain that a DpS field stands for, Eq. (13), at time `t`. Velocities
/// keep the leading order only.
State<double> dps_state(const Field& field, double eps, double t);

}  // namespace lattice
