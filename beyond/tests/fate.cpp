// Which struck packets turn round, pass the horizon or stay.

#include <cmath>

#include "check.hpp"
#include "sec34/fate.hpp"

using namespace lattice;

TEST_CASE("hard wells turn the packet, linear and soft ones do not", "[property][boomeron]") {
  CHECK(outcome_of(2, 1, 40, 0).fate == Fate::turns);
  CHECK(outcome_of(2, 0, 40, 0).fate == Fate::escapes);
  CHECK(outcome_of(2, 0.005, 40, 0).fate == Fate::escapes);
  CHECK(outcome_of(0.5, 1, 30, 0).fate == Fate::escapes);
  CHECK(outcome_of(3, 20, 30, 0).fate == Fate::stays);
}

TEST_CASE("at small amplitude only s v0^(3/2) counts", "[property][boomeron]") {
  const auto apex = [](double velocity, double chi) {
    return outcome_of(velocity, chi / (velocity * std::sqrt(velocity)), 40, 0).apex;
  };
  const double small = apex(0.002, 1.3), smaller = apex(0.001, 1.3);
  check_close(small, smaller, 0, 0.1);
  CHECK(std::abs(apex(0.2, 1.3) - small) > 0.3 * small);
}
