/**
# Statements of section 3.4: From travelling breather to kink in pendulum wells */

#include <algorithm>

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("impact.kink") {
  const auto becomes_kink = [&](const Data& scan, double beads) {
    std::vector<Data::Row> decided;
    for (const auto& impact : scan)
      if (impact["decided"].value > 0) decided.push_back(impact);

    const auto stays = [](const Data::Row& impact) { return impact["advanced"].value == 0; };
    const auto is_kink = [&](const Data::Row& impact) {
      return impact["advanced"].value == beads && impact["ejected_far"].value > 0;  // all beads
    };
    const auto first_moved = std::find_if_not(decided.begin(), decided.end(), stays);
    const auto last_without = std::find_if_not(decided.rbegin(), decided.rend(), is_kink);
    const auto breathers = exact(double(first_moved - decided.begin())),
               kinks = exact(double(last_without - decided.rbegin()));
    not_more(1, breathers);
    not_more(1, kinks);
    less(exact(1) - (breathers + kinks) / exact(double(scan.size())), bound(0.05));
  };
  becomes_kink(table("kink_transition").where("velocity", 1, 8), 50);
  reading("hundred_beads",
          [&] { becomes_kink(table("hundred_beads").where("velocity", 1, 8), 100); });
}

STATEMENT("impact.kink_soliton") {
  const Data kinks = table("kink_shape").where("velocity", 5, 64);
  const auto apart = [](const char* kink, const char* pulse) {
    return [=](const Data::Row& row) { return abs(row[kink] / row[pulse] - 1); };
  };
  const auto length = apart("length", "pulse_length"), law = apart("scaled", "pulse_scaled");
  for (const auto& row : kinks) {
    less(length(row), bound(0.5));
    less(law(row), bound(0.5));
  }
  // The stronger the impact, the more alike, and the faster
  for (const auto& alike : {length, law}) less(alike(kinks.end()[-1]), alike(kinks.begin()[0]));
  increases(kinks, "velocity", "speed");
  reading("without_wells", [&] {
    const auto speed = apart("speed", "pulse_speed");
    for (const auto& row : kinks) {
      less(length(row), bound(0.5));
      less(speed(row), bound(0.5));
    }
  });
}

STATEMENT("impact.no_blowup_pendulum") {
  for (const auto& impact : table("confinement").where("velocity", 2, 6)) {
    for (const char* part : {"speed", "way"}) less(impact[part], 1 + bound(0.001));
    less(1 - bound(0.001), impact["lasted"]);
    control([&] { less(impact["drift"], 1e-3); });
  }
}
