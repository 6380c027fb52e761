/**
# Statements: 3.4 from travelling breather to kink in pendulum wells */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("impact.kink") {
  less(0, fact("kink_breathers"));
  less(0, fact("kink_kinks"));
  less(fact("kink_undecided"), 0.05);
}

STATEMENT("impact.no_blowup_pendulum") {
  less(fact("no_blowup_pendulum_speed"), 1.001);
  less(fact("no_blowup_pendulum_drift"), 1e-3);
  less(0.999, fact("no_blowup_pendulum_lasted"));
}
