#include "sec35/collision.hpp"

#include <cmath>
#include <numbers>

#include "lattice/impact/impact.hpp"

namespace lattice {

Collision collide(double step) {
  const Chain beads{2, None{}};
  State<double> after = struck(2, 1), middle = after;
  evolve(EventCorrected{step}, beads, after, 4, 4);
  const double contact = 2 * after.y[0];
  evolve(EventCorrected{step}, beads, middle, contact / 2, contact / 2);
  return {contact, middle.y[0] - middle.y[1]};
}

Collision collision_by_energy() {
  const double x = std::pow(0.625, 0.4);
  const double quadrature = 0.4 * std::sqrt(std::numbers::pi) * std::tgamma(0.4) / std::tgamma(0.9);
  return {2 * x * quadrature, x};
}

double cradle_ratio(double gravity, double length, double measured, double contact_time) {
  const double tau_h = measured / contact_time, lambda = length / (gravity * tau_h * tau_h);
  return lambda * lambda * std::sqrt(lambda);
}

}  // namespace lattice
