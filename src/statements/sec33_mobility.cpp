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
  const std::pair<const char*, double> breathers[] = {{"X_bond_stretched", 1.7e5},
                                                      {"X_bond_compressed", 8e4}};
  for (const auto& [breather, end] : breathers) {
    const Data path = table("paths").where("t", 0, end);
    const auto way = [&, X = breather](const Data::Row& at) {
      return abs(at[X] - path.begin()[0][X]);
    };
    for (const auto& at : path) less(way(at), 0.45);  // the next site is half a site away
    less(0.02, largest(path, way) - way(path.end()[-1]));
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
  for (const char* threshold : {"predicted_threshold_bond_stretched", "threshold_bond_stretched"})
    within(fact(threshold), 4.45e-6, 4.453e-6);
  less(fact("kinetic_share_bond_stretched"), 0);  // so the mass is negative
}
