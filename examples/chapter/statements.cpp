// What we say about the tables. A comparison holds by more than the errors, or the statement fails.
#include <iostream>

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("packets_are_slow_among_unequal_beads") {
  const Data speeds = table("own_chain", "speeds");
  for (const auto& row : speeds.where("mu", 0.8, 0.95))
    less(row["speed"], speeds.at("mu", 1)["speed"]);
}

int main(int, char** argv) {
  Tables tables(argv[1]);  // the folder of the tables
  bool all = true;
  for (const auto& [id, statement] : statements()) {
    const Judged found = statement.judge(tables);
    const bool holds = found.lost.empty() && outcome_of(found.comparisons) == Outcome::holds;
    std::cout << id << (holds ? " holds: " : " FAILS: ") << found.lost << found.text() << '\n';
    all = all && holds;
  }
  return all ? 0 : 1;
}
