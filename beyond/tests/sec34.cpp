// Packets whose waves are absorbed: what friction takes, what comes back.

#include <algorithm>
#include <cmath>

#include "sec34/wake.hpp"
#include "support/check.hpp"

using namespace lattice;

TEST_CASE("with nothing absorbed the packet is that of the impact", "[unit][wake]") {
  const Impact impact{.velocity = 1.9,
                      .chain = {60, Quartic{1}},
                      .time = 120,
                      .denser = false,
                      .packet = WhichPacket::strongest};
  const Path path = follow_without({}, 0.1, 120, 60),  // with this step both look every 0.2
      whole = strike(EventCorrected{0.1}, impact).path;
  REQUIRE(path.size() + 1 == whole.size());
  for (std::size_t i = 0; i < path.size(); i += 50)
    check_close(path[i].centre, whole[i].centre, 1e-5);
}

TEST_CASE("friction acts where it should", "[unit][wake]") {
  // The largest speeds at t = 100: of the first bead, of those at least six sites behind the packet, of all
  struct Speeds {
    double first = 0, behind = 0, all = 0, energy = 0;
  };
  const auto speeds = [](const WavesAbsorbed& impact) {
    Speeds out;
    follow_without(
        impact, 0.05, 100, 60, [&](const State<double>& now, const std::vector<double>& density) {
          if (now.t < 90) return;
          const auto peak =
              std::size_t(std::max_element(density.begin(), density.end()) - density.begin());
          out.energy = energy(Chain{60, Quartic{1}}, now);
          out.first = std::max(out.first, std::abs(now.v[0]));
          for (std::size_t n = 0; n < 60; ++n) {
            double& most = n + 6 < peak ? out.behind : out.all;
            most = std::max(most, std::abs(now.v[n]));
          }
        });
    return out;
  };
  const Speeds all = speeds({}), behind = speeds({.behind = 6}), end = speeds({.first_bead = true});
  check_close(all.energy, 1.9 * 1.9 / 2, 1e-6);
  CHECK(behind.energy < all.energy - 0.1);
  CHECK(end.energy < all.energy - 0.001);
  CHECK(end.energy > behind.energy);
  CHECK(behind.behind < all.behind / 2);
  CHECK(behind.all > 0.9 * all.all);
  CHECK(end.first < all.first);
}

TEST_CASE("an absorber behind the packet delays its turn", "[property][wake]") {
  const LateFate all = late_fate({}, 0.1, 1000, 400),
                 behind = late_fate({.behind = 6}, 0.1, 1000, 400);
  CHECK(all.late == Late::returns);
  CHECK(behind.late == Late::goes_on);
  check_close(all.furthest, 20.05, 0.01);
  CHECK(behind.furthest > 40);
  CHECK(late_fate({.s = 0}, 0.1, 1000, 400).late == Late::goes_on);
}

TEST_CASE("a wave that reaches the end is no result", "[unit][wake]") {
  CHECK_THROWS_AS(follow_without({.s = 0}, 0.1, 120, 20), std::runtime_error);
}
