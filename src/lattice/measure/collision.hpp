#pragma once
/**
# Two beads collide

Bead 1 runs into bead 2 at rest with $V = 1$, in units in which $m = \gamma = 1$; nothing else holds them. Their
masses are equal, so they exchange their velocities: after the contact bead 1 rests. The centre of
mass has moved at $V/2$ all the time, hence bead 1 has come to rest at half the contact time: no event
needs to be found. The compression is largest at half of that time. */

#include <cmath>
#include <numbers>

#include "lattice/measure/impact.hpp"

namespace lattice {

/// Contact time and largest compression, in units of tau_h and delta (see cantilever.hpp).
struct Collision {
  double contact_time, compression;
};

inline Collision collide(double step) {
  const Chain<None, Hertz> beads{2};
  State<double> after = struck(2, 1), middle = after;
  evolve(ContactAware{step}, beads, after, 4, 4, Unobserved{});
  const double contact = 2 * after.y[0];
  evolve(ContactAware{step}, beads, middle, contact / 2, contact / 2, Unobserved{});
  return {contact, middle.y[0] - middle.y[1]};
}

/**
Energy says the same without any integration. The relative motion carries $\frac12\cdot\frac m2 V^2$, and
all of it is in the contact when the compression is largest: $\frac25\gamma\,x^{5/2} = \frac14 m V^2$, so
$x = (5/8)^{2/5}\,\delta$. The time follows from $\dot x$ by a quadrature,
$$t = \frac{2x}{V}\int_0^1\frac{ds}{\sqrt{1-s^{5/2}}} = \frac{4\sqrt\pi}{5}\,
\frac{\Gamma(2/5)}{\Gamma(9/10)}\,\Bigl(\frac58\Bigr)^{2/5}\tau_h.$$ */
inline Collision collision_by_energy() {
  const double x = std::pow(0.625, 0.4);
  const double quadrature = 0.4 * std::sqrt(std::numbers::pi) * std::tgamma(0.4) / std::tgamma(0.9);
  return {2 * x * quadrature, x};
}

/**
A cradle's pendulum is slow beside such a collision. With $k/m = g/L$ the ratio of the times enters as
$\lambda^{5/2} = (L/(g\,\tau_h^2))^{5/2}$, and $\tau_h$ follows from a contact time measured in
seconds and the same time in units of $\tau_h$. */
inline double cradle_ratio(double gravity, double length, double measured, double contact_time) {
  const double tau_h = measured / contact_time, lambda = length / (gravity * tau_h * tau_h);
  return lambda * lambda * std::sqrt(lambda);
}

}  // namespace lattice
