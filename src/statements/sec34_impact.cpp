/**
# Statements of section 3.4: Strong impacts in soft wells: surface mode and blow-up */

#include <algorithm>
#include <cmath>

#include "report/statement.hpp"

using namespace report;

// What is said of impacts below the blow-up is judged up to the first escape. In the last 0.05 before it (`ending`) the outcome
// is erratic; without them other verdicts are reached
static constexpr double soft_wells[] = {-1.0 / 6, -0.7};
static constexpr double weakest_impact = 2 * 0.9548e-3;

STATEMENT("impact.ampvel") {
  const Data sweep = table("velocity_sweep"), linear = sweep.where("s", 0);
  for (double s : soft_wells)
    for (const char* curve : {"speed", "peak"}) {
      const auto apart = [&](const Data::Row& soft) {
        return abs(soft[curve] / linear.at("velocity", soft("velocity"))[curve] - 1);
      };
      const Data soft = sweep.where("s", s), weak = soft.where("velocity", 0.01, 0.05);
      for (const auto& impact : weak) less(apart(impact), bound(0.01));
      // They meet, and are not only close; farther away they differ
      const Estimate farther = largest(soft.where("velocity", 0.01, 0.5), apart);
      less(largest(weak, apart), bound(0.5) * farther);
    }
}

STATEMENT("impact.slower") {
  const Data sweep = table("velocity_sweep"), linear = sweep.where("s", 0);
  const auto slower = [&](const char* speed) {
    for (double s : soft_wells)
      for (const auto& soft : sweep.where("s", s)) {
        const auto& other = linear.at("velocity", soft("velocity"));
        // The speeds of weak packets are too close to be told apart
        not_more(soft[speed], other[speed]);
        for (const char* curve : {"peak", "packet"}) less(soft[curve], other[curve]);
      }
  };
  slower("speed");
  reading("beyond_site_40", [&] { slower("beyond_site_40"); });
}

STATEMENT("impact.much_smaller") {
  const Data sweep = table("velocity_sweep");
  const auto ratio = [&](double s, double velocity) {
    return sweep.at("s", s, "velocity", velocity)["packet"] /
           sweep.at("s", 0, "velocity", velocity)["packet"];
  };
  answer(ratio(-1.0 / 6, 1.87), "of that in linear wells");
  reading("other_picture", ratio(-0.7, 0.94));
}

STATEMENT("impact.trapped") {
  const Data sweep = table("velocity_sweep"), linear = sweep.where("s", 0);
  const auto trapped = [&](const char* part, bool with_ending) {
    for (double s : soft_wells)
      for (const auto& soft : sweep.where("s", s)) {
        if (soft["ending"].value > 0 && !with_ending) continue;
        const auto& other = linear.at("velocity", soft("velocity"));
        if (soft["packet"].value > bound(0.5).value * other["packet"].value)
          continue;  // not much smaller
        less(bound(0.5) * (other["packet"] - soft["packet"]), soft[part] - other[part]);
      }
  };
  trapped("first_five", true);
  reading("ten_sites", [&] { trapped("first_ten", true); });
  reading("without_ending", [&] { trapped("first_five", false); });
}

/// On the grid of a scan; an impact whose outcome depends on the time step is ignored.
struct Band {
  double first_escape = HUGE_VAL, last_survivor = 0;
  double survivors_above = 0, changes = 0;  // the former of stronger impacts than the first escape
  Estimate disputed = exact(0);
};
static Band band(const Data& scan) {
  if (scan.size() < 2) throw Unresolved{"a scan of one impact"};
  Band out;
  bool before = false, is_first = true;
  for (const auto& impact : scan) {
    const bool escaped = impact["escaped"].value > 0;
    out.disputed = out.disputed + exact(1) - impact["agree"];
    if (!(impact["agree"].value > 0)) continue;
    if (!is_first && escaped != before) ++out.changes;
    before = escaped, is_first = false;
    if (escaped)
      out.first_escape = std::min(out.first_escape, impact("velocity"));
    else
      out.last_survivor = impact("velocity"),
      out.survivors_above += out.first_escape < HUGE_VAL ? 1 : 0;
  }
  if (is_first) throw Unresolved{"no impact has the same outcome at both steps"};
  out.disputed = out.disputed / exact(double(scan.size()));
  return out;
}

STATEMENT("impact.blowup") {
  for (double s : soft_wells) {
    const Data scan = table("blowup_scan").where("s", s);
    const auto &weakest = scan.begin()[0], &strongest = scan.end()[-1];
    control([&] {
      for (const auto& end : {weakest, strongest}) less(0.5, end["agree"]);
      less(band(scan).disputed, 0.05);
    });
    less(weakest["escaped"], 0.5);
    less(0.5, strongest["escaped"]);
    // Above the strongest impact that is survived all blow up, over a tenth of its velocity at least
    less((1 + bound(0.1)) * exact(band(scan).last_survivor), exact(strongest("velocity")));
  }
  reading("first_escape", [&] {
    for (double s : soft_wells)
      less(exact(band(table("blowup_scan").where("s", s)).survivors_above), 0.5);
  });
}

STATEMENT("impact.surface_mode") {
  const Data sweep = table("velocity_sweep").where("velocity", 0.94);
  const auto linear = sweep.at("s", 0), soft = sweep.at("s", -0.7);
  less(soft["packet"], bound(1) * soft["first_five"]);
  less(linear["first_five"], bound(1) * linear["packet"]);
  for (const char* lower : {"packet", "speed"}) less(soft[lower], linear[lower]);
}

STATEMENT("impact.snapshot") {
  less(bound(1), table("snapshot")["prominence"]);
}

STATEMENT("impact.support") {
  const Data shapes = table("packet_shape").where("velocity", weakest_impact, 1.5);
  for (const auto& packet : shapes) less(1 - bound(0.1), packet["seven"]);
  reading("hundredth", [&] {
    for (const auto& packet : shapes) within(packet["width"], 6, 8);
  });
}

STATEMENT("impact.tail") {
  answer(largest(table("packet_shape").where("velocity", weakest_impact, 1.5), "tail"), "");
}

STATEMENT("impact.decay") {
  const Data decay = table("packet_decay");
  const auto faster_and_faster = [&](const char* amplitude) {
    for (double velocity : {weakest_impact, 0.05, 0.1, 0.2, 0.5, 1.0, 1.5}) {
      const Data ahead = decay.where("velocity", velocity);
      if (ahead.size() < 3) throw Unresolved{"a decay over two sites"};
      for (const auto* site = ahead.begin() + 2; site < ahead.end(); ++site)
        less(site[0][amplitude] / site[-1][amplitude], site[-1][amplitude] / site[-2][amplitude]);
    }
  };
  faster_and_faster("amplitude");
  reading("from_peak", [&] { faster_and_faster("from_peak"); });
}

STATEMENT("blowup.bands") {
  for (double s : soft_wells) {
    const Band found = band(table("blowup_scan").where("s", s));
    // A single threshold would be one change of the outcome, and no survivor above it
    less(1.5, exact(found.changes));
    less(0.5, exact(found.survivors_above));
  }
}
