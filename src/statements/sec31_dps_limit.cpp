/**
# Statements of section 3.1: The discrete p-Schrödinger (DpS) equation and its error */

#include <algorithm>
#include <cmath>
#include <vector>

#include "report/statement.hpp"

using namespace report;

STATEMENT("dps.tau0") {
  answer(table("time_constant")["tau_0"]);
}

/// The mean, known to the largest departure of any of them.
static Estimate mean(const std::vector<Estimate>& orders) {
  Estimate mean;
  for (const Estimate& order : orders) mean.value += order.value / double(orders.size());
  for (const Estimate& order : orders)
    mean.error = std::max(mean.error, std::abs(order.value - mean.value) + order.error);
  return mean;
}

static Estimate mean_order(const Data& rows, const char* column = "order") {
  std::vector<Estimate> orders;
  for (const auto& row : rows) orders.push_back(row[column]);
  return mean(orders);
}

STATEMENT("dps.error_order") {
  // Its limit at small amplitude, for three starts and three horizons
  std::vector<Estimate> orders;
  for (const char* start : {"impact", "pair", "displaced"})
    for (double tau : {1, 4, 10})
      orders.push_back(table("limits").at("start", start, "tau", tau)["order"]);
  answer(mean(orders), "");
}

STATEMENT("dps.travelling_close") {
  const Data waves = table("travelling_waves").where("wavelength", 2, 4);
  answer(mean_order(waves), "");
  reading("equal_amplitude", mean_order(waves, "order_amplitude"));
}

STATEMENT("dps.wells_drop_out") {
  for (const char* well : {"hard", "asymmetric"})
    for (const char* start : {"impact", "pair"})
      near(table("other_wells").at("well", well, "start", start)["order"], 1.5, bound(0.03));
}
