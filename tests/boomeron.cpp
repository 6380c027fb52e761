// Packets that turn round: what counts as turning, what the chain does, the program.

#include <cmath>
#include <string>

#include "check.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/impact/turning.hpp"
#include "run.hpp"
#include "sec34/decorrelation.hpp"

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
    return Voyage{drawn(600, 0.3, ball), State<double>(1), {}};
  };
  const Voyage a = thrown(200), b = thrown(204);
  const TurnEstimate turn = estimate_turn(a, b);
  check_close(turn.apex_time.value, 204, 0.5);
  CHECK(turn.apex_time.error > 3);
  CHECK(turn.apex_time.error < 10);
  CHECK(SameTurn{}(a, a) == 0);
  CHECK(SameTurn{}(a, b) > 0.005);
  Voyage steady = a;
  steady.path = drawn(600, 0.3, [](double t) { return 1 + 0.1 * t; });
  CHECK(std::isinf(SameTurn{}(a, steady)));
}

TEST_CASE("hard wells turn the packet, linear and soft ones do not", "[property][boomeron]") {
  CHECK(probe(2, 1, 40, 0).fate == Fate::turns);
  CHECK(probe(2, 0, 40, 0).fate == Fate::escapes);
  CHECK(probe(2, 0.005, 40, 0).fate == Fate::escapes);
  CHECK(probe(0.5, 1, 30, 0).fate == Fate::escapes);
  CHECK(probe(3, 20, 30, 0).fate == Fate::stays);
}

TEST_CASE("at small amplitude only s v0^(3/2) counts", "[property][boomeron]") {
  const auto apex = [](double velocity, double kappa) {
    return probe(velocity, kappa / (velocity * std::sqrt(velocity)), 40, 0).apex;
  };
  const double small = apex(0.002, 1.3), smaller = apex(0.001, 1.3);
  check_close(small, smaller, 0, 0.1);
  CHECK(std::abs(apex(0.2, 1.3) - small) > 0.3 * small);
}

TEST_CASE("the apex converges with the step", "[convergence][boomeron]") {
  double apex[3];
  for (int k : {0, 1, 2}) apex[k] = voyage({0.2 / (1 << k)}, {1.95, 1, 700}).turn().apex.site;
  CHECK(std::abs(apex[2] - apex[1]) < std::abs(apex[1] - apex[0]) / 4);
  CHECK(std::abs(apex[2] - apex[1]) < 1e-3);
}

TEST_CASE("runs part the later the less they differ", "[unit][boomeron]") {
  const Chain chain{60, Quartic{1}};
  const ContactAware stepper{0.1};
  const auto time = [&](double delta) {
    return decorrelation_time(stepper, struck(60, 1.9), stepper, struck(60, 1.9 * (1 + delta)),
                              chain, 300);
  };
  CHECK(std::isinf(time(0)));
  CHECK(time(1) == 0);
  CHECK(time(3e-2) < time(3e-3));
  CHECK(time(3e-3) < 300);
  const Estimate when = decorrelation_of(100, 104);
  CHECK(when.value == 104);
  CHECK(when.error >= 4 + comparison_interval);
  CHECK(std::isnan(decorrelation_of(100, time(0)).value));
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
  const double sites = double(endless({0.1, chain, time}).chain.sites);
  CHECK(sites > fastest * time);
  CHECK(sites < 2 * fastest * time);
}
