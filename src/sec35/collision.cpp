#include "sec35/collision.hpp"

#include <cmath>
#include <numbers>

namespace lattice {

Collision collision_by_energy() {
  const double x = std::pow(0.625, 0.4);
  const double quadrature = 0.4 * std::sqrt(std::numbers::pi) * std::tgamma(0.4) / std::tgamma(0.9);
  return {2 * x * quadrature, x};
}

double cradle(double gravity, double contact_time) {
  const double length = 0.5, tau_h = 0.077e-3 / contact_time;  // m, s
  const double lambda = length / (gravity * tau_h * tau_h);
  return lambda * lambda * std::sqrt(lambda);
}

}  // namespace lattice
