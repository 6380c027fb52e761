/**
# Statements of section 3.4: A weak impact, in the chain and in the DpS equation */

#include "lattice/numerics/line_fit.hpp"
#include "report/statement.hpp"

using namespace report;

STATEMENT("impact.ansatz_orders") {
  const Data start = table("start").where("eps", 1e-6, 1e-2);
  for (const auto& row : start) {
    less(row["place"], bound(1e-12) * row("eps"));
    less(row["others"], bound(1e-12) * row("eps"));
  }
  for (const char* bead : {"first", "second"})
    for (const auto* row = start.begin() + 1; row < start.end(); ++row)
      near(order_between(row[0]("eps"), abs(row[0][bead]), row[-1]("eps"), abs(row[-1][bead])), 1.5,
           bound(0.01));
}

STATEMENT("impact.dps_breather") {
  const Data packet = table("dps_packet");
  less(packet["speed_change"], bound(0.05));
  less(packet["norm_change"], bound(0.1));
  less(table("residue")["window"], bound(1));
  reading("all_behind", [&] { less(1 - packet["norm"], packet["norm"]); });
}

STATEMENT("impact.dispersion") {
  const Data packet = table("chain_packet");
  less(packet["narrowness_change"], bound(0.1));
  less(packet["energy_change"], bound(0.1));
}

static const char* const other_amplitudes[] = {"largest_displacement", "printed_time"};

STATEMENT("impact.amp_full") {
  const Data readings = table("readings");
  answer(readings.at("reading", "height_at_the_end")["chain"]);
  for (const char* other : other_amplitudes) reading(other, readings.at("reading", other)["chain"]);
}

STATEMENT("impact.amp_dps") {
  const Data readings = table("readings");
  answer(readings.at("reading", "height_at_the_end")["dps"]);
  for (const char* other : other_amplitudes) reading(other, readings.at("reading", other)["dps"]);
}

STATEMENT("impact.amp_order") {
  const auto overestimated = [&](const char* by) {
    const auto row = table("readings").at("reading", by);
    less(row["chain"], row["dps"]);
  };
  overestimated("height_at_the_end");
  for (const char* other : other_amplitudes) reading(other, [&] { overestimated(other); });
}

STATEMENT("impact.speed_order") {
  const Data speeds = table("speeds");
  const Estimate chain = speeds.at("model", "chain")["per_time"],
                 dps = speeds.at("model", "dps")["per_time"];
  less(chain, dps);
  less(dps, (1 + bound(0.1)) * chain);
}

STATEMENT("impact.wavetrain") {
  const Data train = table("train");
  answer(train["site_by_site"]);
  reading("all_energy", train["apart"]);
}

STATEMENT("impact.residual_extended") {
  const Data in_time = table("residue_in_time").where("tau", 50, 250);
  less(bound(10), in_time.at("tau", 250)["sharing"]);
  increases(in_time.where("tau", 150, 250), "tau", "sharing");  // the packet is beyond
  // What is stationary or periodic returns
  for (const auto* stretch = in_time.begin() + 1; stretch < in_time.end(); ++stretch)
    less(stretch[0]["first_ten"], stretch[-1]["first_ten"]);
}

STATEMENT("impact.scales_fig17") {
  answer(table("scales")["end"]);
}

STATEMENT("impact.eps_fig17") {
  answer(table("scales")["eps"]);
}
