/**
# Statements of section 3.3: Breathers between a site and a bond */

#include <string>

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("exchange.six") {
  // Six exchanges one after the other, of which the first is near 1 and the last below 1.5
  const auto window = [&](int k) { return fact("window_" + std::to_string(k)); };
  less(window(1), 1.02);
  for (int k = 1; k < 6; ++k) less(window(k), window(k + 1));
  less(window(6), 1.5);

  // Meanwhile all other multipliers stay on the circle
  for (const auto& breather :
       table("sec33_floquet", "spectra").where("s", 0).where("omega", 1.01, 2))
    less(breather["others"], 1e-3);
}

STATEMENT("exchange.between") {
  // In s: the third breather exists where the others are both stable, and is unstable
  less(1e-7, fact("width_between_in_s"));
  less(0, fact("kappa_between_in_s"));
  less(1, fact("largest_modulus_between_in_s"));

  // In omega_b: where both are unstable, and it is stable
  less(fact("width_between_in_omega"), 0);
  less(fact("kappa_between_in_omega"), 0);
  less(fact("largest_modulus_between_in_omega"), 1.000000001);
  for (const auto& breather :
       table("sec33_floquet", "spectra").where("omega", 1.1).where("s", -1, 1))
    less(breather["off_circle"], 0.5);
}
