/**
# Statements: 2 no breathers without an on-site potential */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("thm.mean_force") {
  less(fact("mean_force_spread_free"), 1e-8);
  less(1e-3, fact("mean_force_least_free"));
  less(1e-5, fact("mean_force_spread_not_periodic"));
  less(fact("mean_force_core_free"), 0.1);
  less(fact("mean_force_late_mean_free"), 0.1);
  less(fact("mean_force_woken_free"), 401);
  less(0.99, fact("mean_force_core_wells"));
  less(fact("mean_force_late_mean_wells"), 0.1);
}
