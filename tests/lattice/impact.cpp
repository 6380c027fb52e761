// Impacts: how long an endless chain is, and packets that turn round.

#include "lattice/impact/impact.hpp"

#include <cmath>

#include "lattice/impact/turning.hpp"
#include "support/check.hpp"

using namespace lattice;

namespace {

/// A path made by hand, with a ripple of the internal oscillation.
template <class Centre>
Path drawn(double time, Centre centre) {
  Path path;
  for (double t = 0; t <= time; t += path_sampling)
    path.add(t, centre(t) + 0.3 * std::cos(3.4 * t));
  return path;
}

double steady(double t) {
  return 1 + 0.1 * t;
}

/// A ball that is thrown to site 22, at the time `top`, and bounces at site 1.
Path thrown(double top) {
  return drawn(600, [=](double t) { return 1 + std::abs(21 - 0.0005 * (t - top) * (t - top)); });
}

}  // namespace

TEST_CASE("an endless chain is longer than the way of the fastest wave of its stiffest contact",
          "[unit][boomeron]") {
  struct Blow {
    double velocity;
    Contact contact;
    double stiffness;
  };
  for (const auto& [velocity, contact, k] : {Blow{3, Hertz{}, 0.8 * std::pow(3, 0.4)},
                                             {0.1, CompressedHertz{0.9}, 1.5 * std::sqrt(0.9)}}) {
    // The largest group velocity of omega^2 = 1 + 4 k sin^2(q/2), sought among the wavenumbers
    double fastest = 0;
    for (double q = 0.001; q < 3.14; q += 0.001)
      fastest =
          std::max(fastest, k * std::sin(q) / std::sqrt(1 + 4 * k * std::pow(std::sin(q / 2), 2)));
    const auto sites = on_long_chain({velocity, {7, Harmonic{}, contact}, 1e6}).chain.sites;
    check_close(double(sites), 100 + 1.15e6 * fastest, 2, 1e-6);
  }
}

TEST_CASE("a thrown ball turns at its apex and rebounds at the ground", "[unit][boomeron]") {
  const Turn turn = find_turn(smooth(thrown(200), path_smoothing));
  check_close(turn.apex.time, 200, 0.5);
  check_close(turn.apex.site, 22, 0.05);
  check_close(turn.stop.time, 200, 0.5);
  check_close(turn.rebound.time, 200 + std::sqrt(21 / 0.0005), 3);
  // The errors of a turn are those of step and smoothing
  const TurnEstimate estimate = estimate_turn(thrown(200), thrown(204));
  check_close(estimate.apex_time.value, 204, 0.5);
  CHECK(estimate.apex_time.error > 3);
  CHECK(estimate.apex_time.error < 10);
  const auto run = [](Path path) {
    return ImpactRun{.end = State<double>(1), .path = std::move(path)};
  };
  const ImpactRun a = run(thrown(200)), b = run(thrown(204)), c = run(drawn(600, steady));
  CHECK(SameTurn{}(a, a) == 0);
  CHECK(SameTurn{}(a, b) > 0.005);
  CHECK(std::isinf(SameTurn{}(a, c)));
}

TEST_CASE("a packet that is caught, slows down or goes on has not turned", "[unit][boomeron]") {
  const auto caught = [](double t) { return 20 - 19 * std::exp(-t / 40) + 0.8 * std::sin(t / 20); };
  const Turn swing = find_turn(smooth(drawn(800, caught), path_smoothing));
  CHECK(swing.stop.found());
  CHECK_FALSE(swing.apex.found());
  const auto slow = [](double t) { return 1 + 4 * std::sqrt(t); };
  const Turn away = find_turn(smooth(drawn(800, slow), path_smoothing));
  CHECK_FALSE(away.stop.found());
  CHECK_FALSE(away.apex.found());
  // Without smoothing the ripple passes for a stop
  CHECK(find_turn(drawn(300, steady)).stop.found());
  CHECK_FALSE(find_turn(smooth(drawn(300, steady), path_smoothing)).stop.found());
}

TEST_CASE("a turn by hand", "[unit][turning]") {
  // Out with a stop before site 8 and one beyond it, back by five from 14 at 7, again by three from 4 at 12
  Path trip;
  for (const double x :
       {1., 7., 6., 9., 8.5, 12., 13., 14., 13.5, 9., 10., 8., 4., 6., 7., 7.01, 3.})
    trip.add(double(trip.size()), x);
  const Turn turn = find_turn(trip);
  check_close(turn.stop.time, vertex(trip, 3).time, 1e-14);
  check_close(turn.apex.time, vertex(trip, 7).time, 1e-14);
  check_close(turn.rebound.time, vertex(trip, 12).time, 1e-14);
  trip.samples[15].centre = 7;  // exactly three sites are not enough
  CHECK_FALSE(find_turn(trip).rebound.found());
  CHECK(find_turn(trip, 5, 2.9).rebound.found());
  trip.samples.resize(10);
  CHECK_FALSE(find_turn(trip).apex.found());  // exactly five neither
  CHECK(find_turn(trip, 4.9).apex.found());
  CHECK(find_turn(trip, 5, 3, 6.9).stop.time == vertex(trip, 1).time);
  CHECK(find_turn(trip, 5, 3, 7).stop.time == vertex(trip, 3).time);
}

TEST_CASE("the apex converges with the step", "[convergence][boomeron]") {
  const Impact impact{.velocity = 1.95,
                      .chain = {150, Quartic{1}},
                      .time = 700,
                      .denser = false,
                      .packet = WhichPacket::strongest};
  double apex[3];
  for (int k : {0, 1, 2})
    apex[k] = turn_of(strike(EventCorrected{0.2 / (1 << k)}, impact).path).apex.site;
  CHECK(std::abs(apex[2] - apex[1]) < std::abs(apex[1] - apex[0]) / 4);
  CHECK(std::abs(apex[2] - apex[1]) < 1e-3);
}

TEST_CASE("a chain is long enough for what travels in it", "[unit][model]") {
  struct Run {
    Chain like;
    double velocity, time;
  };
  for (const auto& [like, velocity, time] : {Run{{0, Quartic{1}}, 1.9, 200},
                                             {{0, NoWell{}}, 1.9, 200},
                                             {{0, NoWell{}}, 100, 60},
                                             {{0, NoWell{}, CompressedHertz{4}}, 1, 60}}) {
    const Impact impact = on_long_chain({velocity, like, time});
    CAPTURE(velocity, impact.chain.sites);
    CHECK(impact.chain.sites < 4 * std::size_t(time) + 100);
    CHECK(strike(EventCorrected{0.05}, impact).far_end <= 1e-12 * velocity);
  }
}

TEST_CASE("a run that its far end sends back is no result", "[unit][model]") {
  Impact impact{1.9, {30}, 100};
  CHECK_THROWS_AS(strike(EventCorrected{0.05}, impact), FarEndReached);
  impact.far_end = may_move;
  CHECK(strike(EventCorrected{0.05}, impact).far_end > 0.01);
  // The packet leaves before it is back, so here the same chain will do
  impact.far_end = 1e-9, impact.until = 20;
  CHECK(strike(EventCorrected{0.05}, impact).path.back().centre >= 20);
}

TEST_CASE("an impact in two parts is the impact", "[unit][model]") {
  const Impact impact{1.9, {60, Quartic{1}}, 60};
  const ImpactRun whole = strike(EventCorrected{0.1}, impact);
  ImpactRun parts{struck(60, 1.9)};
  continue_strike(EventCorrected{0.1}, impact, parts, 20);
  continue_strike(EventCorrected{0.1}, impact, parts, 60);
  CHECK(whole.end.y == parts.end.y);
  CHECK(whole.density == parts.density);
  CHECK(whole.run.steps == parts.run.steps);
}
