/**
# Statements of section 3.4: From travelling breather to kink in pendulum wells */

#include <algorithm>
#include <vector>

#include "report/statement.hpp"

using namespace report;

STATEMENT("impact.kink") {
  const Data scan = table("kink_transition").where("velocity", 1, 8);
  std::vector<Data::Row> decided;
  for (const auto& impact : scan)
    if (impact["decided"].value > 0) decided.push_back(impact);

  const auto stays = [](const Data::Row& impact) { return impact["advanced"].value == 0; };
  const auto is_kink = [](const Data::Row& impact) {
    return impact["advanced"].value == 50 && impact["ejected_far"].value > 0;  // all beads
  };
  const auto first_moved = std::find_if_not(decided.begin(), decided.end(), stays);
  const auto last_without = std::find_if_not(decided.rbegin(), decided.rend(), is_kink);
  const auto breathers = exact(double(first_moved - decided.begin())),
             kinks = exact(double(last_without - decided.rbegin()));
  not_more(1, breathers);
  not_more(1, kinks);
  less(exact(1) - (breathers + kinks) / exact(double(scan.size())), bound(0.05));
}

STATEMENT("impact.kink_soliton") {
  // Over the speed of the pulse without wells that moves each bead by as many wells
  const auto ratio = [&](double impact) {
    const auto kink = table("kink_shape").at("velocity", impact);
    return kink["speed_far"] / kink["pulse_speed"];
  };
  answer(ratio(8), "of the soliton's speed");
  reading("slow", ratio(5));
  reading("strong", ratio(64));
}

STATEMENT("impact.no_blowup_pendulum") {
  for (const auto& impact : table("confinement").where("velocity", 2, 6)) {
    for (const char* part : {"speed", "way"}) less(impact[part], 1 + bound(0.001));
    control([&] { less(impact["drift"], 1e-3); });
  }
}
