/**
# Statements of section 3.3: Kicked breathers and the depinning threshold */

#include <string>

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
  for (const std::string kick : {"bond_stretched", "bond_compressed"}) {
    less(fact("farthest_" + kick), 0.45);  // the next site is half a site away
    less(0.02, fact("came_back_" + kick));
  }
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
  // Predicted and found are equal to a thousandth
  for (const char* threshold : {"predicted_threshold_bond_stretched", "threshold_bond_stretched"})
    within(fact(threshold), 4.45e-6, 4.453e-6);
  less(fact("kinetic_share_bond_stretched"),
       0);  // the effective mass of the translation is negative
}
