/**
# Statements of section 5: What an experiment would see */

#include "report/statement.hpp"

using namespace lattice;
using namespace report;

STATEMENT("experiment.clock") {
  const Data clock = table("slow_clock");
  for (const auto& packet : clock.where("velocity", 0.5, 1).where("lifetime", 1, 100)) {
    less(packet["centre"], 0.02);
    less(packet["push"], 0.05);
  }
  less(table("weak_limit").at("velocity", 1.0 / 64)["push"], 0.004);

  // Not without the factor, and not as a bound
  less(0.3, largest(clock, "unweighted"));
  less(clock.at("velocity", 1, "lifetime", 1)["four_lifetimes"],
       table("journeys").at("velocity", 1, "lifetime", 1)["sites"]);
}

STATEMENT("experiment.hidden") {
  const Data found = table("instability");
  less(found["shift"], 0.001);
  less(900, found["lifetime"]);
  less(found["epsilon"], found["bound"]);
}

STATEMENT("driving.onset") {
  const auto from = [&](const char* way) {
    return table("thresholds").at("way", way)["threshold"];
  };
  less(from("once"), from("lasting"));

  // Ramped up slowly the drive has to reach the fold of the motion that does not emit
  less(from("lasting"), from("up"));
  less(from("down"), from("up"));
  less(from("lasting"), table("folds").at("frequency", 7000)["fold"]);
}

STATEMENT("driving.law") {
  const auto fold = table("folds").at("delta", 0.025);
  less(fold["ratio"], 1.05);
  within(fold["lossless"], 1, fold["ratio"]);
}

STATEMENT("growth.bands") {
  less(0.37, table("band_at_pi")["growth"]);
  for (const auto& wave : table("below_quarter").where("eps", 1e-6, 1e-2))
    less(wave["growth"], 1e-3);
}

STATEMENT("growth.chain") {
  // A square root of the amplitude where the wave is unstable, a fourth root where it is marginal
  const auto order = [&](int sites, int waves) {
    return table("orders").at("sites", sites, "waves", waves)["order"];
  };
  within(order(8, 4), 0.48, 0.52);
  within(order(16, 5), 0.48, 0.54);
  within(order(8, 2), 0.23, 0.27);
  const auto marginal = table("chain_growth").at("sites", 8, "waves", 2, "eps", 1e-6);
  for (const auto& wave : table("below_quarter").where("eps", 1e-6, 1e-2))
    less(wave["growth"], marginal["growth"]);
}
