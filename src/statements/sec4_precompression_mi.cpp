/**
# Statements: 4 precompression: phonons, modulational instability and impacts */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("pre.v1") {
  answer(fact("v1"));
}

STATEMENT("pre.v2") {
  answer(fact("v2"));
}

STATEMENT("pre.v3") {
  answer(fact("v3"));
}

STATEMENT("pre.edges") {
  less(fact("edges_formula"), 1e-13);
  less(fact("edges_growth"), 0.02);
  less(fact("edges_stable_side"), 1e-12);
}

STATEMENT("pre.inflection") {
  less(fact("inflection_apart"), 1e-10);
}

STATEMENT("pre.beta") {
  less(fact("beta_shift"), 1e-3);
  less(fact("beta_growth"), 1e-3);
}

STATEMENT("pre.phi") {
  less(0, fact("largest_phi_s_0"));
  less(fact("phi_ratio_s_0"), 0.1);
}

STATEMENT("pre.mi_run") {
  less(5, fact("mi_run_peak_over_mean"));
  less(fact("mi_run_share_of_sites"), 0.5);
  less(0, fact("mi_speed"));
  less(fact("mi_run_control_peak_over_mean"), 5);
  less(fact("mi_state_error"), 1e-3);
}

STATEMENT("pre.impact_s1") {
  less(-0.166666, fact("packet_exponent_s_1"));
  less(0.5, fact("steadiness_s_1"));
  less(fact("sech_reach"), 10);
  less(fact("sech_residual"), 0.1);
  less(fact("steadiness_uncompressed_s_1"), 0.5);
  less(-0.5, fact("boundary_exponent_uncompressed_s_minus_1_6"));
}

STATEMENT("pre.impact_other") {
  less(fact("packet_exponent_s_0"), -0.166667);
  less(fact("packet_exponent_s_minus_1_6"), -0.166667);
  less(fact("boundary_exponent_s_0"), -0.5);
  less(fact("boundary_exponent_s_minus_1_6"), -0.5);
  less(fact("steadiness_uncompressed_s_1"), 0.5);
  less(-0.5, fact("boundary_exponent_uncompressed_s_minus_1_6"));
}

STATEMENT("pre.same_s1_s0") {
  less(5, fact("formed_peak_over_mean_s_minus_1_6"));
  less(5, fact("formed_peak_over_mean_s_1"));
  less(5, fact("formed_peak_over_mean_s_0"));
  less(fact("formed_width_s_minus_1_6"), 50);
  less(fact("formed_width_s_1"), 50);
  less(fact("formed_width_s_0"), 50);
  less(0, fact("formed_speed_s_minus_1_6"));
  less(0, fact("formed_speed_s_1"));
  less(0, fact("formed_speed_s_0"));
  less(fact("gathered_s_minus_1_6"), fact("gathered_s_0"));
  less(fact("gathered_s_1"), fact("gathered_s_0"));
  less(fact("packet_width_s_minus_1_6"), fact("packet_width_s_0"));
  less(fact("packet_width_s_1"), fact("packet_width_s_0"));
}

STATEMENT("pre.splitting") {
  less(fact("splitting_round"), fact("splitting_one_pulse_for"));
  less(fact("splitting_apart_at"), fact("agree_s_minus_1_6"));
}

STATEMENT("pre.tail_both_sides") {
  less(0.01, fact("tail_both_sides_behind"));
  less(0.01, fact("tail_both_sides_ahead"));
}

STATEMENT("pre.less_localized") {
  answer(fact("packet_sites_ratio"));
}

STATEMENT("pre.nls_order") {
  answer(fact("nls_order"));
}
