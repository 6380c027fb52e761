/**
# Statements of section 3.4: From travelling breather to kink in pendulum wells */

#include <algorithm>

#include "report/statement.hpp"

using namespace lattice;

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
  less(exact(1) - (breathers + kinks) / exact(double(scan.size())), 0.05);
}

STATEMENT("impact.no_blowup_pendulum") {
  for (const auto& impact : table("confinement").where("velocity", 2, 6)) {
    for (const char* bound : {"speed", "way"}) less(impact[bound], 1.001);
    less(impact["drift"], 1e-3);
    less(0.999, impact["lasted"]);
  }
}
