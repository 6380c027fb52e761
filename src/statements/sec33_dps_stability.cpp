/**
# Statements of section 3.3: Stability of the DpS breathers */

#include <string>

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("dps.bond_stable") {
  for (double mu : {1.0, 10.0}) less(table("margins").at("centre", "bond", "mu", mu)["margin"], 0);
}

STATEMENT("dps.site_growth") {
  const Data growth = table("growth").where("mu", 1e-3, 1e3);
  for (const auto& breather : growth) less(0, breather["margin"]);
  const auto slope = [](const Data::Row& breather) { return breather["rate"] / breather("mu"); };
  less(largest(growth, slope) / least(growth, slope) - 1, bound(1e-8));
}

STATEMENT("dps.instability_moves") {
  const Data runs = table("noise_runs").where("start", "site");
  // Nearly all leave their place, and most pass the next site
  const auto moves = [&](const std::string& noise) {
    const Data all = runs.where("noise", noise).where("seed", 1, 16);
    less(1 - bound(0.1), mean(all, "left"));
    less(1 - bound(0.5), mean(all, "moved"));
  };
  moves("main");
  for (const char* noise : {"narrow", "real", "relative"}) reading(noise, [&] { moves(noise); });

  // Without the translational mode the same noise acts later
  less(1 - bound(0.25), mean(table("controls").where("seed", 1, 16), "later"));
}

STATEMENT("dps.bond_robust") {
  const Data runs = table("noise_runs").where("start", "bond");
  // How many leave their bond
  const auto leave = [&](const char* noise, int seeds) {
    return Quantity{{mean(runs.where("noise", noise).where("seed", 1, seeds), "left")},
                    "of the breathers leave their bond"};
  };
  answer(leave("main", 64));
  for (const char* noise : {"narrow", "real", "relative"}) reading(noise, leave(noise, 16));
  control([&] {  // it does not spread
    for (const auto& run : runs) less(run["spread"], 1.1);
  });
}
