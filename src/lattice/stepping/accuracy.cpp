#include "lattice/stepping/accuracy.hpp"

namespace lattice {

double distance(const State<double>& a, const State<double>& b) {
  if (a.t != b.t || a.y.size() != b.y.size()) return std::numeric_limits<double>::infinity();
  double apart = 0, scale = 0;
  for (std::size_t n = 0; n < a.y.size(); ++n) {
    apart = std::max({apart, std::abs(a.y[n] - b.y[n]), std::abs(a.v[n] - b.v[n])});
    scale = std::max({scale, std::abs(b.y[n]), std::abs(b.v[n])});
  }
  return scale > 0 ? apart / scale : apart;
}

ContactAware stepper_for(double tolerance, double step, int halvings) {
  ContactAware stepper{step};
  if (tolerance < 1e-10) stepper.base = nystrom(blanes_moan_6_14());
  stepper.halvings = halvings;
  return stepper;
}

bool hopeless(double error, double tolerance, int halvings) {
  const int left = std::ilogb(largest_step / smallest_step) - halvings;
  return halvings >= 3 && std::isfinite(error) && std::ldexp(error, -6 * left) > tolerance;
}

}  // namespace lattice
