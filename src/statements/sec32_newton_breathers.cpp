/**
# Statements of section 3.2: Static breathers of the chain */

#include <cmath>

#include "report/statement.hpp"

using namespace report;

/// What an article's Gauss-Newton method may have found.
static const char* const whole_periods[] = {"whole_period", "without_pinning_mode"};

STATEMENT("newton.residual") {
  const Data methods = table("convergence");
  answer(methods.at("equations", "quarter_period")["residual"]);
  for (const char* equations : whole_periods)
    reading(equations, methods.at("equations", equations, "steps", 5)["residual"]);
}

STATEMENT("newton.variation") {
  const Data methods = table("convergence");
  answer(methods.at("equations", "quarter_period")["step"]);
  for (const char* equations : whole_periods)
    reading(equations, methods.at("equations", equations, "steps", 5)["step"]);
}

STATEMENT("newton.persistence") {
  less(table("hundred_periods")["moved"], bound(0.01));
}

/// Where the tail underflows there is no number.
static bool is_known(const Data::Row& site) {
  return std::isfinite(std::get<double>(site.cell("size")));
}

STATEMENT("newton.decay") {
  // Each site is a smaller fraction of its inner neighbour than the one before, to the end of double precision
  const Data tail = table("tail");
  for (int side : {-1, 1})
    for (int n = 2; is_known(tail.at("n", side * n)); ++n) {
      const auto size = [&](int m) { return tail.at("n", side * m)["size"]; };
      less(size(n) / size(n - 1), size(n - 1) / size(n - 2));
    }

  // The exponent, at the last site whose outer neighbour extended precision reaches
  const Data right = tail.where("n", 0, 49);
  const Data::Row* last = right.begin();
  while (last + 2 < right.end() && std::isfinite(last[2]("double_log"))) ++last;
  near((*last)["exponent"], 1.5, bound(0.005));
}

STATEMENT("newton.qc_small") {
  const auto off = [&](const char* centre) {
    return table("approximation").at("centre", centre, "omega", 1.01)["difference"];
  };
  answer(largest_of({off("site"), off("bond")}), "relative");
}

STATEMENT("newton.qc_worse") {
  for (const char* centre : {"site", "bond"}) {
    const Data profiles = table("approximation").where("centre", centre);
    less(profiles.at("omega", 1.01)["difference"], profiles.at("omega", 1.1)["difference"]);
  }
}

// At every frequency of the figure
STATEMENT("newton.energy_equal") {
  for (const auto& pair : table("branches").where("omega", 1.001, 2))
    less(abs(pair["energy_gap"]), bound(0.01));
}

STATEMENT("newton.amplitude_differs") {
  for (const auto& pair : table("branches").where("omega", 1.001, 2))
    less(bound(0.01), abs(pair["amplitude_gap"]));
}

STATEMENT("newton.amplitude_minor") {
  const auto gap = [](const Data::Row& pair) { return abs(pair["amplitude_gap"]); };
  answer(largest(table("branches").where("omega", 1.001, 2), gap), "relative");
}

STATEMENT("newton.symmetry") {
  for (const char* centre : {"site", "bond"})
    for (const auto& breather : table("symmetry").where("centre", centre).where("omega", 1.01, 2))
      less(breather["broken"], bound(1e-8));
}

STATEMENT("newton.any_s") {
  // From the origin the amplitude grows like (omega_b - 1)^2
  for (const auto& family : table("other_wells").where("s", -1, 1))
    near(family["exponent"], 2, bound(0.05));
}

STATEMENT("newton.grows") {
  for (const char* size : {"amplitude_site", "energy_site", "amplitude_bond", "energy_bond"})
    increases(table("branches"), "omega", size);
}

STATEMENT("newton.site_asymmetry") {
  increases(table("branches"), "omega", "asymmetry");
  less(bound(0.01), table("branches").at("omega", 1.1)["asymmetry"]);
}

STATEMENT("chain.width_constant") {
  const auto constant_up_to = [&](double last) {
    for (const char* centre : {"site", "bond"}) {
      const Data widths = table("widths").where("centre", centre).where("omega", 1.001, last);
      less(largest(widths, "width") / least(widths, "width") - exact(1), bound(0.01));
    }
  };
  constant_up_to(1.01);
  reading("to_1.05", [&] { constant_up_to(1.05); });
}
