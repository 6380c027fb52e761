/**
# Statements of section 3.3: Stability of the DpS breathers */

#include "report/statement.hpp"

using namespace report;

STATEMENT("dps.bond_stable") {
  for (double mu : {1.0, 10.0}) less(table("margins").at("centre", "bond", "mu", mu)["margin"], 0);
}

STATEMENT("dps.site_growth") {
  const Data growth = table("margins").where("centre", "site").where("mu", 1e-3, 1e3);
  for (const auto& breather : growth) less(0, breather["margin"]);
  const auto slope = [](const Data::Row& breather) { return breather["exponent"]; };
  less(largest(growth, slope) / least(growth, slope) - 1, bound(1e-8));
}

/// The part of the breathers under this noise that has left, or moved on.
static Estimate part(const Data& departures, const char* noise, const char* start,
                     const char* what) {
  const auto group = departures.at("noise", noise, "start", start);
  return group[what] / group["seeds"];
}

STATEMENT("dps.instability_moves") {
  const Data all = table("departures");
  // Nearly all leave their place, and most pass the next site
  const auto moves = [&](const char* noise) {
    less(1 - bound(0.1), part(all, noise, "site", "left"));
    less(1 - bound(0.5), part(all, noise, "site", "moved"));
  };
  moves("main");
  reading("real", [&] { moves("real"); });

  // Without the translational mode of the same noise most do not
  less(part(all, "main", "control", "moved"), 1 - bound(0.5));
}

STATEMENT("dps.bond_robust") {
  const Data all = table("departures");
  answer(part(all, "main", "bond", "left"), "of the breathers leave their bond");
  for (const char* noise : {"narrow", "relative"}) reading(noise, part(all, noise, "bond", "left"));
  control([&] {  // it does not spread
    for (const auto& group : all.where("start", "bond")) less(group["spread"], 1.1);
  });
}
