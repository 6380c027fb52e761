// What we say about the tables. A comparison holds by more than the errors, or the statement fails.
#include "report/statement.hpp"

using namespace lattice;
using namespace report;

STATEMENT("lighter_beads_make_the_packet_slower_and_weaker") {
  const Data speeds = table("own_chain", "speeds").where("mu", 0.94, 1);
  increases(speeds, "mu", "speed");
  increases(speeds, "mu", "fraction");
}

int main(int, char** argv) {
  return all_hold(argv[1]) ? 0 : 1;
}
