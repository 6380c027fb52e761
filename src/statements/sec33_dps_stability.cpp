/**
# Statements of section 3.3: Stability of the DpS breathers */

#include "report/statement.hpp"

using namespace lattice;

/// A sign has to hold with a hundredfold error.
static Estimate hundredfold(const Estimate& margin) {
  return {margin.value, 100 * margin.error};
}

STATEMENT("dps.bond_stable") {
  for (double mu : {1.0, 10.0})
    less(hundredfold(table("margins").at("centre", "bond", "mu", mu)["margin"]), 0);
}

STATEMENT("dps.site_growth") {
  const Data growth = table("growth").where("mu", 1e-3, 1e3);
  for (const auto& breather : growth) less(0, hundredfold(breather["margin"]));
  const auto slope = [](const Data::Row& breather) { return breather["rate"] / breather("mu"); };
  less(largest(growth, slope) / least(growth, slope) - 1, 1e-8);

  // Over six decades
  near(slope(growth.at("mu", 1e3)) / slope(growth.at("mu", 1e-3)), 1, 1e-8);
}

STATEMENT("dps.instability_moves") {
  const Data runs = table("noise_runs").where("start", "site");
  const Data narrow = runs.where("noise", "narrow").where("seed", 1, 16),
             main = runs.where("noise", "complex").where("seed", 1, 16);
  less(0.9, mean(narrow, "left"));
  less(0.5, mean(narrow, "moved"));

  // The same noise acts later without the translational mode
  less(0.75, mean(table("controls").where("seed", 1, 16), "later"));
  const Data main_noise = table("departures").where("noise", "complex");
  less(2, main_noise.at("start", "control")["passage"] / main_noise.at("start", "site")["passage"]);

  // Both tolerances agree on which breathers move
  for (const Data& noise : {narrow, main})
    for (const auto& run : noise) less(run["torn"], 0.5);
}

STATEMENT("dps.bond_robust") {
  const Data runs = table("noise_runs"),
             narrow = runs.where("noise", "narrow").where("seed", 1, 16);
  less(mean(narrow.where("start", "bond"), "left"), 0.1);
  less(0.9, mean(narrow.where("start", "site"), "left"));
  for (const auto& run : runs.where("start", "bond")) less(run["spread"], 2);
}
