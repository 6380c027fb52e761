/**
# Statements: 5 breathers between bounds */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("dps.enclosed") {
  less(0, fact("margin_site"));
  less(fact("margin_bond"), 0);
  less(0, fact("barrier_equal_mu"));
  less(fact("barrier_equal_norm"), 0);
}

STATEMENT("travelling.existence") {
  less(fact("wave_radius_plus"), 1e-10);
  less(fact("wave_radius_minus"), 1e-10);
}

STATEMENT("travelling.two_waves") {
  less(fact("wave_energy_difference"), 0);
  less(fact("wave_action_difference"), 0);
  less(fact("wave_peak_plus"), fact("wave_peak_minus"));
}
