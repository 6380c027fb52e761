/**
# Statements of section 5: Breathers between bounds */

#include "report/statement.hpp"

using namespace lattice;
using namespace report;

STATEMENT("dps.enclosed") {
  // One real pair of exponents about a site, none about a bond
  const Data breathers = table("dps_breathers");
  less(0, breathers.at("centre", "site")["margin"]);
  less(breathers.at("centre", "bond")["margin"], 0);

  // The sign of the barrier depends on what is equal
  less(0, table("dps_barrier")["equal_mu"]);
  less(table("dps_barrier")["equal_norm"], 0);
}

STATEMENT("travelling.existence") {
  for (const char* sign : {"plus", "minus"})
    less(table("constants").at("solution", sign)["radius"], 1e-10);
}

STATEMENT("travelling.two_waves") {
  less(table("plus_minus_minus")["energy"], 0);
  less(table("plus_minus_minus")["action"], 0);
  const Data waves = table("waves");
  less(waves.at("sign", "plus")["peak"], waves.at("sign", "minus")["peak"]);
}
