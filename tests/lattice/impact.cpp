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
  trip.samples.resize(10);
  CHECK_FALSE(find_turn(trip).apex.found());  // exactly five neither
}

TEST_CASE("a chain is long enough for what travels in it", "[unit][model]") {
  struct Run {
    Chain like;
    double velocity, time;
  };
  for (const auto& [like, velocity, time] : {Run{{0, Quartic{1}}, 1.9, 200},
                                             {{0, NoWell{}}, 1.9, 200},
                                             {{0, NoWell{}}, 100, 300},
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
