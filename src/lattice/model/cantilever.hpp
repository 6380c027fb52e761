#pragma once
/**
# Decorated cantilevers

A beam clamped at both ends carries two beads at its middle, and touches the beads of its neighbours
with them. Reduced to its largest deflection $x_n$, an array of such beams has the
Hamiltonian of Eq. (31),
$$H = \sum_n \frac{m_n}{2}\,\dot x_n^2 + \frac k2\,x_n^2 + \frac25\,\gamma_n\,(x_n-x_{n+1})_+^{5/2}.$$
This file derives its coefficients from the theory of beams and from Hertz's law, in SI units,
and makes of them the dimensionless chain of Eq. (32). */

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "lattice/model/chain.hpp"

namespace lattice {

/**
## The beam

A beam that vibrates with frequency $\omega$ obeys $EI\,u'''' = \rho A\,\omega^2 u$. We measure lengths in
units of $\ell$ and put $x^4 = \rho A\,\omega^2\ell^4/(EI)$, so that $u'''' = x^4 u$. A force $F$ at the middle
makes the shear jump, and by symmetry $F = -2\,u'''$ at the end of the left half. What a point
mass of $\kappa$ beam masses at that place needs is $-\kappa x^4 u$. Hence the stiffness, in units of $EI/\ell^3$, is
$$k(x) = -\frac{2\,u'''}{u}-\kappa\,x^4, \qquad u(0)=u'(0)=0,\quad u'(\tfrac12)=0,$$
the static one is $k(0)$, and a free vibration has $k(x) = 0$. */
struct ClampedBeam {
  std::size_t steps = 400;  ///< of the classical Runge-Kutta method on half of the beam
  double point_mass = 0;    ///< at the middle, in units of the beam's mass

  using Section = std::array<double, 4>;  ///< u and its first three derivatives

  /// The solution that starts as `at`, at the middle of the beam.
  Section march(Section at, double x4) const {
    const double h = 0.5 / double(steps);
    const auto rate = [x4](const Section& s) { return Section{s[1], s[2], s[3], x4 * s[0]}; };
    const auto moved = [](Section s, const Section& by, double step) {
      for (std::size_t i = 0; i < 4; ++i) s[i] += step * by[i];
      return s;
    };
    for (std::size_t k = 0; k < steps; ++k) {
      const Section a = rate(at), b = rate(moved(at, a, h / 2)), c = rate(moved(at, b, h / 2)),
                    d = rate(moved(at, c, h));
      for (std::size_t i = 0; i < 4; ++i) at[i] += h / 6 * (a[i] + 2 * (b[i] + c[i]) + d[i]);
    }
    return at;
  }

  /// Stiffness at the middle, in units of E I / l^3, at the dimensionless wavenumber x.
  double stiffness(double x) const {
    const double x4 = x * x * x * x;
    const Section bent = march({0, 0, 1, 0}, x4), sheared = march({0, 0, 0, 1}, x4);
    const double u = sheared[1] * bent[0] - bent[1] * sheared[0];
    const double shear = sheared[1] * bent[3] - bent[1] * sheared[3];
    return -2 * shear / u - point_mass * x4;
  }

  /// The wavenumber of the slowest symmetric vibration, by bisection.
  double wavenumber() const {
    double low = 0.1, high = 6;
    for (int k = 0; k < 60; ++k) {
      const double middle = (low + high) / 2;
      (stiffness(middle) > 0 ? low : high) = middle;
    }
    return (low + high) / 2;
  }
};

/// First positive root of cos(x) cosh(x) = 1, the wavenumber of the beam without a mass, by Newton.
inline double clamped_root() {
  double x = 4.7;
  for (int k = 0; k < 8; ++k)
    x -= (std::cos(x) * std::cosh(x) - 1) /
         (std::cos(x) * std::sinh(x) - std::sin(x) * std::cosh(x));
  return x;
}

/**
## From SI to the chain

A bead that collides with its neighbour at the speed $V$ is in contact for a time of order $\tau_h$
and compressed by a length of order $\delta$; with the well come the period $2\pi\tau_c$ and the
displacement $\xi$ at which both forces are equal:
$$\tau_h = \Bigl(\frac{m^2}{\gamma^2 V}\Bigr)^{1/5},\quad \delta = \Bigl(\frac{mV^2}{\gamma}\Bigr)^{2/5},\quad
\tau_c = \sqrt{m/k},\quad \xi = (k/\gamma)^2,\quad \lambda = \frac{m}{k\,\tau_h^2}.$$
In the units $\xi$ and $\tau_c$ the chain is that of Eq. (9), and the impact velocity
is $V\tau_c/\xi = \lambda^{5/2}$, Eqs. (29) and (30). */
struct Scales {
  double m, k, gamma;  ///< kg, N/m, N/m^(3/2)

  double tau_c() const { return std::sqrt(m / k); }
  double xi() const { return (k / gamma) * (k / gamma); }
  double tau_h(double velocity) const { return std::pow(m * m / (gamma * gamma * velocity), 0.2); }
  double delta(double velocity) const { return std::pow(m * velocity * velocity / gamma, 0.4); }
  double lambda(double velocity) const { return m / (k * tau_h(velocity) * tau_h(velocity)); }
  double unit_velocity() const { return xi() / tau_c(); }
  double unit_force() const { return k * xi(); }
  double unit_energy() const { return k * xi() * xi(); }
};

/// An array of equal cantilevers, in SI units; the defaults are the article's steel and teflon.
struct CantileverArray {
  std::size_t sites = 200;
  std::size_t defect = 100;  ///< site whose beads have another radius, counted from one
  double beam_density = 8e3, beam_modulus = 193e9;                // kg/m^3, Pa
  double length = 25e-3, width = 5e-3, thickness = 1e-3;          // m
  double bead_density = 2.2e3, bead_modulus = 1.46e9, nu = 0.46;  // kg/m^3, Pa, 1
  double radius = 2.38e-3;                                        // m
  double beam_share = 0.38;  ///< effective mass of a beam over its mass, as printed

  double area_moment() const { return width * thickness * thickness * thickness / 12; }
  double beam_mass() const { return beam_density * width * thickness * length; }
  double bead_mass(double ratio = 1) const {
    const double r = radius * ratio;
    return 4 * std::numbers::pi / 3 * bead_density * (r * r * r);
  }
  /// Effective mass of a cantilever whose beads have `ratio` times the usual radius.
  double mass(double ratio = 1) const { return beam_share * beam_mass() + 2 * bead_mass(ratio); }
  double stiffness() const {
    return 192 * beam_modulus * area_moment() / (length * length * length);
  }
  /// Hertz's coefficient of two beads of radius R and the given Young's modulus.
  double gamma(double modulus) const {
    return modulus * std::sqrt(2 * radius) / (3 * (1 - nu * nu));
  }
  Scales scales() const { return {mass(), stiffness(), gamma(bead_modulus)}; }

  /// mu of the defect, and eta of its two contacts.
  double mu(double ratio) const { return mass(ratio) / mass(); }
  /// Frequency of the defect without its contacts, over that of the other cantilevers.
  double linear_frequency(double ratio) const { return 1 / std::sqrt(mu(ratio)); }
  static double eta(double ratio) { return std::sqrt(2 * ratio / (1 + ratio)); }
};

/**
A bead of radius $R_n$ makes its cantilever heavier and both its contacts stiffer,
$\eta_n = [2R_nR_{n+1}/(R_n+R_{n+1})]^{1/2}$ in units of $R$. */
inline Chain<Harmonic, Hertz> cantilever_chain(const CantileverArray& array, double ratio) {
  Chain<Harmonic, Hertz> chain{array.sites};
  std::vector<double> mass(array.sites, 1.0), eta(array.sites + 1, 1.0);
  mass[array.defect - 1] = array.mu(ratio);
  eta[array.defect - 1] = eta[array.defect] = CantileverArray::eta(ratio);
  vary(chain, mass, eta);
  return chain;
}

}  // namespace lattice
