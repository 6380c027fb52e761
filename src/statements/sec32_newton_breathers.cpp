/**
# Statements: 3.2 static breathers of the chain */

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
  less(fact("continuum_101_site"), fact("continuum_110_site"));
  less(fact("continuum_101_bond"), fact("continuum_110_bond"));
}

STATEMENT("newton.energy_equal") {
  answer(fact("largest_energy_difference"));
}

STATEMENT("newton.symmetry") {
  less(fact("broken_symmetry"), 1e-9);
}

STATEMENT("newton.any_s") {
  less(fact("growth_exponent_off"), 0.05);
}

STATEMENT("newton.grows") {
  less(1, fact("least_growth"));
}

STATEMENT("newton.site_asymmetry") {
  less(1, fact("asymmetry_least_growth"));
}

STATEMENT("newton.amplitude_differs") {
  answer(fact("largest_amplitude_difference"));
}

STATEMENT("chain.width_constant") {
  answer(fact("width_change"));
}
