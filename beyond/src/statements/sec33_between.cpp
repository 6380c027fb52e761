/**
# Statements of section 3.3: Breathers between a site and a bond */

#include "report/statement.hpp"

using namespace lattice;
using namespace report;

STATEMENT("exchange.six") {
  // Six exchanges one after the other, of which the first is near 1 and the last below 1.5
  const Data exchanges = table("windows");
  less(exchanges.at("exchange", 1)["omega_site"], 1.02);
  increases(exchanges, "exchange", "omega_site");
  less(exchanges.at("exchange", 6)["omega_site"], 1.5);

  // Meanwhile all other multipliers stay on the circle
  for (const auto& breather :
       table("sec33_floquet", "spectra").where("s", 0).where("omega", 1.01, 2))
    less(breather["others"], 1e-3);
}

STATEMENT("exchange.between") {
  // In s: the third breather exists where the others are both stable, and is unstable
  const Data in_s = table("between_in_s");
  less(1e-7, in_s.at("centre", 0.5)["offset"]);
  for (const auto& third : in_s.where("centre", 0.05, 0.45)) less(0, third["kappa"]);
  less(1, in_s.at("centre", 0.25)["largest_modulus"]);

  // In omega_b: where both are unstable, and it is stable
  const Data in_omega = table("between_in_omega");
  less(in_omega.at("centre", 0.5)["offset"], 0);
  for (const auto& third : in_omega.where("centre", 0.05, 0.45)) less(third["kappa"], 0);
  less(in_omega.at("centre", 0.25)["largest_modulus"], 1.000000001);
  for (const auto& breather :
       table("sec33_floquet", "spectra").where("omega", 1.1).where("s", -1, 1))
    less(breather["others"], 1e-6);
}
