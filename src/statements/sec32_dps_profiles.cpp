/**
# Statements of section 3.2: Static breathers of the DpS equation */

#include <cmath>

#include "report/statement.hpp"

using namespace report;

STATEMENT("dps.scaling") {
  // Of the breather whose exponent may be the farther from two
  const auto site = table("breathers").at("centre", "site")["amplitude_exponent"],
             bond = table("breathers").at("centre", "bond")["amplitude_exponent"];
  const auto off = [](const Estimate& e) { return std::abs(e.value - 2) + e.error; };
  answer(off(site) > off(bond) ? site : bond);
}

STATEMENT("dps.qc_support") {
  answer(table("support")["half_width"]);
}

STATEMENT("dps.qc_solution") {
  less(table("support")["residual"], bound(1e-6));
  control([&] { less(1e-3, table("support")["control"]); });
}

STATEMENT("dps.qc_site") {
  answer(table("breathers").at("centre", "site")["difference"], "share of the amplitude");
}

STATEMENT("dps.qc_bond") {
  answer(table("breathers").at("centre", "bond")["difference"], "share of the amplitude");
}
