/**
# Statements of section 3.5: Physical scales of a cradle and of an array of cantilevers */

#include "report/statement.hpp"

#include <cmath>

using namespace report;

STATEMENT("scale.contact_time") {
  answer(table("collision")["contact_time"]);
}

STATEMENT("scale.max_compression") {
  answer(table("collision")["compression"]);
}

STATEMENT("scale.cradle") {
  const Data cradles = table("cradle");
  const auto with = [&](const char* digits, double g) {
    return cradles.at("digits", digits, "g", g)["impact"];
  };
  answer(with("printed", 10));
  reading("g = 9.81 m/s^2", with("printed", 9.81));
  reading("2.439 tau_h and g = 9.81 m/s^2", with("all", 9.81));
}

/**
## Where the DpS equation is valid */
STATEMENT("scale.dps_regime") {
  const Data impacts = table("dps_regime");
  const auto vanishes = [&](const char* excess) {
    increases(impacts, "impact", excess);
    less(impacts.at("impact", 1e-3)[excess], bound(0.1));
  };
  vanishes("deflection");
  vanishes("speed");
}

STATEMENT("scale.cradle_far") {
  less(bound(100), table("far")["speed"]);
}

STATEMENT("cantilever.dps_valid") {
  const auto array = table("arrays").at("array", "section_3.6");
  answer(array["deflection"]);
  reading("speed of the packet", array["speed"]);
  reading("velocity of the bead", array["velocity"]);
}

STATEMENT("outlook.ranges") {
  const auto large = table("arrays").at("array", "centimetres");
  control([&] { near(large["load"], 1, 0.1); });
  // A packet travels, and the DpS equation describes it
  less(bound(0.1), large["share"]);
  for (const char* excess : {"deflection", "speed"}) less(large[excess], bound(0.1));
}

/**
## Beams and beads */
STATEMENT("cantilever.gamma") {
  const auto usual = table("hertz").at("first", 1, "second", 1);
  near(usual["printed"], 1, bound(1e-6));
  // The letter that is printed
  near(usual["with_beam"], 1, bound(1e-6));
}

STATEMENT("cantilever.eta") {
  for (const auto& pair : table("hertz").where("first", 0.5, 2.5).where("second", 0.5, 2.5))
    near(pair["printed"], 1, bound(1e-6));
}

STATEMENT("beam.stiffness") {
  answer(table("beam")["stiffness"]);
}

STATEMENT("beam.frequency") {
  answer(table("beam")["frequency"]);
}

STATEMENT("beam.mass") {
  answer(table("beam")["mass"]);
}

STATEMENT("cantilever.tau_h") {
  answer(table("array")["tau_h"]);
}

STATEMENT("cantilever.tau_c") {
  answer(table("array")["tau_c"]);
}

STATEMENT("cantilever.lambda") {
  answer(table("array")["lambda"]);
}

STATEMENT("outlook.dominated") {
  // An instability as strong as is printed must need longer than the lifetime
  less(0.015, table("array")["growth"]);
}

// Time scales, without the numbers that make a period and a contact time of them
STATEMENT("scale.faster") {
  const auto array = table("array").only();
  less(array["tau_c"], array["tau_h"]);
  reading("periods", [&] {
    const Estimate collision = table("collision")["contact_time"];
    less(2 * std::acos(-1.0) * array["tau_c"], collision * array["tau_h"]);
  });
}
