#include "lattice/cantilever/cantilever.hpp"

namespace lattice {

// By Newton's method
double clamped_root() {
  double x = 4.7;
  for (int k = 0; k < 8; ++k)
    x -= (std::cos(x) * std::cosh(x) - 1) /
         (std::cos(x) * std::sinh(x) - std::sin(x) * std::cosh(x));
  return x;
}

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
