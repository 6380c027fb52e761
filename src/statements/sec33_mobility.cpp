/**
# Statements of section 3.3: Kicked breathers and the depinning threshold */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("moving.v_site") {
  answer(table("strong_kicks").at("breather", "site")["speed"]);
}

STATEMENT("moving.v_bond") {
  answer(table("strong_kicks").at("breather", "bond_stretched")["speed"]);
}

STATEMENT("moving.steady") {
  const Data kicks = table("strong_kicks");
  answer(larger(kicks.at("breather", "site")["unsteadiness"],
                kicks.at("breather", "bond_stretched")["unsteadiness"]),
         "relative");
}

STATEMENT("moving.dispersion") {
  const Data kicks = table("strong_kicks");
  answer(larger(kicks.at("breather", "site")["outside"],
                kicks.at("breather", "bond_stretched")["outside"]),
         "of the energy");
}

STATEMENT("moving.kick_energy") {
  answer(table("strong_kicks").at("breather", "bond_stretched")["kick"]);
}

STATEMENT("moving.site_below") {
  answer(table("weak_kicks").at("breather", "site")["farthest"]);
}

STATEMENT("moving.bond_pinned") {
  for (const char* bond : {"bond_stretched", "bond_compressed"}) {
    const auto kick = table("weak_kicks").at("breather", bond);
    less(kick["farthest"], 0.45);  // the next site is half a site away
    less(0.02, kick["came_back"]);
  }
}

STATEMENT("moving.c_threshold") {
  answer(table("thresholds").at("breather", "bond_stretched")["threshold"]);
}

STATEMENT("moving.pn_dynamic") {
  answer(table("thresholds").at("breather", "bond_stretched")["energy"]);
}

STATEMENT("moving.barrier_close") {
  answer(table("thresholds").at("breather", "bond_stretched")["over_barrier"]);
}

STATEMENT("depinning.law") {
  // Predicted and found are equal to a thousandth
  const auto bond = table("thresholds").at("breather", "bond_stretched");
  for (const char* threshold : {"predicted", "threshold"})
    within(bond[threshold], 4.45e-6, 4.453e-6);
  less(bond["kinetic_share"], 0);  // the effective mass of the translation is negative
}
