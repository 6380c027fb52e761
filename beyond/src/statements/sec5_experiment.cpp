/**
# Statements of section 5: What an experiment would see */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("experiment.clock") {
  less(fact("centre_off"), 0.02);
  less(fact("way_off"), 0.05);
  less(fact("way_off_weak"), 0.004);

  // Not without the factor, and not as a bound
  less(0.3, fact("way_off_bare"));
  less(fact("sites_4_free"), fact("sites_1ms"));
}

STATEMENT("experiment.hidden") {
  less(fact("shift_10ms"), 0.001);
  less(900, fact("lifetime_e"));
  less(fact("epsilon"), fact("epsilon_hidden_dps"));
}

STATEMENT("driving.onset") {
  less(fact("recipe_7000_once"), fact("recipe_7000_lasting"));

  // Ramped up slowly the drive has to reach the fold of the motion that does not emit
  less(fact("recipe_7000_lasting"), fact("recipe_7000_up"));
  less(fact("recipe_7000_down"), fact("recipe_7000_up"));
  less(fact("recipe_7000_lasting"), fact("recipe_7000"));
}

STATEMENT("driving.law") {
  less(fact("fold_over_law_small"), 1.05);
  within(fact("fold_over_law_lossless"), 1, fact("fold_over_law_small"));
}

STATEMENT("growth.bands") {
  less(0.37, fact("greatest_growth"));
  less(fact("growth_below_quarter"), 1e-3);
}

STATEMENT("growth.chain") {
  // A square root of the amplitude where the wave is unstable, a fourth root where it is marginal
  within(fact("order_growth_8_4"), 0.48, 0.52);
  within(fact("order_growth_16_5"), 0.48, 0.54);
  within(fact("order_quarter"), 0.23, 0.27);
  less(fact("growth_below_quarter"), fact("growth_quarter_6"));
}
