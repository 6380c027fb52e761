/**
# Statements: 3.3 stability of the DpS breathers */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("dps.bond_stable") {
  less(fact("safe_margin_bond"), 0);
  less(fact("safe_margin_bond_mu10"), 0);
}

STATEMENT("dps.site_growth") {
  less(0, fact("safe_margin_site_least"));
  less(fact("linearity"), 1e-8);
}

STATEMENT("dps.instability_moves") {
  less(0.9, fact("leaving_share_narrow_site"));
  less(0.5, fact("moving_share_narrow_site"));
  less(0.75, fact("controls_later_share"));
  less(2, fact("controls_delay"));
  less(fact("torn"), 0.5);
}

STATEMENT("dps.bond_robust") {
  less(fact("leaving_share_narrow_bond"), 0.1);
  less(0.9, fact("leaving_share_narrow_site"));
  less(fact("bond_robust_spread"), 2);
}
