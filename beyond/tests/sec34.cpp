// Packets whose waves are absorbed: what friction takes, what comes back.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lattice/integrators/event_corrected.hpp"
#include "lattice/orbits/breather.hpp"
#include "sec34/momentum.hpp"
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
    follow_without(impact, 0.05, 100, 60,
                   [&](const State<double>& now, const std::vector<double>& density, double) {
                     if (now.t < 90) return;
                     const auto peak = std::size_t(
                         std::max_element(density.begin(), density.end()) - density.begin());
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

TEST_CASE("a packet that is isolated keeps its sites, and the rest is at rest", "[unit][wake]") {
  // What one look at t = 100 sees, and where the packet is with all waves
  const auto seen = [](const WavesAbsorbed& impact) {
    struct {
      State<double> state{};
      double centre = 0;
    } out;
    follow_without(impact, 0.1, 100.4, 200,
                   [&](const State<double>& now, const std::vector<double>&, double centre) {
                     if (std::abs(now.t - 100) < 1e-6) out = {now, centre};
                   });
    return out;
  };
  const auto all = seen({}), wiped = seen({.wiped = 100}), moved = seen({.moved = 100});
  CHECK(std::abs(wiped.centre - all.centre) < 1e-12);
  CHECK(std::abs(moved.centre - all.centre) < 1e-2);
  const auto moving = [](const State<double>& state) {
    return std::count_if(state.v.begin(), state.v.end(), [](double v) { return v != 0; });
  };
  CHECK(moving(moved.state) <= 17);
  CHECK(moving(wiped.state) < moving(all.state));
  const auto peak = std::size_t(std::lround(all.centre)) - 1;
  for (std::size_t n = peak; n < peak + 4; ++n) {
    check_close(wiped.state.y[n], all.state.y[n], 1e-12);
  }
}

TEST_CASE("the balance of the momentum is its derivative", "[property][momentum]") {
  // A short step of the equations of motion from a state of no symmetry
  Chain chain{30, Quartic{0.7}};
  State<double> state(30);
  for (std::size_t n = 0; n < 30; ++n) {
    state.y[n] = std::sin(2.1 * double(n)) * std::cos(0.3 * double(n));
    state.v[n] = std::cos(1.7 * double(n) + 0.4);
  }
  const auto acceleration = accelerations(chain, state.y);
  const double h = 1e-5;
  const auto moved = [&](double t) {
    State<double> out = state;
    for (std::size_t n = 0; n < 30; ++n) {
      out.y[n] += t * state.v[n] + t * t / 2 * acceleration[n];
      out.v[n] += t * acceleration[n];
    }
    return momentum(out, 8, 20);
  };
  const Terms rate = rates(chain, state, 8, 20);
  check_close(rate.edges + rate.wells + rate.contacts, (moved(h) - moved(-h)) / (2 * h), 1e-6);
  CHECK(rates({30, Quartic{0}}, state, 8, 20).wells == 0);
}

TEST_CASE("a breather at rest has its action and no momentum", "[property][momentum]") {
  for (double s : {0.0, 1.0}) {
    const Orbit<double> orbit = find_breather(breather_problem(Centre::bond, 1.6, s, 24));
    const Chain chain{60, Quartic{s}};
    State<double> state = resized(orbit.start, 60);
    Gauge gauge(chain, 64);
    evolve(EventCorrected{0.1}, chain, state, 140, Every{0.1},
           [&](const State<double>& now) { gauge(now, energy_density(chain, now), 0); });
    check_close(gauge.all[1].action, orbit.action_integral / (2 * std::numbers::pi), 0.01);
    check_close(gauge.all[1].frequency, 1.6, 0.01);
    check_close(gauge.all[1].energy, orbit.energy, 1e-6);
    CHECK(std::abs(gauge.all[1].momentum) < 1e-3);
  }
}
