/**
# Statements: 3.3 kicked breathers and the depinning threshold */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("moving.v_site") {
  answer(fact("speed_site"));
}

STATEMENT("moving.v_bond") {
  answer(fact("speed_bond_stretched"));
}

STATEMENT("moving.kick_energy") {
  answer(fact("kick_energy"));
}

STATEMENT("moving.site_below") {
  answer(fact("travelled_site"));
}

STATEMENT("moving.bond_pinned") {
  less(fact("farthest_bond_stretched"), 0.45);
  less(0.02, fact("came_back_bond_stretched"));
  less(fact("farthest_bond_compressed"), 0.45);
  less(0.02, fact("came_back_bond_compressed"));
}

STATEMENT("moving.c_threshold") {
  answer(fact("threshold_bond_stretched"));
}

STATEMENT("moving.pn_dynamic") {
  answer(fact("threshold_energy_bond_stretched"));
}

STATEMENT("moving.steady") {
  answer(fact("unsteadiness"));
}

STATEMENT("moving.barrier_close") {
  answer(fact("barrier_ratio"));
}

STATEMENT("moving.dispersion") {
  answer(fact("dispersion"));
}

STATEMENT("depinning.law") {
  within(fact("predicted_threshold_bond_stretched"), 4.45e-6, 4.453e-6);
  within(fact("threshold_bond_stretched"), 4.45e-6, 4.453e-6);
  less(fact("kinetic_share_bond_stretched"), 0);
}
