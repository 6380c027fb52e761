/**
# Statements of section 3.2: Static breathers of the chain */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("newton.residual") {
  answer(fact("residual"));
}

STATEMENT("newton.variation") {
  answer(fact("variation"));
}

STATEMENT("newton.persistence") {
  answer(fact("persistence"));
}

STATEMENT("newton.decay") {
  within(fact("tail_exponent"), 1.495, 1.505);
}

STATEMENT("newton.qc_small") {
  for (const char* centre : {"site", "bond"}) {
    const Data profiles = table("approximation").where("centre", centre);
    less(profiles.at("omega", 1.01)["difference"], profiles.at("omega", 1.1)["difference"]);
  }
}

STATEMENT("newton.energy_equal") {
  answer(fact("largest_energy_difference"));
}

STATEMENT("newton.symmetry") {
  for (const char* centre : {"site", "bond"})
    less(table("symmetry").at("centre", centre)["broken"], 1e-9);
}

STATEMENT("newton.any_s") {
  // From the origin the amplitude grows like (omega_b - 1)^2
  for (double s : {-1.0, -0.5, 0.5, 1.0})
    for (const char* centre : {"site", "bond"})
      near(table("other_wells").at("s", s, "centre", centre)["exponent"], 2, 0.05);
}

STATEMENT("newton.grows") {
  for (const char* size : {"amplitude_site", "energy_site", "amplitude_bond", "energy_bond"})
    increases(table("branches"), "omega", size);
}

STATEMENT("newton.site_asymmetry") {
  increases(table("branches"), "omega", "asymmetry");
}

STATEMENT("newton.amplitude_differs") {
  answer(fact("largest_amplitude_difference"));
}

STATEMENT("chain.width_constant") {
  answer(fact("width_change"));
}
