/**
# Statements: 3.4 packets that reverse their direction in hard wells */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("boomeron.reversal") {
  less(fact("force_190"), 0);
  less(fact("force_190_back"), 0);
  less(fact("reversal_return_time_error"), 10);
}

STATEMENT("boomeron.moderate") {
  less(1000, fact("apex_time_150"));
  within(fact("speed_ratio_150"), 0, 1);
  less(fact("force_150"), 0);
  less(fact("moderate_force_over_190"), 0.5);
}

STATEMENT("boomeron.turning_time") {
  answer(fact("apex_distance_187_at_238"));
}

STATEMENT("boomeron.any_s") {
  less(fact("turning_site_softest"), fact("centre_without_hardness"));
  less(fact("return_site_softest"), 8);
  less(fact("turns_back_without_hardness"), 5);
  less(0, fact("speed_without_hardness"));
}

STATEMENT("boomeron.erratic") {
  less(fact("erratic_spread_until_return"), 0.25);
  less(3, fact("erratic_spread_late"));
}

STATEMENT("boomeron.constant_force") {
  answer(fact("force_190_back_over_out"));
}

STATEMENT("boomeron.force_grows") {
  less(fact("force_grows_velocity_largest_fall"), 0);
  less(1, fact("force_grows_velocity_last_over_first"));
  less(fact("force_grows_s_largest_fall"), 0);
  less(1, fact("force_grows_s_last_over_first"));
}
