/**
# Statements of section 3.4: Which packets turn round, and what lies behind them */

#include <string>

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("turning.waves") {
  // With an absorber at the end the packet does not go twice as far, and returns
  less(fact("furthest_end"), 2 * fact("furthest_waves"));
  less(0.5, fact("returned_end"));

  // Without the waves behind it each of four packets goes at least twice as far as with them
  for (const std::string packet : {"10_19", "08_22", "10_17", "06_25"})
    less(2 * fact("apex_" + packet + "_all"), fact("apex_" + packet + "_6"));
}

STATEMENT("turning.contour") {
  less(fact("law_largest_deviation"), 0.03);
  less(-1.4, fact("power_large_impacts"));

  // A softer well, a later turn
  less(fact("chi_010_site_40"), fact("chi_010_site_20"));
  less(fact("chi_010_site_80"), fact("chi_010_site_40"));
}
