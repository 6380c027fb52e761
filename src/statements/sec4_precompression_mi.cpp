/**
# Statements: 4 precompression: phonons, modulational instability and impacts */

#include <cmath>
#include <numbers>
#include <string>

#include "report/statement.hpp"

using namespace lattice;

constexpr double wells[] = {-1.0 / 6, 0, 1};

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
  const Estimate v3 = fact("v3");
  for (double q : {0.0, std::numbers::pi}) {
    // What must be positive for instability
    const auto condition = [&](double s) { return q == 0 ? -Estimate(s) : 16 * v3 + s; };
    for (const auto& edge : table("band_edges").where("q", q))
      near(edge["phi"], 1.5 * condition(edge("s")), 1e-13);
    for (const auto& wave : table("edge_waves").where("q", q))
      if (condition(wave("s")).value > 0)
        near(wave["growth_over_nls"], 1, 0.02);
      else
        less(wave["growth"], 1e-12);
  }
}

static Estimate cosine(const Estimate& q) {
  return {std::cos(q.value), std::abs(std::sin(q.value)) * q.error};
}

STATEMENT("pre.inflection") {
  const Estimate v1 = fact("v1");
  for (double s : wells) {
    const auto well = table("inflection").at("s", s);
    const Estimate cos_q = cosine(well["q_c"]);
    near(cos_q / (v1 * (1 - cos_q) * (1 - cos_q)), 1, 1e-10);
    less(well["phi_below"] * well["phi_above"], 0);
  }
}

STATEMENT("pre.beta") {
  for (double s : wells) {
    const Data waves = table("measured_coefficient").where("s", s);
    for (const auto& wave : waves)
      near(wave["measured_beta"], wave["beta"], 1e-3 * abs(wave["beta"]));
    // The growth is nan where the fastest modulation is not slow
    for (const auto& wave : waves.where("growth_phi", -HUGE_VAL, HUGE_VAL))
      near(wave["growth_phi"], wave["phi"], 1e-3 * abs(wave["phi"]));
  }
}

STATEMENT("pre.phi") {
  const Data coefficient = table("instability");
  const Estimate linear = largest(coefficient.where("s", 0), "phi");
  less(0, linear);
  for (double s : {-1.0 / 6, 1.0}) less(linear, 0.1 * largest(coefficient.where("s", s), "phi"));
}

STATEMENT("pre.mi_run") {
  const auto breather = table("ring_end").at("s", -1.0 / 6), control = table("ring_end").at("s", 1);
  less(5, breather["peak_over_mean"]);
  less(breather["share_of_sites"], 0.5);
  less(0, fact("mi_speed"));
  less(control["peak_over_mean"], 5);
  less(fact("mi_state_error"), 1e-3);
}

STATEMENT("pre.impact_s1") {
  less(-0.166666, fact("packet_exponent_s_1"));
  less(0.5, fact("steadiness_s_1"));
  for (double t : {291, 724, 3000}) {
    const auto sech = table("sech_fits").at("t", t);
    less(sech["reach"], 10);  // of the 21 sites to which it is fitted
    less(sech["residual"], 0.1);
  }

  // Without compression the packet returns, and soft wells have a surface mode
  less(fact("steadiness_uncompressed_s_1"), 0.5);
  less(-0.5, fact("boundary_exponent_uncompressed_s_minus_1_6"));
}

STATEMENT("pre.impact_other") {
  for (const std::string well : {"s_0", "s_minus_1_6"}) {
    less(fact("packet_exponent_" + well), -0.166667);
    less(fact("boundary_exponent_" + well), -0.5);
  }

  // Without compression the packet returns, and soft wells have a surface mode
  less(fact("steadiness_uncompressed_s_1"), 0.5);
  less(-0.5, fact("boundary_exponent_uncompressed_s_minus_1_6"));
}

STATEMENT("pre.same_s1_s0") {
  const Data breathers = table("breathers");
  for (double s : wells) {
    less(5, breathers.at("s", s)["peak_over_mean"]);
    less(breathers.at("s", s)["width"], 50);  // a quarter of the ring
  }
  for (const std::string well : {"s_minus_1_6", "s_0", "s_1"})
    less(0, fact("formed_speed_" + well));

  // In linear wells it comes later and is wider
  const auto linear = breathers.at("s", 0);
  for (double s : {-1.0 / 6, 1.0}) {
    less(breathers.at("s", s)["gathered"], linear["gathered"]);
    less(breathers.at("s", s)["least_width"], linear["least_width"]);
  }
}

STATEMENT("pre.splitting") {
  less(fact("splitting_round"), fact("splitting_one_pulse_for"));
  less(fact("splitting_apart_at"), fact("agree_s_minus_1_6"));
}

STATEMENT("pre.tail_both_sides") {
  for (const std::string side : {"behind", "ahead"}) less(0.01, fact("tail_both_sides_" + side));
}

STATEMENT("pre.less_localized") {
  answer(fact("packet_sites_ratio"));
}

STATEMENT("pre.nls_order") {
  answer(fact("nls_order"));
}
