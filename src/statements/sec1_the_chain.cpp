/**
# Statements of section 1: The chain */

#include "report/statement.hpp"

using namespace lattice;

STATEMENT("chain.travelling_decay") {
  // An exponential falls by the same factor from each bead to the next
  const auto falls = [&](const char* side, const char* measure) {
    increases(table("decay").where("side", side), "beads", measure);
  };
  falls("ahead", "energy");
  reading("instant", [&] { falls("ahead", "instant"); });
  reading("displacement", [&] { falls("ahead", "displacement"); });
  reading("behind", [&] { falls("behind", "energy"); });
}
