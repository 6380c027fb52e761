/**
# Statements of section 4: Precompression: phonons, modulational instability and impacts */

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "report/statement.hpp"

using namespace lattice;

constexpr double wells[] = {-1.0 / 6, 0, 1};
/// A packet that is no breather loses its share faster than t^(-1/6).
constexpr double dispersal = 1.0 / 6;

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
  // Unstable are the waves with q near 0 for s < 0, and those near pi for s above this
  const Estimate threshold = -16 * fact("v3");
  for (const auto& edge : table("band_edges").where("q", 0))
    near(edge["phi"], -1.5 * Estimate(edge("s")), 1e-13);
  for (const auto& edge : table("band_edges").where("q", std::numbers::pi))
    near(edge["phi"], 1.5 * (edge("s") - threshold), 1e-13);

  // Exact waves on either side
  const Data waves = table("edge_waves"), long_ones = waves.where("q", 0),
             short_ones = waves.where("q", std::numbers::pi);
  for (const auto& unstable :
       {long_ones.at("s", -0.05), short_ones.at("s", threshold.value + 0.05)})
    near(unstable["growth_over_nls"], 1, 0.02);
  for (const auto& stable : {long_ones.at("s", 0.05), short_ones.at("s", threshold.value - 0.05)})
    less(stable["growth"], 1e-12);
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
    for (const auto& wave : waves.where("slow", 1))
      near(wave["growth_phi"], wave["phi"], 1e-3 * abs(wave["phi"]));
  }
}

/// The largest coefficient; that of every second wavenumber tells how well it is known.
static Estimate top(const Data& coefficients) {
  std::vector<Estimate> all, second;
  for (const auto& at : coefficients) {
    all.push_back(at["phi"]);
    if (all.size() % 2 == 1) second.push_back(all.back());
  }
  return compare(largest_of(second), largest_of(all));
}

STATEMENT("pre.phi") {
  const Data coefficients = table("instability");
  const Estimate linear = top(coefficients.where("s", 0));
  less(0, linear);
  for (double s : {-1.0 / 6, 1.0}) less(linear, 0.1 * top(coefficients.where("s", s)));
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
  less(-dispersal, fact("packet_exponent_s_1"));
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
    less(fact("packet_exponent_" + well), -dispersal);
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
