/**
# Statements of section 5: Exact travelling breathers */

#include "report/statement.hpp"

using namespace lattice;
using namespace report;

STATEMENT("travelling.speeds") {
  const Data orbits = table("exactness");
  for (int k : {1, 2, 3})
    for (const char* missed : {"missed_plus", "missed_minus"})
      less(orbits.at("k", k)[missed], 1e-15);
  const Data type_two = table("orbits").where("type", 2).where("k", 1).where("sign", 1);
  within(type_two.at("number", 1)["turns"], 0.89, 0.9);
}

STATEMENT("travelling.stability") {
  // Pinned with the sign plus, unstable with the sign minus, and everything else decays
  const auto plus = table("stability").at("sign", 1), minus = table("stability").at("sign", -1);
  less(plus["kappa"], 0);
  less(0, minus["kappa"]);
  for (const auto& orbit : {plus, minus}) less(orbit["others"], 0.9);
}

STATEMENT("travelling.wells") {
  const Data folds = table("folds");
  less(folds.at("k", 1)["s"], folds.at("k", 2)["s"]);
  less(folds.at("k", 2)["s"], folds.at("k", 3)["s"]);
}

STATEMENT("travelling.packets") {
  // The second shift time lies between those of two exact orbits
  const auto weak = table("packet_ends").at("velocity", 0.66),
             strong = table("packet_ends").at("velocity", 1.5);
  const Data type_two = table("orbits").where("type", 2).where("k", 1).where("sign", 1);
  within(weak["turns"], 1.1, 1.2);
  within(strong["turns"], type_two.at("number", 2)["turns"], type_two.at("number", 1)["turns"]);
  less(-0.8, weak["tail_exponent"]);
}
