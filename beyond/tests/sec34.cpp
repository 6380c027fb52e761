// Packets from which waves are taken away: what a cut keeps, what friction takes, what comes back.

#include <cmath>

#include "lattice/gsl/reference.hpp"
#include "sec34/fate.hpp"
#include "sec34/wake.hpp"
#include "support/check.hpp"

using namespace lattice;

/// An impact on hard wells whose strongest packet is followed.
static Impact turning_impact(double velocity, double s, double time, std::size_t sites) {
  return {.velocity = velocity,
          .chain = {sites, Quartic{s}},
          .time = time,
          .denser = false,
          .packet = WhichPacket::strongest};
}

TEST_CASE("a cut keeps the packet and nothing else", "[unit][wake]") {
  const Chain chain{60, Quartic{1}};
  const ImpactRun run = strike(EventCorrected{0.1}, turning_impact(1.9, 1, 60, 60));
  const State<double> whole = run.end, alone = cut_out(chain, whole, 100);
  const std::size_t peak = peak_index(energy_density(chain, whole));
  REQUIRE(alone.y.size() == 160);
  CHECK(alone.t == whole.t);
  for (std::size_t n = 0; n < 60; ++n) {
    const bool kept = n + 6 >= peak && n <= peak + 6;
    CHECK(alone.y[n + 100] == (kept ? whole.y[n] : 0));
    CHECK(alone.v[n + 100] == (kept ? whole.v[n] : 0));
  }
}

TEST_CASE("with nothing taken away the packet is that of the impact", "[unit][wake]") {
  const Path path = follow_without({}, 0.1, 120, 60),  // with this step both look every 0.2
      whole = strike(EventCorrected{0.1}, turning_impact(1.9, 1, 120, 60)).path;
  REQUIRE(path.t.size() + 1 == whole.t.size());
  for (std::size_t i = 0; i < path.t.size(); i += 50)
    check_close(path.centre[i], whole.centre[i], 1e-5);
}

TEST_CASE("what friction takes is missing, and a cut takes nothing of the packet", "[unit][wake]") {
  double last = 0, gone = 0;
  follow_without({.behind = 6, .counted = true}, 0.05, 150, 60, [&](const WakeSample& now) {
    last = energy(now.chain, now.state), gone = now.dissipated;
    return true;
  });
  check_close(last + gone, 1.9 * 1.9 / 2, 1e-6);
  CHECK(gone > 0.1);
  const Path cut = follow_without({.cut = 60}, 0.05, 61, 60),
             whole = follow_without({}, 0.05, 61, 60);
  check_close(cut.centre.back(), whole.centre.back(), 0.05);
  check_close(cut.energy.back(), whole.energy.back(), 0.01);
}

TEST_CASE("the changes of a budget cancel", "[unit][wake]") {
  for (const WavesRemoved& impact : {WavesRemoved{}, WavesRemoved{.behind = 6}}) {
    const Budget b = budget(impact, 0.1, 100, 150);
    CHECK(std::abs(b.packet + b.near + b.far + b.friction) < 1e-3);
    CHECK(b.push_behind > 0);
    CHECK(b.push_ahead < b.push_behind / 20);  // the contact ahead is outside, and nearly at rest
    CHECK((b.friction > 1e-3) == (impact.behind > 0));
  }
}

TEST_CASE("waves close behind a packet bring it back early", "[property][wake]") {
  const LateFate with = late_fate({.velocity = 1.84, .behind = 15}, 0.1, 1500, 150),
                 without = late_fate({.velocity = 1.84, .behind = 6}, 0.1, 1500, 150);
  CHECK(with.late == Late::returns);
  check_close(with.furthest, 27.97, 0.1);
  CHECK(without.late == Late::goes_on);
  CHECK(without.furthest > 40);
}

TEST_CASE("a wave that reaches an end is no result", "[unit][wake]") {
  CHECK_THROWS_AS(follow_without({.s = 0}, 0.1, 120, 20), std::runtime_error);
}

TEST_CASE("a cut packet goes on as GSL says", "[unit][wake]") {
  const double cut = 60, until = 100;
  const Chain chain{160, Quartic{1}};
  const State<double> start =
      cut_out(Chain{80, Quartic{1}},
              strike(EventCorrected{0.0125}, turning_impact(1.9, 1, cut, 80)).end, 80);
  State<double> end = start;
  evolve(EventCorrected{0.0125}, chain, end, until - cut, path_sampling);
  CHECK(distance_from_reference(chain, start, until - cut, end, 1e-6) < 1e-6);
  const Path path =
      follow_without({.cut = cut}, 0.0125, until + 0.025, 80);  // its last look is at `until`
  Path last;
  last.add(end.t, energy_density(chain, end));
  check_close(path.centre.back() + 80, last.centre.back(), 1e-4);
}

TEST_CASE("inside the packet there is a breather", "[unit][wake]") {
  const std::vector<Inside> rows = gauge({}, 0.1, 161);
  REQUIRE(rows.size() == 8);
  for (std::size_t k = 5; k < rows.size(); ++k) {
    check_close(rows[k].omega, 1.68, 0.02);
    check_close(rows[k].area, 6, 0.4);
    check_close(rows[k].t, 20 * double(k) + 10, 0.2);
  }
}

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
