/**
# Statements of section 3.6: Scattering of a breather by a defect in an array of cantilevers */

#include "report/statement.hpp"

#include <string>

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
  const Data speeds = table("speeds");
  // The slope of X(t), as section 3.4 of the article measures speeds, between the sites that give the printed number
  answer(speeds.at("how", "slope", "from", 20, "to", 40)["speed"]);
  reading("80 sites over the time", speeds.at("how", "arrival", "from", 0)["speed"]);
  reading("from the struck beam", speeds.at("how", "arrival", "from", 1)["speed"]);
  for (const auto& slope : speeds.where("how", "slope")) {
    if (slope("to") == 40) continue;
    reading("line from " + std::to_string(int(slope("from"))) + " to " +
                std::to_string(int(slope("to"))),
            slope["speed"]);
  }
}

STATEMENT("cantilever.duration") {
  const auto above = [&](double share) {
    return table("durations").at("above", share)["duration"];
  };
  answer(above(1e-3));
  reading("force above a half", above(0.5));
  reading("force above a hundredth", above(0.01));
  reading("force above 1.5 thousandths", above(1.5e-3));
  reading("force above a two-thousandth", above(5e-4));
}

STATEMENT("cantilever.wavetrain") {
  const Data trains = table("wave_train");
  const auto extends = [&](const char* at, const char* sites) {
    const auto train = trains.at("at", at);
    less(bound(3) * train["packet"], train[sites]);
    // From the boundary on, with more than a remnant of the energy
    less(train["first"], bound(5));
    less(bound(0.1), train["share"]);
  };
  extends("defect", "sites");
  reading("middle nine tenths", [&] { extends("defect", "most"); });
  reading("packet at site 50", [&] { extends("half_way", "sites"); });
}

/**
## The defect

Bounds are parts of the energy that arrives: almost all of it is more than nineteen twentieths. */
STATEMENT("cantilever.reflect16") {
  const auto heavy = table("defect_map").at("ratio", 1.6);
  const auto almost = [&](const Estimate& part) { within(part, 1 - bound(0.05), 1); };
  almost(heavy["net_reflected"]);
  reading("of all energy", [&] { almost(heavy["reflected"]); });
  reading("of the packet", [&] { almost(table("packets").at("ratio", 1.6)["part"]); });
}

STATEMENT("cantilever.partial11") {
  const Data map = table("defect_map");
  const auto significant = [&](const Estimate& part) { less(bound(0.1), part); };
  const auto slight = [&](const char* part) {
    for (const auto& defect : map.where("ratio", 1.0125, 1.1)) significant(defect[part]);
  };
  slight("net_transmitted");
  // And at 1.1 radii in part only
  significant(map.at("ratio", 1.1)["net_reflected"]);
  reading("of all energy", [&] { slight("transmitted"); });
  reading("of the packet", [&] { significant(table("packets").at("ratio", 1.1)["part"]); });
}

STATEMENT("cantilever.total_reflection") {
  const auto almost = [&](const char* part) {
    for (const Data& defects : {table("defect_map").where("ratio", 1.6, 2),
                                table("large_defects").where("ratio", 2.1, 10)})
      for (const auto& defect : defects) within(defect[part], 1 - bound(0.05), 1);
  };
  almost("net_reflected");
  reading("of all energy", [&] { almost("reflected"); });
}

STATEMENT("cantilever.trapped") {
  const Data trapped = table("trapped");
  const auto heavy = trapped.at("ratio", 1.6, "t", 75), none = trapped.at("ratio", 1, "t", 75);
  answer(heavy["before"], "of the energy");
  reading("at 100 ms", trapped.at("ratio", 1.6, "t", 100)["before"]);
  reading("around the defect", heavy["near"]);
  reading("the next nine sites", heavy["next"]);
  reading("without a defect", none["before"]);
}

STATEMENT("defect.map") {
  const Data map = table("defect_map");
  less(1 - bound(0.01), map.at("ratio", 1.6)["net_reflected"]);

  // Of all defects slightly smaller beads keep the most energy near them, and keep it long
  const auto most = table("most_near").only();
  less(bound(0.02), most["near"]);
  within(most["ratio"], 0.925, 0.95);
  for (const auto& defect : map) less(defect["near"], most["near"]);
  const Data trapped = table("trapped");
  const Estimate left = trapped.at("ratio", 0.925, "t", 100)["near_left"];
  less(1 - bound(0.01), left);
  less(trapped.at("ratio", 1.6, "t", 100)["near_left"], left);
}

/**
## What an experiment would see */
STATEMENT("outlook.small_period") {
  answer(table("experiment")["small_period"]);
}

STATEMENT("outlook.travel_10ms") {
  const Data speeds = table("speeds");
  const auto slope_to = [&](const char* to) {
    return exact(10e-3) * speeds.at("how", "slope", "from", 20, "to", std::stod(to))["speed"];
  };
  answer(slope_to("40"), "sites");
  reading("80 sites over the time", table("experiment")["travelled"]);
  reading("from site 80 on", table("experiment")["onward"]);
  for (const char* to : {"60", "80"}) reading(std::string("line from 20 to ") + to, slope_to(to));
}

STATEMENT("outlook.periods_10ms") {
  answer(table("experiment")["periods"]);
}
