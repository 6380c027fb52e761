/**
# Statements of section 3.4: Packets that reverse their direction in hard wells */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("boomeron.reversal") {
  const Data force = table("force").where("s", 1).where("velocity", 1.9);
  for (const char* leg : {"out", "back"}) less(force.at("leg", leg)["force"], 0);
  less(exact(table("turns").at("velocity", 1.9)["return_time"].error), 10);
}

STATEMENT("boomeron.moderate") {
  const Data out = table("force").where("s", 1).where("leg", "out");
  const auto moderate = out.at("velocity", 1.5), turning = out.at("velocity", 1.9);
  less(1000, table("turns").at("velocity", 1.5)["apex_time"]);  // the end of the figure
  const Data quarters = table("slowing");
  less(0, quarters.at("quarter", 4)["speed"]);
  less(quarters.at("quarter", 4)["speed"], quarters.at("quarter", 1)["speed"]);
  less(moderate["force"], 0);
  less(moderate["force"] / turning["force"], 0.5);
}

STATEMENT("boomeron.turning_time") {
  answer(table("close_to_turning").at("t", 238)["distance"]);
}

STATEMENT("boomeron.any_s") {
  const auto linear = table("without_hardness").only();
  const auto hard = table("turns").at("s", 0.005);
  less(hard["apex_site"], linear["centre"]);
  less(hard["return_site"], 8);
  less(linear["fallen_back"], 5);  // which would count as a turn
  less(0, linear["speed"]);
}

STATEMENT("boomeron.erratic") {
  const Data spread = table("spread");
  less(spread.at("part", "out_and_back")["deviation"], 0.25);
  less(3, spread.at("part", "late")["deviation"]);
}

STATEMENT("boomeron.constant_force") {
  const Data force = table("force").where("s", 1).where("velocity", 1.9);
  answer(quotient(force.at("leg", "back")["force"], force.at("leg", "out")["force"]), "");
}

STATEMENT("boomeron.force_grows") {
  const Data out = table("force").where("leg", "out");
  const auto never_falls = [&](const Data& list, const char* with) {
    for (const auto& one : list)
      for (const auto& later : list)
        if (one(with) < later(with)) not_more(abs(one["force"]), abs(later["force"]));
  };
  const Data velocities = out.where("s", 1).where("velocity", 1.1, 2),
             wells = out.where("velocity", 1.9).where("s", 0, 1);
  never_falls(velocities, "velocity");
  less(1, velocities.at("velocity", 2)["force"] / velocities.at("velocity", 1.1)["force"]);
  never_falls(wells, "s");
  less(1, wells.at("s", 1)["force"] / wells.at("s", 0)["force"]);
}
