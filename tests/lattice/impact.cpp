// Packets that turn round: what counts as turning, what the chain does, the program.

#include <cmath>
#include <string>

#include "commands/one_turn.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/impact/turning.hpp"
#include "sec34/acceleration.hpp"
#include "support/check.hpp"
#include "support/run.hpp"

using namespace lattice;

namespace {

/// A path made by hand, with a ripple of the internal oscillation.
template <class Centre>
Path drawn(double time, double ripple, Centre centre) {
  Path path;
  for (double t = 0; t <= time; t += path_sampling) {
    path.t.push_back(t);
    path.centre.push_back(centre(t) + ripple * std::cos(3.4 * t));
    path.energy.push_back(1);
  }
  return path;
}

}  // namespace

TEST_CASE("a thrown ball turns at its apex and rebounds at the ground", "[unit][boomeron]") {
  const auto ball = [](double t) { return std::abs(1 + 0.2 * t - 0.0005 * t * t) + 1; };
  const Turn turn = find_turn(smooth(drawn(600, 0.3, ball), path_smoothing));
  check_close(turn.apex.time, 200, 0.5);
  check_close(turn.apex.site, 22, 0.05);
  check_close(turn.stop.time, 200, 0.5);
  check_close(turn.rebound.time, 200 + std::sqrt(21 / 0.0005), 3);
}

TEST_CASE("a packet that is caught, or only slows down, has not turned", "[unit][boomeron]") {
  const auto caught = [](double t) { return 20 - 19 * std::exp(-t / 40) + 0.8 * std::sin(t / 20); };
  const Turn swing = find_turn(smooth(drawn(800, 0.3, caught), path_smoothing));
  CHECK(swing.stop.found());
  CHECK_FALSE(swing.apex.found());
  const auto slow = [](double t) { return 1 + 4 * std::sqrt(t); };
  const Turn away = find_turn(smooth(drawn(800, 0.3, slow), path_smoothing));
  CHECK_FALSE(away.stop.found());
  CHECK_FALSE(away.apex.found());
}

TEST_CASE("without smoothing the ripple passes for a stop", "[unit][boomeron]") {
  const auto steady = [](double t) { return 1 + 0.1 * t; };
  CHECK(find_turn(drawn(300, 0.3, steady)).stop.found());
  CHECK_FALSE(find_turn(smooth(drawn(300, 0.3, steady), path_smoothing)).stop.found());
}

TEST_CASE("a turning carries the errors of step and smoothing", "[unit][boomeron]") {
  const auto thrown = [](double top) {
    const auto ball = [top](double t) { return 1 + std::abs(21 - 0.0005 * (t - top) * (t - top)); };
    return ImpactRun{.end = State<double>(1), .path = drawn(600, 0.3, ball)};
  };
  const ImpactRun a = thrown(200), b = thrown(204);
  const TurnEstimate turn = estimate_turn(a.path, b.path);
  check_close(turn.apex_time.value, 204, 0.5);
  CHECK(turn.apex_time.error > 3);
  CHECK(turn.apex_time.error < 10);
  CHECK(SameTurn{}(a, a) == 0);
  CHECK(SameTurn{}(a, b) > 0.005);
  ImpactRun steady = a;
  steady.path = drawn(600, 0.3, [](double t) { return 1 + 0.1 * t; });
  CHECK(std::isinf(SameTurn{}(a, steady)));
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

TEST_CASE("runs decorrelate the later the less they differ", "[unit][boomeron]") {
  const Chain chain{60, Quartic{1}};
  const EventCorrected method{0.1};
  const auto time = [&](double delta) {
    return decorrelation_time(method, struck(60, 1.9), method, struck(60, 1.9 * (1 + delta)), chain,
                              300);
  };
  CHECK(std::isinf(time(0)));
  CHECK(time(1) == 0);
  CHECK(time(3e-2) < time(3e-3));
  CHECK(time(3e-3) < 300);
}

TEST_CASE("the boomeron run keeps its contract", "[cli][boomeron]") {
  const Result r = call("sec34_boomeron run --velocity 1.9 --s 1 --time 1000");
  REQUIRE(r.code == 0);
  check_close(quantity(r, "apex_site"), 20.06, 0.05);
  check_close(quantity(r, "apex_time"), 466.6, 2);
  check_close(quantity(r, "return_time"), 897.7, 1);
  CHECK(quantity(r, "decorrelation_time") > 900);
  const std::string brief = "sec34_boomeron run --time 60 --tolerance 0.01";
  CHECK(body(call(brief).output) == body(call(brief + " --sites 300").output));
  const Result never = call("sec34_boomeron run --velocity 1 --s 0 --time 200");
  REQUIRE(never.code == 0);
  CHECK(std::isnan(quantity(never, "apex_site")));
}

// In chains of a length of their own; the times of parting are those of an extrapolating integrator elsewhere, which
// looks every two units too
TEST_CASE("two impacts part because they differ, not because of the step", "[cli][boomeron]") {
  for (const auto& [impact, when] : std::vector<std::pair<std::string, double>>{
           {"--velocity 50 --s 0.01 --time 200 --sites 120", 730},
           {"--velocity 25.5 --s 0.0491 --time 100 --sites 80", 290},
           {"--velocity 52.7 --s 0.0292 --time 100 --sites 80", 116},
           {"--velocity 1.22 --s 5.34 --time 100 --sites 80", 364}}) {
    CAPTURE(impact);
    const Result r = call("sec34_boomeron run " + impact);
    CHECK(std::abs(quantity(r, "decorrelation_time") - when) < 1e-9);
    CHECK(quantity(r, "decorrelation_time", "error") <= 4.1);
  }
}

TEST_CASE("no phonon reaches the end of an endless chain", "[unit][boomeron]") {
  // The largest group velocity of omega^2 = 1 + 4 k sin^2(q/2), sought among the wavenumbers.
  const Chain chain{0, Quartic{1}, CompressedHertz{0.5}};
  const double k = chain.contact.stiffness(0.0), time = 2000;
  double fastest = 0;
  for (double q = 0.001; q < 3.14; q += 0.001)
    fastest =
        std::max(fastest, k * std::sin(q) / std::sqrt(1 + 4 * k * std::pow(std::sin(q / 2), 2)));
  const double sites = double(on_long_chain({0.1, chain, time}).chain.sites);
  CHECK(sites > fastest * time);
  CHECK(sites < 2 * fastest * time);
}

namespace {

using Numbers = std::vector<double>;

const double turn_angle = std::acos(-1.0);

/// Numbers between 0 and 1 without any order.
Numbers dust(std::size_t count, double seed) {
  Numbers x(count);
  for (std::size_t n = 0; n < count; ++n)
    x[n] = std::pow(std::sin(seed + 12.9898 * double(n * n) + 3.7 * double(n)), 2);
  return x;
}

/// The same numbers to ten digits.
void check_all(const Numbers& value, const Numbers& expected, double absolute = 1e-10) {
  REQUIRE(value.size() == expected.size());
  std::size_t worst = 0;
  for (std::size_t i = 0; i < value.size(); ++i)
    if (!(std::abs(value[i] - expected[i]) <= std::abs(value[worst] - expected[worst])) &&
        std::isfinite(value[worst]))
      worst = i;
  CAPTURE(worst);
  check_close(value[worst], expected[worst], absolute);
}

}  // namespace

TEST_CASE("a path is smoothed, and its turn is found, by hand", "[unit][turning]") {
  Path path;
  const Numbers c = dust(30, 0.2), e = dust(30, 0.9);
  for (std::size_t i = 0; i < 30; ++i)
    path.t.push_back(3 + 0.5 * double(i)), path.centre.push_back(c[i]), path.energy.push_back(e[i]);
  const Path smoothed =
      smooth(path, 4.3);  // four samples on either side, with the width 5 of the weight
  Numbers t, centre, energies;
  for (std::size_t i = 4; i < 26; ++i) {
    double sum = 0, x = 0, y = 0;
    for (int k = -4; k <= 4; ++k) {
      const double weight = std::pow(std::cos(turn_angle * k / 10), 2);
      const auto at = std::size_t(int(i) + k);
      sum += weight, x += weight * c[at], y += weight * e[at];
    }
    t.push_back(path.t[i]), centre.push_back(x / sum), energies.push_back(y / sum);
  }
  check_all(smoothed.t, t);
  check_all(smoothed.centre, centre);
  check_all(smoothed.energy, energies);
  Path three{{0, 1, 2}, {1, 2, 3}, {1, 1, 1}, {}};
  CHECK(smooth(three, 1).t.size() == 1);
  three.t.pop_back();
  CHECK_THROWS_AS(smooth(three, 1), std::invalid_argument);

  // Vertices: an inner one, one that is no extremum, one just at the bound, a straight line, both ends
  Path way{{0, 2, 4, 6, 8, 10, 12}, {1, 5, 4, 2, 1, 0, 0, -1}, {}, {}};
  way.centre.pop_back();  // what lies behind the last one does not count
  const std::vector<std::array<double, 3>> known{{1, 5 + 2.25 / 10, 2 + 2 * 0.3},
                                                 {2, 4, 4},
                                                 {3, 2, 6},
                                                 {4, 1, 8},
                                                 {5, 0 - 0.125, 11},
                                                 {0, 1, 0},
                                                 {6, 0, 12}};
  for (const auto& [i, site, time] : known) {
    CAPTURE(i);
    check_close(vertex(way, std::size_t(i)).site, site, 1e-14);
    check_close(vertex(way, std::size_t(i)).time, time, 1e-14);
  }
  CHECK_FALSE(Moment{}.found());
  CHECK(std::isnan(Moment{}.site));

  // Out with a stop before site 8 and one beyond it, back by five from 14 at 7, again by three from 4 at 12
  Path trip;
  trip.centre = {1, 7, 6, 9, 8.5, 12, 13, 14, 13.5, 9, 10, 8, 4, 6, 7, 7.01, 3};
  for (std::size_t i = 0; i < trip.centre.size(); ++i) trip.t.push_back(double(i));
  trip.energy = trip.centre;
  const Turn turn = find_turn(trip);
  check_close(turn.stop.time, vertex(trip, 3).time, 1e-14);
  check_close(turn.apex.time, vertex(trip, 7).time, 1e-14);
  check_close(turn.rebound.time, vertex(trip, 12).time, 1e-14);
  trip.centre[15] = 7;  // exactly three sites are not enough
  CHECK_FALSE(find_turn(trip).rebound.found());
  CHECK(find_turn(trip, 5, 2.9).rebound.found());
  trip.centre.resize(10);
  CHECK_FALSE(find_turn(trip).apex.found());  // exactly five neither
  CHECK(find_turn(trip, 4.9).apex.found());
  CHECK(find_turn(trip, 5, 3, 6.9).stop.time == vertex(trip, 1).time);
  CHECK(find_turn(trip, 5, 3, 7).stop.time == vertex(trip, 3).time);
}

TEST_CASE("velocities of a packet are the slopes of its path", "[unit][boomeron]") {
  Path path;
  for (int i = 0; i < 400; ++i) {
    const double t = path_sampling * i;
    path.t.push_back(t), path.centre.push_back(3 + 0.4 * t - 0.01 * t * t);
  }
  const auto [t, v] = velocities(path, 0, path.t.size(), path_sampling);
  REQUIRE(t.size() > 10);
  for (std::size_t k = 0; k < t.size(); ++k) check_close(v[k], 0.4 - 0.02 * t[k], 1e-12);
}

TEST_CASE("an endless chain is as long as the fastest wave of its stiffest contact goes",
          "[unit][boomeron]") {
  struct Blow {
    double velocity;
    Contact contact;
    double stiffness;
  };
  for (const Blow& b : {Blow{3, Hertz{}, 0.8 * std::pow(3, 0.4)},
                        {0.1, CompressedHertz{0.9}, 1.5 * std::sqrt(0.9)}}) {
    const double speed = (std::sqrt(1 + 4 * b.stiffness) - 1) / 2;
    CHECK(on_long_chain({b.velocity, {7, Harmonic{}, b.contact}, 1e6}).chain.sites ==
          100 + std::size_t(1.15e6 * speed));
  }
}

TEST_CASE("a chain is long enough for what travels in it", "[unit][model]") {
  struct Run {
    Chain like;
    double velocity, time;
  };
  for (const auto& [like, velocity, time] : {Run{{0, Quartic{1}}, 1.9, 200},
                                             {{0, None{}}, 1.9, 200},
                                             {{0, None{}}, 100, 60},
                                             {{0, None{}, CompressedHertz{4}}, 1, 60}}) {
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
  CHECK(strike(EventCorrected{0.05}, impact).path.centre.back() >= 20);
}

TEST_CASE("an impact in two parts is the impact", "[unit][model]") {
  const Impact impact{1.9, {60, Quartic{1}}, 60};
  const ImpactRun whole = strike(EventCorrected{0.1}, impact);
  ImpactRun parts{struck(60, 1.9)};
  follow(EventCorrected{0.1}, impact, parts, 20);
  follow(EventCorrected{0.1}, impact, parts, 60);
  CHECK(whole.end.y == parts.end.y);
  CHECK(whole.density == parts.density);
  CHECK(whole.run.steps == parts.run.steps);
}
