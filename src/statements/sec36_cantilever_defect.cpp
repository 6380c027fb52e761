/**
# Statements of section 3.6: Scattering of a breather by a defect in an array of cantilevers */

#include "report/statement.hpp"

using namespace lattice;

/**
## The packet */
STATEMENT("cantilever.bead_velocity") {
  answer(fact("bead_velocity"));
}

STATEMENT("cantilever.deflection") {
  answer(fact("deflection"));
}

STATEMENT("cantilever.force") {
  answer(fact("force"));
}

STATEMENT("cantilever.period") {
  answer(fact("period"));
}

STATEMENT("cantilever.frequency") {
  answer(fact("frequency"));
}

STATEMENT("cantilever.speed") {
  answer(fact("speed_mean"));
}

STATEMENT("cantilever.duration") {
  answer(fact("duration_thousandth"));
}

STATEMENT("cantilever.wavetrain") {
  answer(fact("wavetrain_sites"));
}

STATEMENT("cantilever.dps_valid") {
  answer(fact("dps_deflection_apart"));
}

/**
## The defect */
STATEMENT("cantilever.reflect16") {
  within(table("defect_map").at("ratio", 1.6)["net_reflected"], 0.95, 1);
}

STATEMENT("cantilever.partial11") {
  within(table("defect_map").at("ratio", 1.1)["net_transmitted"], 0.1, 0.9);
}

STATEMENT("cantilever.total_reflection") {
  for (const Data& defects : {table("defect_map").where("ratio", 1.6, 2),
                              table("large_defects").where("ratio", 2.1, 2.5)})
    for (const auto& defect : defects) within(defect["net_reflected"], 0.95, 1);
}

STATEMENT("cantilever.trapped") {
  answer(fact("before_75_16"));
}

STATEMENT("defect.map") {
  const Data map = table("defect_map");
  less(0.99, map.at("ratio", 1.6)["net_reflected"]);

  // Of all defects slightly smaller beads keep the most energy near them, and keep it long
  const Estimate most = largest(map.where("ratio", 0.5, 0.975), "near");
  less(0.04, most);
  for (const auto& larger : map.where("ratio", 0.9875, 2)) less(larger["near"], most);
  less(0.99, fact("kept_0925"));
  less(fact("kept_16"), fact("kept_0925"));
}

/**
## What an experiment would see */
STATEMENT("outlook.ranges") {
  answer(fact("range_load"));
}

STATEMENT("outlook.small_period") {
  answer(fact("small_period"));
}

STATEMENT("outlook.travel_10ms") {
  answer(fact("travel_10ms"));
}

STATEMENT("outlook.periods_10ms") {
  answer(fact("periods_10ms"));
}
