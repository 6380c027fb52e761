/**
# Statements of section 3.1: The discrete p-Schrödinger (DpS) equation and its error */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("dps.tau0") {
  answer(fact("tau_0_by_quadrature"));
}

STATEMENT("dps.error_order") {
  answer(fact("error_order"));
}

STATEMENT("dps.travelling_close") {
  answer(fact("travelling_close"));
}

STATEMENT("dps.wells_drop_out") {
  enum { impact, pair };
  for (const char* well : {"hard", "lopsided"})
    for (int start : {impact, pair})
      near(table("other_wells").at("well", well, "start", start)["order"], 1.5, 0.03);
}
