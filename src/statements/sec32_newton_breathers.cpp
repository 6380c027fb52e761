/**
# Statements of section 3.2: Static breathers of the chain */

#include <cmath>

#include "report/statement.hpp"

using namespace lattice;

/// The largest modulus from 1.001 to 2.
static Estimate largest_gap(const Data& branches, const char* gap) {
  return largest(branches.where("omega", 1.001, 2),
                 [&](const Data::Row& r) { return abs(r[gap]); });
}

STATEMENT("newton.residual") {
  answer(table("convergence").at("equations", "quarter_period")["residual"]);
}

STATEMENT("newton.variation") {
  answer(table("convergence").at("equations", "quarter_period")["next_step"]);
}

STATEMENT("newton.persistence") {
  answer(table("hundred_periods")["moved"], "relative to amplitude");
}

STATEMENT("newton.decay") {
  // At the last site whose outer neighbour extended precision reaches
  const Data tail = table("tail").where("n", 0, 49);
  const Data::Row* last = tail.begin();
  while (last + 2 < tail.end() && std::isfinite(last[2]("double_log"))) ++last;
  within((*last)["exponent"], 1.495, 1.505);
}

STATEMENT("newton.qc_small") {
  for (const char* centre : {"site", "bond"}) {
    const Data profiles = table("approximation").where("centre", centre);
    less(profiles.at("omega", 1.01)["difference"], profiles.at("omega", 1.1)["difference"]);
  }
}

STATEMENT("newton.energy_equal") {
  answer(largest_gap(table("branches"), "energy_gap"), "relative");
}

STATEMENT("newton.symmetry") {
  for (const char* centre : {"site", "bond"})
    less(table("symmetry").at("centre", centre)["broken"], 1e-9);
}

STATEMENT("newton.any_s") {
  // From the origin the amplitude grows like (omega_b - 1)^2
  for (double s : {-1.0, -0.5, 0.5, 1.0})
    for (const char* centre : {"site", "bond"})
      near(table("other_wells").at("s", s, "centre", centre)["exponent"], 2, 0.05);
}

STATEMENT("newton.grows") {
  for (const char* size : {"amplitude_site", "energy_site", "amplitude_bond", "energy_bond"})
    increases(table("branches"), "omega", size);
}

STATEMENT("newton.site_asymmetry") {
  increases(table("branches"), "omega", "asymmetry");
}

STATEMENT("newton.amplitude_differs") {
  answer(largest_gap(table("branches"), "amplitude_gap"), "relative");
}

STATEMENT("chain.width_constant") {
  const auto change = [&](const char* centre) {
    const Data widths = table("widths").where("centre", centre).where("omega", 1.001, 1.05);
    return largest(widths, "width") / least(widths, "width") - exact(1);
  };
  answer(larger(change("site"), change("bond")), "relative");
}
