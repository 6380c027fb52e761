/**
# Statements of section 3.4: Which packets turn round, and what lies behind them */

#include <utility>

#include "report/statement.hpp"

using namespace lattice;
using namespace report;

STATEMENT("turning.waves") {
  // With an absorber at the end the packet does not go twice as far, and returns
  const Data absorbers = table("absorbers");
  const auto end = absorbers.at("absorbed", "at_the_end");
  less(end["furthest"], 2 * absorbers.at("absorbed", "nothing")["furthest"]);
  less(1, end["returned"]);

  // Without the waves behind it each of four packets goes at least twice as far as with them, and is not back
  const Data range = table("range_of_waves");
  for (const auto& [s, velocity] : {std::pair{1.0, 1.9}, {0.8, 2.2}, {1.0, 1.7}, {0.6, 2.5}}) {
    const Data packet = range.where("s", s).where("velocity", velocity);
    const auto without = packet.at("behind", 6);
    less(2 * packet.at("behind", 0)["furthest"], without["furthest"]);
    for (const char* fate : {"fate", "fate_coarse"}) less(without[fate], 0.5);
  }
}

STATEMENT("turning.contour") {
  less(table("law")["deviation"], 0.03);
  less(-1.4, table("law")["power"]);

  // A softer well, a later turn
  const Data weakest = table("contours").where("velocity", 0.1);
  less(weakest.at("site", 40)["chi"], weakest.at("site", 20)["chi"]);
  less(weakest.at("site", 80)["chi"], weakest.at("site", 40)["chi"]);
}
