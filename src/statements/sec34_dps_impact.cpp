/**
# Statements of section 3.4: A weak impact, in the chain and in the DpS equation */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("impact.dps_breather") {
  const Data packet = table("dps_packet");
  less(packet["speed_change"], 0.05);
  less(packet["norm_change"], 0.1);
  less(table("residue")["window"], 1);
}

STATEMENT("impact.amp_full") {
  answer(table("heights").at("t", 8091)["chain"]);
}

STATEMENT("impact.amp_dps") {
  answer(table("heights").at("t", 8091)["dps"]);
}

STATEMENT("impact.speed_order") {
  const Data speeds = table("speeds");
  less(speeds.at("model", "chain")["per_time"], speeds.at("model", "dps")["per_time"]);
}

STATEMENT("impact.support") {
  // A hundredth of the peak is still visible in a plot
  const Data profile = table("packet_profile");
  less(0.01, profile.at("distance", 3)["amplitude"]);
  less(profile.at("distance", 4)["amplitude"], 0.01);
}

STATEMENT("impact.wavetrain") {
  answer(table("train")["apart"]);
}

STATEMENT("impact.residual_extended") {
  answer(table("residue")["sharing"]);
}

STATEMENT("impact.scales_fig17") {
  answer(table("scales")["end"]);
}
