/**
# Statements of section 3.6: Scattering of a breather by a defect in an array of cantilevers */

#include "report/statement.hpp"

using namespace lattice;

/**
## The packet */
STATEMENT("cantilever.bead_velocity") {
  answer(table("packet")["velocity"]);
}

STATEMENT("cantilever.deflection") {
  answer(table("packet")["deflection"]);
}

STATEMENT("cantilever.force") {
  answer(table("packet")["force"]);
}

STATEMENT("cantilever.period") {
  answer(table("packet")["period"]);
}

STATEMENT("cantilever.frequency") {
  answer(table("packet")["frequency"]);
}

STATEMENT("cantilever.speed") {
  answer(table("speeds").at("how", "arrival", "from", 0)["speed"]);
}

STATEMENT("cantilever.duration") {
  answer(table("durations").at("above", 1e-3)["duration"]);
}

STATEMENT("cantilever.wavetrain") {
  answer(table("wave_train")["sites"]);
}

STATEMENT("cantilever.dps_valid") {
  answer(table("dps_excess")["deflection"]);
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
  answer(table("trapped").at("ratio", 1.6)["before"]);
}

STATEMENT("defect.map") {
  const Data map = table("defect_map");
  less(0.99, map.at("ratio", 1.6)["net_reflected"]);

  // Of all defects slightly smaller beads keep the most energy near them, and keep it long
  const Estimate most = map.at("ratio", 0.9375)["near"];
  less(0.04, most);
  for (const Data& others : {map.where("ratio", 0.5, 0.925), map.where("ratio", 0.95, 2)})
    for (const auto& other : others) less(other["near"], most);
  const Data trapped = table("trapped");
  less(0.99, trapped.at("ratio", 0.925)["near_left"]);
  less(trapped.at("ratio", 1.6)["near_left"], trapped.at("ratio", 0.925)["near_left"]);
}

/**
## What an experiment would see */
STATEMENT("outlook.ranges") {
  answer(table("experiment")["load"]);
}

STATEMENT("outlook.small_period") {
  answer(table("experiment")["small_period"]);
}

STATEMENT("outlook.travel_10ms") {
  answer(table("experiment")["travelled"]);
}

STATEMENT("outlook.periods_10ms") {
  answer(table("experiment")["periods"]);
}
