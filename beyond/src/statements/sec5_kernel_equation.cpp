/**
# Statements of section 5: A theorem: exact travelling breathers exist */

#include "report/statement.hpp"

using namespace lattice;
using namespace report;

STATEMENT("travelling.exchanges") {
  // The last and the ninth exchange of the quotients
  const Data exchanges = table("exchanges");
  less(5, exchanges.at("exchange", 1)["alpha"]);
  less(exchanges.at("exchange", 9)["alpha"], 1.4);

  // Those of the pinned phase are not at the same exponent for both signs
  for (int exchange : {1, 2}) {
    const auto row = exchanges.at("exchange", exchange);
    less(row["alpha_plus"], row["alpha_minus"]);
  }

  // The larger quotient has the pinned phase
  for (const auto& row : table("quotients").where("alpha", 1.5, 8)) {
    less(row["difference"] * row["kappa_plus"], 0);
    less(0, row["difference"] * row["kappa_minus"]);
  }
}
