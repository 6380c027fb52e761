// What we say about the tables. A comparison holds by more than the errors, or the statement fails.
#include "report/statement.hpp"

using namespace lattice;

STATEMENT("packets_are_slow_among_unequal_beads") {
  const Data speeds = table("own_chain", "speeds");
  for (const auto& row : speeds.where("mu", 0.8, 0.98))
    less(row["speed"], speeds.at("mu", 1)["speed"]);
}

int main(int, char** argv) {
  return all_hold(argv[1]) ? 0 : 1;
}
