#include "lattice/model/cantilever.hpp"

namespace lattice {

// The lowest mode of a beam clamped at both ends: cos x cosh x = 1, by Newton's method
double clamped_root() {
  double x = 4.7;
  for (int k = 0; k < 8; ++k)
    x -= (std::cos(x) * std::cosh(x) - 1) /
         (std::cos(x) * std::sinh(x) - std::sin(x) * std::cosh(x));
  return x;
}

// What an experimenter chooses: the beams, the beads and their materials
std::vector<NamedScale> given_scales(const CantileverArray& a) {
  return {{"beam_density", "kg/m^3", a.beam_density},
          {"beam_modulus", "Pa", a.beam_modulus},
          {"length", "m", a.length},
          {"width", "m", a.width},
          {"thickness", "m", a.thickness},
          {"bead_density", "kg/m^3", a.bead_density},
          {"bead_modulus", "Pa", a.bead_modulus},
          {"poisson_ratio", "", a.nu},
          {"bead_radius", "m", a.radius}};
}

// What follows for the model: masses, stiffnesses, and the scales of time, length and energy
std::vector<NamedScale> derived_scales(const CantileverArray& a, double v) {
  const Scales s = a.scales();
  const double lambda = s.lambda(v);
  return {{"area_moment", "m^4", a.area_moment()},
          {"beam_mass", "kg", a.beam_mass()},
          {"bead_mass", "kg", a.bead_mass()},
          {"effective_mass", "kg", s.m},
          {"stiffness", "N/m", s.k},
          {"gamma", "N/m^(3/2)", s.gamma},
          {"tau_h", "s", s.tau_h(v)},
          {"tau_c", "s", s.tau_c()},
          {"linear_period", "s", 2 * std::numbers::pi * s.tau_c()},
          {"delta", "m", s.delta(v)},
          {"hertz_stiffness", "N/m", s.gamma * std::sqrt(s.delta(v))},
          {"xi", "m", s.xi()},
          {"lambda", "", lambda},
          {"lambda_5_2", "", lambda * lambda * std::sqrt(lambda)},
          {"unit_velocity", "m/s", s.unit_velocity()},
          {"unit_force", "N", s.unit_force()},
          {"unit_energy", "J", s.unit_energy()}};
}

// The defect has a mass of its own, and contacts of its own with both neighbours
Chain cantilever_chain(const CantileverArray& array, double ratio) {
  Chain chain{array.sites};
  std::vector<double> mass(array.sites, 1.0), eta(array.sites + 1, 1.0);
  mass[array.defect - 1] = array.mu(ratio);
  eta[array.defect - 1] = eta[array.defect] = CantileverArray::eta(ratio);
  vary(chain, mass, eta);
  return chain;
}

}  // namespace lattice
