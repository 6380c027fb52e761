#pragma once
/**
# Two beads collide, in closed form

All of the relative motion's $\frac12\cdot\frac m2 V^2$ is in the contact when the compression is largest:
$\frac25\gamma\,x^{5/2} = \frac14 m V^2$, so $x = (5/8)^{2/5}\,\delta$. A quadrature of $1/\dot x$ is the contact time,
$$t = \frac{2x}{V}\int_0^1\frac{ds}{\sqrt{1-s^{5/2}}} = \frac{4\sqrt\pi}{5}\,
\frac{\Gamma(2/5)}{\Gamma(9/10)}\,\Bigl(\frac58\Bigr)^{2/5}\tau_h.$$ */

#include <cmath>
#include <numbers>

namespace lattice {

/// Contact time and largest compression, in units of tau_h and delta (see cantilever.hpp).
struct Collision {
  double contact_time, compression;
};

/// Both from the conservation of energy, in closed form.
inline Collision collision_by_energy() {
  const double x = std::pow(0.625, 0.4);
  const double quadrature = 0.4 * std::sqrt(std::numbers::pi) * std::tgamma(0.4) / std::tgamma(0.9);
  return {2 * x * quadrature, x};
}

/// The article's cradle: length of its strings, and how long a collision of its beads was measured to take.
struct Cradle {
  double length = 0.5, collision = 0.077e-3;  ///< m, s

  /// lambda^(5/2) = (L / (g tau_h^2))^(5/2), for gravity in m/s^2 and the contact time in units of tau_h.
  double lambda_5_2(double gravity, double contact_time) const {
    const double tau_h = collision / contact_time;
    const double lambda = length / (gravity * tau_h * tau_h);
    return lambda * lambda * std::sqrt(lambda);
  }
};

}  // namespace lattice
