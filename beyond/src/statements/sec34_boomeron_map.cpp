/**
# Statements of section 3.4: Which packets turn round */

#include "report/statement.hpp"

using namespace lattice;
using namespace report;

STATEMENT("turning.contour") {
  less(table("law")["deviation"], 0.03);
  less(-1.4, table("law")["power"]);

  // A softer well, a later turn
  const Data weakest = table("contours").where("velocity", 0.1);
  less(weakest.at("site", 40)["chi"], weakest.at("site", 20)["chi"]);
  less(weakest.at("site", 80)["chi"], weakest.at("site", 40)["chi"]);
}
