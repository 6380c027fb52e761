/**
# Statements of section 3.6: Scattering of a breather by a defect in an array of cantilevers */

#include "report/statement.hpp"

using namespace report;

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
  answer(table("packet")["speed"]);
  reading("80 sites over the time", table("packet")["speed_arrival"]);
  reading("line from 75 to 85", table("packet")["speed_there"]);
}

STATEMENT("cantilever.duration") {
  answer(table("packet")["duration"]);
  reading("force above a thousandth", table("packet")["duration_thousandth"]);
  reading("force above a half", table("packet")["duration_half"]);
}

STATEMENT("cantilever.wavetrain") {
  const auto train = table("wave_train").only();
  less(bound(3) * train["packet"], train["sites"]);
  // From the boundary on, with more than a remnant of the energy
  less(train["first"], bound(5));
  less(bound(0.1), train["share"]);
}

/**
## The defect

Bounds are parts of the energy that arrives: almost all of it is more than nineteen twentieths. */
STATEMENT("cantilever.reflect16") {
  within(table("defect_map").at("ratio", 1.6)["net_reflected"], 1 - bound(0.05), 1);
}

STATEMENT("cantilever.partial11") {
  const Data map = table("defect_map");
  for (const auto& defect : map.where("ratio", 1.0125, 1.1))
    less(bound(0.1), defect["net_transmitted"]);
  // And at 1.1 radii in part only
  less(bound(0.1), map.at("ratio", 1.1)["net_reflected"]);
}

STATEMENT("cantilever.total_reflection") {
  for (const auto& defect : table("defect_map").where("ratio", 1.6, 10))
    within(defect["net_reflected"], 1 - bound(0.05), 1);
}

STATEMENT("cantilever.trapped") {
  const auto before = [&](double ratio, double t) {
    return table("trapped").at("ratio", ratio, "t", t)["before"];
  };
  answer(before(1.6, 75), "of the energy");
  reading("at 100 ms", before(1.6, 100));
  reading("without a defect", before(1, 75));
}

STATEMENT("defect.map") {
  const Data map = table("defect_map");
  less(1 - bound(0.01), map.at("ratio", 1.6)["net_reflected"]);

  // Of all defects slightly smaller beads keep the most energy near them, and keep it long
  const auto most = map.at("ratio", 0.9375);
  less(bound(0.02), most["near"]);
  for (const auto& defect : map)
    if (defect("ratio") != most("ratio")) less(defect["near"], most["near"]);
  less(1 - bound(0.01), table("trapped").at("ratio", 0.925, "t", 100)["near_left"]);
}

/**
## What an experiment would see */
STATEMENT("outlook.small_period") {
  answer(table("packet")["small_period"]);
}

STATEMENT("outlook.travel_10ms") {
  answer(exact(10e-3) * table("packet")["speed"], "sites");
  reading("80 sites over the time", exact(10e-3) * table("packet")["speed_arrival"]);
  reading("line from 75 to 85", exact(10e-3) * table("packet")["speed_there"]);
}

STATEMENT("outlook.periods_10ms") {
  answer(exact(10) / table("packet")["period"], "");
}
