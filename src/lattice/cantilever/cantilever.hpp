#pragma once
/**
# Decorated cantilevers

The array of section 3.6 is a row of elastic beams, each clamped at both ends and carrying two beads at its middle, with
which it touches the beads of its neighbours. If each beam is described by its largest deflection $x_n$ alone, the
Hamiltonian is that of Eq. (31),
$$H = \sum_n \frac{m_n}{2}\,\dot x_n^2 + \frac k2\,x_n^2 + \frac25\,\gamma_n\,(x_n-x_{n+1})_+^{5/2}.$$
This file derives the coefficients from beam theory and Hertz's law, in SI units, and those of Eq. (32). */

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "lattice/model/chain.hpp"

namespace lattice {

/**
The article replaces each beam by a spring and a point mass, with the rounded factors 192 and 0.38.
To see what that costs we solve the beam itself. One of length $\ell$, bending stiffness $EI$ and
mass $\rho A$ per unit length that vibrates with frequency $\omega$ obeys $EI\,u'''' = \rho A\,\omega^2 u$.
In units of $\ell$, with $x^4 = \rho A\,\omega^2\ell^4/(EI)$, this is $u'''' = x^4 u$. A force $F$ at the
middle makes the shear force jump there, and by symmetry $F = -2\,u'''$ at the end of the left half. A
point mass of $p$ beam masses at the same place takes up $-p\,x^4 u$. Hence the stiffness against
such a force, in units of $EI/\ell^3$, is
$$k(x) = -\frac{2\,u'''}{u}-p\,x^4, \qquad u(0)=u'(0)=0,\quad u'(\tfrac12)=0.$$
The static stiffness is $k(0)$, and a free vibration has $k(x) = 0$. */
struct ClampedBeam {
  std::size_t steps = 400;  ///< of the classical Runge-Kutta method on half of the beam
  double point_mass = 0;    ///< at the middle, in units of the beam's mass

  using Section = std::array<double, 4>;  ///< u and its first three derivatives

  /// The solution of u'''' = x4 u at the middle of the beam, if it starts as `at` at the clamped end.
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

  /// Stiffness at the middle, in units of E I / l^3, at the dimensionless wavenumber x. Of the solutions that the
  /// clamped end leaves open, two are marched and combined into the one that has no slope at the middle.
  double stiffness(double x) const {
    const double x4 = x * x * x * x;
    const Section bent = march({0, 0, 1, 0}, x4), sheared = march({0, 0, 0, 1}, x4);
    const double u = sheared[1] * bent[0] - bent[1] * sheared[0];
    const double shear = sheared[1] * bent[3] - bent[1] * sheared[3];
    return -2 * shear / u - point_mass * x4;
  }

  /// The wavenumber of the slowest symmetric vibration, by bisection: 4.73 without a point mass, which lowers it. The
  /// next one, 11.0, lies beyond the bracket.
  double wavenumber() const {
    double low = 0.1, high = 6;
    for (int k = 0; k < 60; ++k) {
      const double middle = (low + high) / 2;
      (stiffness(middle) > 0 ? low : high) = middle;
    }
    return (low + high) / 2;
  }
};

/// The wavenumber of the beam without a point mass, the first positive root of cos x cosh x = 1.
double clamped_root();

/**
Two beads that collide at the speed $V$ touch for a time of order $\tau_h$ and are compressed by a length of order
$\delta$. The well adds the period $2\pi\tau_c$, and the displacement $\xi$ at which its force equals that of a contact:
$$\tau_h = \Bigl(\frac{m^2}{\gamma^2 V}\Bigr)^{1/5},\quad \delta = \Bigl(\frac{mV^2}{\gamma}\Bigr)^{2/5},\quad
\tau_c = \sqrt{m/k},\quad \xi = (k/\gamma)^2,\quad \lambda = \frac{m}{k\,\tau_h^2}.$$
In the units $\xi$ and $\tau_c$ the chain is that of Eq. (9), and the impact velocity is
$V\tau_c/\xi = \lambda^{5/2}$, Eqs. (29) and (30). Speeds $V$ below are in m/s, results in SI units. */
struct Scales {
  double m, k, gamma;  ///< kg, N/m, N/m^(3/2)

  /// Time 1/omega of a cantilever alone, s.
  double tau_c() const { return std::sqrt(m / k); }
  /// Unit of length: where Hertz's force equals that of the spring, m.
  double xi() const { return (k / gamma) * (k / gamma); }
  /// Duration of a Hertzian contact but for a factor of order one, s; `velocity` in m/s.
  double tau_h(double velocity) const { return std::pow(m * m / (gamma * gamma * velocity), 0.2); }
  /// Compression of such a contact but for a factor of order one, m.
  double delta(double velocity) const { return std::pow(m * velocity * velocity / gamma, 0.4); }
  /// (tau_c / tau_h)^2, Eq. (29); small where a bead swings many times while a contact lasts.
  double lambda(double velocity) const { return m / (k * tau_h(velocity) * tau_h(velocity)); }
  /// The velocity that is one in the units of Eq. (9), m/s.
  double unit_velocity() const { return xi() / tau_c(); }
  /// The force that is one, N.
  double unit_force() const { return k * xi(); }
  /// The energy that is one, J.
  double unit_energy() const { return k * xi() * xi(); }

  /// Milliseconds to units of tau_c.
  double time(double ms) const { return ms * 1e-3 / tau_c(); }
  /// Units of tau_c to milliseconds.
  double milliseconds(double t) const { return t * tau_c() * 1e3; }
  /// Metres per second to units of the chain.
  double velocity(double si) const { return si / unit_velocity(); }
  /// A displacement of the chain in micrometres.
  double micrometres(double y) const { return y * xi() * 1e6; }
  /// A rate of the chain in 1/s.
  double per_second(double rate) const { return rate / tau_c(); }
  /// A power of the chain in watts.
  double watts(double power) const { return unit_energy() * per_second(power); }
  /// A frequency in hertz as an angular one of the chain.
  double omega(double hertz) const { return 2 * std::numbers::pi * hertz * tau_c(); }
  /// An angular frequency of the chain in hertz.
  double hertz(double omega) const { return omega / (2 * std::numbers::pi * tau_c()); }
  /// The damping rate nu for a lifetime of the energy in ms; zero means no damping.
  double rate(double lifetime) const { return lifetime > 0 ? 1 / time(lifetime) : 0; }
};

/// The array by its materials and dimensions: steel beams and teflon beads, all equal but for one cantilever, whose
/// beads have `ratio` times the usual radius, the article's R_n in units of R.
struct CantileverArray {
  std::size_t sites = 200;
  std::size_t defect = 100;  ///< site whose beads have another radius, counted from one
  double beam_density = 8e3, beam_modulus = 193e9;                ///< kg/m^3, Young's modulus in Pa
  double length = 25e-3, width = 5e-3, thickness = 1e-3;          ///< of a beam, m
  double bead_density = 2.2e3, bead_modulus = 1.46e9, nu = 0.46;  ///< kg/m^3, Pa, Poisson's ratio
  double radius = 2.38e-3;                                        ///< of a bead, m
  double beam_share = 0.38;  ///< effective mass of a beam over its mass, as printed

  /// Second moment of area of a beam's cross section, m^4.
  double area_moment() const { return width * thickness * thickness * thickness / 12; }
  double beam_mass() const { return beam_density * width * thickness * length; }
  /// Mass of one bead; a cantilever carries two.
  double bead_mass(double ratio = 1) const {
    const double r = radius * ratio;
    return 4 * std::numbers::pi / 3 * bead_density * (r * r * r);
  }
  /// Effective mass of a cantilever whose beads have `ratio` times the usual radius.
  double mass(double ratio = 1) const { return beam_share * beam_mass() + 2 * bead_mass(ratio); }
  /// Stiffness of a beam clamped at both ends under a force at its middle, N/m.
  double stiffness() const {
    return 192 * beam_modulus * area_moment() / (length * length * length);
  }
  /// Hertz's coefficient of two beads of radius R and the given Young's modulus (Pa), in N/m^(3/2).
  double gamma(double modulus) const {
    return modulus * std::sqrt(2 * radius) / (3 * (1 - nu * nu));
  }
  /// Mass, stiffness and Hertz's coefficient of the cantilevers without a defect.
  Scales scales() const { return {mass(), stiffness(), gamma(bead_modulus)}; }

  /// mu_n of the defect in Eq. (32): its mass over that of the other cantilevers.
  double mu(double ratio) const { return mass(ratio) / mass(); }
  /// Frequency of the defect without its contacts, over that of the other cantilevers.
  double linear_frequency(double ratio) const { return 1 / std::sqrt(mu(ratio)); }
  /// eta_n of its two contacts in Eq. (32).
  static double eta(double ratio) { return std::sqrt(2 * ratio / (1 + ratio)); }
};

/// A constant of the array with name and unit.
struct NamedScale {
  const char *name, *unit;
  double value;
};

/// What an experimenter chooses, materials and dimensions.
std::vector<NamedScale> given_scales(const CantileverArray& a);

/// The chain of Eq. (32) with one larger bead: its cantilever is heavier and both its contacts are stiffer,
/// eta_n = [2 R_n R_{n+1} / (R_n + R_{n+1})]^{1/2} with radii in units of R.
Chain cantilever_chain(const CantileverArray& array, double ratio);

}  // namespace lattice
