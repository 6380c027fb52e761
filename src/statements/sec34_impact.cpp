/**
# Statements of section 3.4: Strong impacts in soft wells: surface mode and blow-up */

#include <cmath>

#include "report/statement.hpp"

using namespace lattice;

static constexpr double soft_wells[] = {-1.0 / 6, -0.7};

STATEMENT("impact.ampvel") {
  const Data sweep = table("velocity_sweep"), linear = sweep.where("s", 0);
  for (double s : soft_wells)
    for (const char* curve : {"speed", "peak"}) {
      const auto apart = [&](const Data::Row& soft) {
        return abs(soft[curve] / linear.at("velocity", soft("velocity"))[curve] - 1);
      };
      const Data soft = sweep.where("s", s), weak = soft.where("velocity", 0.01, 0.05);
      for (const auto& impact : weak) less(apart(impact), 0.01);
      // They meet, and are not only close
      less(largest(weak, apart), 0.5 * largest(soft.where("velocity", 0.01, 0.5), apart));
    }
}

STATEMENT("impact.slower") {
  const Data sweep = table("velocity_sweep"), linear = sweep.where("s", 0);
  for (double s : soft_wells)
    for (const auto& soft : sweep.where("s", s).where("velocity", 0.3, HUGE_VAL))
      for (const char* curve : {"speed", "peak", "energy"})
        less(soft[curve], linear.at("velocity", soft("velocity"))[curve]);
}

/// On the grid of a scan; an impact whose outcome depends on the time step is ignored.
struct Band {
  Estimate first_escape, last_survivor, disputed;
};
static Band band(const Data& scan) {
  if (scan.size() < 2) throw Unresolved{"a scan of one impact"};
  const double spacing = scan.begin()[1]("velocity") - scan.begin()[0]("velocity");
  std::vector<Estimate> escapes, survivors;
  for (const auto& impact : scan) {
    const bool escaped = impact["escaped"].value > 0, agreed = impact["agree"].value > 0;
    if (agreed) (escaped ? escapes : survivors).push_back({impact("velocity"), spacing});
  }
  const auto disagree = [](const Data::Row& impact) { return exact(1) - impact["agree"]; };
  return {least_of(escapes), largest_of(survivors), mean(scan, disagree)};
}

STATEMENT("impact.blowup") {
  for (double s : soft_wells) {
    const Data scan = table("blowup_scan").where("s", s);
    const auto &weakest = scan.begin()[0], &strongest = scan.end()[-1];
    less(weakest["escaped"], 0.5);
    less(0.5, strongest["escaped"]);
    for (const auto& end : {weakest, strongest}) less(0.5, end["agree"]);
    const Band found = band(scan);
    less(weakest("velocity"), found.first_escape);
    less(found.last_survivor, strongest("velocity"));
    less(found.disputed, 0.05);
  }
}

STATEMENT("impact.surface_mode") {
  const Data shares = table("shares").where("velocity", 0.94);
  const auto linear = shares.at("s", 0), soft = shares.at("s", -0.7);
  less(soft["packet"], soft["first_five"]);
  less(linear["first_five"], linear["packet"]);
  less(soft["speed"], linear["speed"]);
}

STATEMENT("impact.snapshot") {
  less(1, table("snapshot")["prominence"]);
}

STATEMENT("impact.tail") {
  answer(table("packet_shape").at("velocity", 1)["tail"]);
}

STATEMENT("blowup.bands") {
  for (double s : soft_wells) {
    const Band found = band(table("blowup_scan").where("s", s));
    less(found.first_escape, found.last_survivor);
  }
}
