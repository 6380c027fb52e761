/**
# Statements of section 1: The chain */

#include "report/statement.hpp"

using namespace report;

STATEMENT("chain.travelling_decay") {
  // An exponential falls by the same factor from each bead to the next
  const auto falls = [&](const char* side) {
    increases(table("decay").where("side", side), "beads", "log_ratio");
  };
  falls("ahead");
  reading("behind", [&] { falls("behind"); });
}
