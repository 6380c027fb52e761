/**
# Statements of section 3.4: Packets that reverse their direction in hard wells */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("boomeron.reversal") {
  const Data force = table("force").where("s", 1).where("velocity", 1.9);
  for (int outward : {1, 0}) less(force.at("outward", outward)["force"], 0);
  less(exact(fact("return_time_190").error), 10);
}

STATEMENT("boomeron.moderate") {
  const Data out = table("force").where("s", 1).where("outward", 1);
  const auto moderate = out.at("velocity", 1.5), turning = out.at("velocity", 1.9);
  less(1000, fact("apex_time_150"));  // the end of the figure
  within(fact("speed_ratio_150"), 0, 1);
  less(moderate["force"], 0);
  less(moderate["force"] / turning["force"], 0.5);
}

STATEMENT("boomeron.turning_time") {
  answer(fact("apex_distance_187_at_238"));
}

STATEMENT("boomeron.any_s") {
  const auto linear = table("without_hardness").only();
  less(fact("turning_site_softest"), linear["centre"]);
  less(fact("return_site_softest"), 8);
  less(linear["fallen_back"], 5);  // which would count as a turn
  less(0, linear["speed"]);
}

STATEMENT("boomeron.erratic") {
  less(fact("erratic_spread_until_return"), 0.25);
  less(3, fact("erratic_spread_late"));
}

STATEMENT("boomeron.constant_force") {
  answer(fact("force_190_back_over_out"));
}

STATEMENT("boomeron.force_grows") {
  const Data out = table("force").where("outward", 1);
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
