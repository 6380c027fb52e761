/**
# Statements of section 3.1: The discrete p-Schrödinger (DpS) equation and its error */

#include <algorithm>
#include <cmath>

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("dps.tau0") {
  answer(table("time_constant")["tau_0"]);
}

/// The mean, known to the largest departure of any of them.
static Estimate mean_order(const Data& rows, const char* column = "order") {
  Estimate mean;
  for (const auto& row : rows) mean.value += row[column].value / double(rows.size());
  for (const auto& row : rows)
    mean.error = std::max(mean.error, std::abs(row[column].value - mean.value) + row[column].error);
  return mean;
}

STATEMENT("dps.error_order") {
  // Its limit at small amplitude, for three starts and three horizons
  answer(mean_order(table("limits")), "");
}

STATEMENT("dps.travelling_close") {
  const Data waves = table("travelling_waves").where("wavelength", 2, 4);
  answer(mean_order(waves), "");
  reading("equal_amplitude", mean_order(waves, "order_amplitude"));
  reading("root_mean_square", mean_order(waves, "order_rms"));
}

STATEMENT("dps.wells_drop_out") {
  enum { impact, pair };
  for (const char* well : {"hard", "asymmetric"})
    for (int start : {impact, pair})
      near(table("other_wells").at("well", well, "start", start)["order"], 1.5, bound(0.03));
}
