/**
# Statements of section 4: Precompression: phonons, modulational instability and impacts */

#include <cmath>
#include <numbers>
#include <vector>

#include "report/statement.hpp"

using namespace lattice;

constexpr double wells[] = {-1.0 / 6, 0, 1};
/// A packet that is no breather loses its share faster than t^(-1/6).
constexpr double dispersal = 1.0 / 6;

STATEMENT("pre.v1") {
  answer(table("contact_series")["v1"]);
}

STATEMENT("pre.v2") {
  answer(table("contact_series")["v2"]);
}

STATEMENT("pre.v3") {
  answer(table("contact_series")["v3"]);
}

STATEMENT("pre.edges") {
  // Unstable are the waves with q near 0 for s < 0, and those near pi for s above this
  const Estimate threshold = -16 * table("contact_series")["v3"];
  for (const auto& edge : table("band_edges").where("q", 0))
    near(edge["phi"], -1.5 * Estimate(edge("s")), 1e-13);
  for (const auto& edge : table("band_edges").where("q", std::numbers::pi))
    near(edge["phi"], 1.5 * (edge("s") - threshold), 1e-13);

  // Exact waves on either side
  const Data waves = table("edge_waves");
  for (const char* edge : {"zero", "pi"}) {
    near(waves.at("edge", edge, "side", "unstable")["growth_over_nls"], 1, 0.02);
    less(waves.at("edge", edge, "side", "stable")["growth"], 1e-12);
  }
}

static Estimate cosine(const Estimate& q) {
  return {std::cos(q.value), std::abs(std::sin(q.value)) * q.error};
}

STATEMENT("pre.inflection") {
  const Estimate v1 = table("contact_series")["v1"];
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
  less(0, table("ring_breather")["speed"]);
  less(control["peak_over_mean"], 5);
  less(table("ring_breather")["apart"], 1e-3);
}

STATEMENT("pre.impact_s1") {
  const auto breather = table("impacts").at("s", 1, "compression", 0.5);
  less(-dispersal, breather["share_exponent"]);
  less(0.5, breather["steadiness"]);
  for (double t : {291, 724, 3000}) {
    const auto sech = table("envelope_fits").at("t", t);
    less(sech["reach"], 10);  // of the 21 sites to which it is fitted
    less(sech["residual"], 0.1);
  }

  // Without compression the packet returns, and soft wells have a surface mode
  less(table("impacts").at("s", 1, "compression", 0)["steadiness"], 0.5);
  less(-0.5, table("impacts").at("s", -1.0 / 6, "compression", 0)["boundary_exponent"]);
}

STATEMENT("pre.impact_other") {
  for (double s : {0.0, -1.0 / 6}) {
    const auto train = table("impacts").at("s", s, "compression", 0.5);
    less(train["share_exponent"], -dispersal);
    less(train["boundary_exponent"], -0.5);
  }

  // Without compression the packet returns, and soft wells have a surface mode
  less(table("impacts").at("s", 1, "compression", 0)["steadiness"], 0.5);
  less(-0.5, table("impacts").at("s", -1.0 / 6, "compression", 0)["boundary_exponent"]);
}

STATEMENT("pre.same_s1_s0") {
  const Data rings = table("breathers"), hard = rings.where("s", 1);
  const auto soft = rings.at("s", -1.0 / 6), linear = rings.at("s", 0);
  for (const auto& packet : {soft, hard.at("waves", 52), linear}) {
    less(5, packet["peak_over_mean"]);
    less(packet["width"], 50);  // a quarter of the ring
    less(0, packet["speed"]);
  }

  // In linear wells it comes later and is wider, whatever the wavenumber in hard ones
  const auto precedes = [&](const Data::Row& packet) {
    less(packet["gathered"], linear["gathered"]);
    less(packet["least_width"], linear["least_width"]);
  };
  precedes(soft);
  for (const auto& packet : hard.where("outcome", "breather")) precedes(packet);
}

STATEMENT("pre.splitting") {
  const auto pulse = table("splitting").only();
  less(pulse["round"], pulse["one_pulse_for"]);
  less(pulse["apart_at"], table("breathers").at("s", -1.0 / 6)["agree"]);
}

STATEMENT("pre.tail_both_sides") {
  for (const char* side : {"behind", "ahead"}) less(0.01, table("tails")[side]);
}

STATEMENT("pre.less_localized") {
  answer(table("packet_sites")["ratio"]);
}

STATEMENT("pre.nls_order") {
  // The last order, with the one before it as its error
  const Data errors = table("ansatz_error");
  answer(compare(errors.at("eps", 0.05)["order_l2"], errors.at("eps", 0.025)["order_l2"]), "");
}
