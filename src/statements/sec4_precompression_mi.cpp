/**
# Statements of section 4: Precompression: phonons, modulational instability and impacts */

#include <cmath>
#include <numbers>
#include <vector>

#include "report/statement.hpp"

using namespace report;

constexpr double wells[] = {-1.0 / 6, 0, 1};

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
  // Unstable are the waves with q near 0 for s < 0, and those near pi for s above -16 v_3
  for (const auto& edge : table("band_edges").where("d", 0.01, 10)) {
    const Estimate s = edge("s"), v3 = edge["v3"], condition = edge("q") > 0 ? 16 * v3 + s : -1 * s;
    near(edge["phi"], 1.5 * condition, bound(1e-13) * (abs(s) - 16 * v3));
  }

  // Exact waves on either side
  const Data waves = table("edge_waves");
  for (const char* edge : {"zero", "pi"}) {
    near(waves.at("edge", edge, "side", "unstable")["growth_over_nls"], 1, bound(0.02));
    less(waves.at("edge", edge, "side", "stable")["growth"], bound(1e-12));
  }
}

static Estimate cosine(const Estimate& q) {
  return {std::cos(q.value), std::abs(std::sin(q.value)) * q.error};
}

STATEMENT("pre.inflection") {
  for (const auto& at : table("compressions").where("d", 1e-8, 1e4)) {
    const Estimate cos_q = cosine(at["q_c"]);
    near(cos_q / (at["v1"] * (1 - cos_q) * (1 - cos_q)), 1, bound(1e-8));
  }
  for (const auto& at : table("inflection_signs").where("d", 1e-8, 1e4))
    less(at["phi_below"] * at["phi_above"], 0);
}

STATEMENT("pre.inflection_unique") {
  for (const auto& at : table("compressions").where("d", 1e-8, 1e4)) {
    within(at["sign_changes"], exact(0), exact(2));
    within(at["q_c"], 0, std::numbers::pi / 2);
  }
}

STATEMENT("pre.one_side") {
  // An interval on one side of q_c, which in some cases reaches an edge and in others does not
  const Data sides = table("sides").where("d", 0.1, 4).where("s", -1.0 / 6, 4);
  for (const auto& at : sides) within(at["beside"], exact(0), exact(2));
  less(least(sides, "reach"), exact(0.5));
  less(exact(0.5), largest(sides, "reach"));
  reading("no other", [&] {
    for (const auto& at : sides) less(at["below"] * at["above"], exact(0.5));
  });
}

STATEMENT("pre.band_width") {
  answer(table("compressions").at("d", 1e-6)["order"]);
}

STATEMENT("pre.beta") {
  const Data all = table("measured_coefficient");
  for (double s : wells) {
    const Data waves = all.where("d", 0.5).where("s", s);
    for (const auto& wave : waves)
      near(wave["measured_beta"], wave["beta"], bound(1e-3) * abs(wave["beta"]));
    for (const auto& wave : waves.where("slow", 1))
      near(wave["growth_phi"], wave["phi"], bound(1e-3) * abs(wave["phi"]));
  }

  // At other compressions, of the largest in the band
  for (double d : {0.05, 0.2, 1.0, 4.0})
    for (double s : wells) {
      const Data waves = all.where("d", d).where("s", s);
      const Estimate top = largest(waves, [](const Data::Row& wave) { return abs(wave["beta"]); });
      for (const auto& wave : waves) near(wave["measured_beta"], wave["beta"], bound(1e-3) * top);
    }
}

/// The largest coefficient; that of every second wavenumber tells how well it is known.
static Estimate top(const Data& coefficients) {
  std::vector<Estimate> all, second;
  for (const auto& at : coefficients) {
    all.push_back(at["phi"]);
    if (all.size() % 2 == 1) second.push_back(all.back());
  }
  return with_error(largest_of(second), largest_of(all));
}

STATEMENT("pre.phi") {
  // In each well there are unstable waves
  const Data coefficients = table("instability");
  for (double s : wells) less(0, top(coefficients.where("s", s)));
  for (double s : {-1.0 / 6, 1.0})
    less(top(coefficients.where("s", 0)), bound(0.1) * top(coefficients.where("s", s)));
}

STATEMENT("pre.mi_run") {
  const auto breather = table("ring_end").at("s", -1.0 / 6), stable = table("ring_end").at("s", 1);
  less(bound(5), breather["peak_over_mean"]);
  less(breather["share_of_sites"], bound(0.5));
  less(0, table("ring_breather")["speed"]);
  control([&] {
    less(stable["peak_over_mean"], bound(5));
    less(table("ring_breather")["apart"], bound(1e-3));
  });
}

STATEMENT("pre.train_s1") {
  for (double t : {291, 724, 3000}) less(bound(0.1), table("envelope_fits").at("t", t)["train"]);
}

STATEMENT("pre.impact_s1") {
  // A packet keeps its share of the energy; that of a train falls like t^(-1/3)
  const auto breather = table("impacts").at("s", 1, "compression", 0.5);
  less(-1 * bound(1.0 / 6), breather["share_exponent"]);
  less(1 - bound(0.5), breather["steadiness"]);
  const auto fitted = [&](const char* column, const Estimate& most) {
    for (double t : {291, 724, 3000}) less(table("envelope_fits").at("t", t)[column], most);
  };
  fitted("residual", bound(0.1));
  control([&] {
    fitted("reach", 10);  // of the 21 sites to which it is fitted
    less(table("impacts").at("s", 1, "compression", 0)["steadiness"], 1 - bound(0.5));
  });
}

STATEMENT("pre.impact_other") {
  // In a train a packet loses its share like t^(-1/3) and the first sites theirs like 1/t
  const Data impacts = table("impacts").where("velocity", 1.87);
  for (double s : {0.0, -1.0 / 6}) {
    const auto train = impacts.at("s", s, "compression", 0.5);
    less(train["share_exponent"], -1.0 / 3 + bound(1.0 / 6));
    less(train["boundary_exponent"], -1 + bound(0.5));
  }

  // Where there is a surface mode or a breather they are seen
  control([&] {
    less(-1 * bound(0.5), impacts.at("s", -1.0 / 6, "compression", 0)["boundary_exponent"]);
    less(-1 * bound(1.0 / 6), impacts.at("s", 1, "compression", 0.5)["share_exponent"]);
  });
}

STATEMENT("pre.same_s1_s0") {
  const Data rings = table("breathers").where("amplitude", 0.15), hard = rings.where("s", 1);
  const auto soft = rings.at("s", -1.0 / 6), linear = rings.at("s", 0, "waves", 24),
             narrow = rings.at("s", 0, "waves", 31);
  const auto travels = [&](const Data::Row& packet, const Estimate& peak, const Estimate& width) {
    less(peak, packet["peak_over_mean"]);
    less(packet["width"], width);
    less(0, packet["speed"]);
  };
  for (const auto& packet : {soft, hard.at("waves", 52), linear})
    travels(packet, bound(5), bound(50));  // a quarter of the ring

  // In linear wells it comes later and is wider, whatever the wavenumber in hard ones
  const auto precede = [&](const Data::Row& last, const char* width) {
    const auto precedes = [&](const Data::Row& packet) {
      less(packet["localized"], last["localized"]);
      less(packet[width], last[width]);
    };
    precedes(soft);
    for (const auto& packet : hard.where("localizes", 1)) precedes(packet);
  };
  precede(linear, "least_width");
  reading("31 waves", [&] {
    travels(narrow, 5, 50);
    precede(narrow, "least_width");
  });
  reading("participation", [&] { precede(linear, "share_of_sites"); });
}

STATEMENT("pre.splitting") {
  const auto pulse = table("splitting").only();
  less(pulse["round"], pulse["one_pulse_for"]);
  less(1 - bound(0.5), pulse["second"]);
  reading("lasting", [&] { less(0.5, pulse["kept"]); });
  control([&] {
    const auto soft = table("breathers").at("s", -1.0 / 6, "amplitude", 0.15);
    less(2 * soft["localized"], soft["agree"]);
  });
}

STATEMENT("pre.tail_both_sides") {
  for (const char* side : {"behind", "ahead"})
    less(bound(0.01), table("envelope_fits").at("t", 3000)[side]);
}

STATEMENT("pre.less_localized") {
  const Data packets = table("packet_sites");
  const auto wider = [&](const char* width, const Estimate& times) {
    for (const auto& with : packets.where("compression", 0.5))
      for (const auto& without : packets.where("compression", 0))
        less(times * without[width], with[width]);
  };
  wider("sites", bound(2));
  reading("width", [&] { wider("width", 2); });
}

STATEMENT("pre.nls_order") {
  // The last order, with the one before it as its error
  const Data errors = table("ansatz_error");
  const auto last = [&](const char* order) {
    return with_error(errors.at("eps", 0.05)[order], errors.at("eps", 0.025)[order]);
  };
  answer(last("order_l2"), "");
  reading("largest", last("order_largest"));
}
