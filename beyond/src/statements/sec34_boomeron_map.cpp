/**
# Statements: 3.4 which packets turn round, and what lies behind them */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("turning.waves") {
  // With an absorber at the end the packet does not go twice as far, and returns
  less(fact("furthest_end"), 40.2);
  less(0.5, fact("returned_end"));

  // Without the waves behind it each of four packets goes at least twice as far as with them
  less(40.2, fact("apex_10_19_6"));
  less(52.3, fact("apex_08_22_6"));
  less(108.8, fact("apex_10_17_6"));
  less(156.5, fact("apex_06_25_6"));
}

STATEMENT("turning.contour") {
  less(fact("law_largest_deviation"), 0.03);
  less(-1.4, fact("power_large_impacts"));

  // A softer well, a later turn
  less(fact("chi_010_site_40"), fact("chi_010_site_20"));
  less(fact("chi_010_site_80"), fact("chi_010_site_40"));
}
