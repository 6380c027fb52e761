/**
# Statements: 3.4 strong impacts in soft wells: surface mode and blow-up */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("impact.ampvel") {
  less(fact("ampvel_speed_s_1_6_near"), 0.01);
  less(fact("ampvel_speed_s_1_6_near_over_far"), 0.5);
  less(fact("ampvel_peak_s_1_6_near"), 0.01);
  less(fact("ampvel_peak_s_1_6_near_over_far"), 0.5);
  less(fact("ampvel_speed_s_0_7_near"), 0.01);
  less(fact("ampvel_speed_s_0_7_near_over_far"), 0.5);
  less(fact("ampvel_peak_s_0_7_near"), 0.01);
  less(fact("ampvel_peak_s_0_7_near_over_far"), 0.5);
}

STATEMENT("impact.slower") {
  less(0, fact("slower_speed_s_1_6"));
  less(0, fact("slower_peak_s_1_6"));
  less(0, fact("slower_energy_s_1_6"));
  less(0, fact("slower_speed_s_0_7"));
  less(0, fact("slower_peak_s_0_7"));
  less(0, fact("slower_energy_s_0_7"));
}

STATEMENT("impact.blowup") {
  less(2.05, fact("blowup_first_escape_s_1_6"));
  less(fact("blowup_last_survivor_s_1_6"), 2.85);
  less(fact("blowup_disputed_s_1_6"), 0.05);
  less(0.93, fact("blowup_first_escape_s_0_7"));
  less(fact("blowup_last_survivor_s_0_7"), 1.33);
  less(fact("blowup_disputed_s_0_7"), 0.05);
}

STATEMENT("impact.surface_mode") {
  less(fact("packet_soft"), fact("trapped_soft"));
  less(fact("trapped_linear"), fact("packet_linear"));
  less(fact("speed_soft"), fact("speed_linear"));
}

STATEMENT("impact.snapshot") {
  less(1, fact("snapshot_prominence"));
}

STATEMENT("impact.tail") {
  answer(fact("tail_moderate"));
}

STATEMENT("blowup.bands") {
  less(fact("blowup_first_escape_s_1_6"), fact("blowup_last_survivor_s_1_6"));
  less(fact("blowup_first_escape_s_0_7"), fact("blowup_last_survivor_s_0_7"));
}
