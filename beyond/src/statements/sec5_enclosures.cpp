/**
# Statements of section 5: Breathers between bounds */

#include <string>

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("dps.enclosed") {
  // One real pair of exponents about a site, none about a bond
  less(0, fact("margin_site"));
  less(fact("margin_bond"), 0);

  // The sign of the barrier depends on what is equal
  less(0, fact("barrier_equal_mu"));
  less(fact("barrier_equal_norm"), 0);
}

STATEMENT("travelling.existence") {
  for (const std::string sign : {"plus", "minus"}) less(fact("wave_radius_" + sign), 1e-10);
}

STATEMENT("travelling.two_waves") {
  // The values with the sign plus less those with the sign minus
  less(fact("wave_energy_difference"), 0);
  less(fact("wave_action_difference"), 0);
  less(fact("wave_peak_plus"), fact("wave_peak_minus"));
}
