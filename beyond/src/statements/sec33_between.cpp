/**
# Statements: 3.3 breathers between a site and a bond */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("exchange.six") {
  less(fact("window_1"), 1.02);
  less(fact("window_1"), fact("window_2"));
  less(fact("window_2"), fact("window_3"));
  less(fact("window_3"), fact("window_4"));
  less(fact("window_4"), fact("window_5"));
  within(fact("window_6"), fact("window_5"), 1.5);
  for (const auto& breather : table("sec33_floquet", "spectra").where("s", 0))
    less(breather["others"], 1e-3);
}

STATEMENT("exchange.between") {
  less(1e-7, fact("width_between_in_s"));
  less(0, fact("kappa_between_in_s"));
  less(fact("kappa_between_in_omega"), 0);
  less(fact("width_between_in_omega"), 0);
  for (const auto& breather : table("sec33_floquet", "spectra").where("omega", 1.1))
    less(breather["off_circle"], 0.5);
  less(1, fact("largest_modulus_between_in_s"));
  less(fact("largest_modulus_between_in_omega"), 1.000000001);
}
