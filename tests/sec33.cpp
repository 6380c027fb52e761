// Kicks, the breather that drifts, and what linear theory says of both; exchanges of stability.

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "commands/exchanges.hpp"
#include "sec3/exchange.hpp"
#include "sec3/kick_threshold.hpp"
#include "support/check.hpp"

using namespace lattice;
using namespace report;

namespace {

RestingBreather breather(Centre centre, double omega, Phase phase = Phase::compressed) {
  return resting_breather(centre, phase, omega, 22);
}

/// The path after a kick, up to its decision.
KickedPath kicked_path(const RestingBreather& at, double c, double time, double step = 0.1) {
  return at.after(c, EventCorrected{step}, time,
                  [](const KickedPath& path, const State<double>&, const auto&) {
                    return mobility_of(path) == Mobility::undecided;
                  });
}

/// A path through given places, at given times or all at one.
KickedPath path_of(const std::vector<double>& X, std::vector<double> t = {}) {
  KickedPath path;
  t.resize(X.size());
  for (std::size_t k = 0; k < X.size(); ++k) path.add(t[k], X[k]);
  return path;
}

}  // namespace

TEST_CASE("the mean of a place that swings with the breather is its middle", "[unit][kick]") {
  const RestingBreather at = breather(Centre::bond, 1.1);
  const double apart = sample_of_mean(at.period);
  check_close(samples_of_a_mean * apart, 11 * at.period, 0, 1e-4);
  const KickedPath path =
      follow_kicked(EventCorrected{0.1}, at.chain, at.rest, apart, 23 * at.period);
  REQUIRE(path.size() == 2);
  check_close(path[0].centre, path[1].centre, 1e-4);
  check_close(path[0].t, 45 * apart, 0, 1e-12);
  check_close(path[1].t, (45 + 89) * apart, 0, 1e-12);
}

TEST_CASE("free and pinned are told from the path", "[unit][kick]") {
  CHECK(mobility_of(path_of({0.1, 0.2, 0.4})) == Mobility::undecided);
  CHECK(mobility_of(path_of({0.1, 0.4, 0.35})) == Mobility::pinned);
  CHECK(mobility_of(path_of({0.1, 0.4, 0.69})) == Mobility::undecided);  // 0.59 from its start
  CHECK(mobility_of(path_of({0.1, 0.4, 0.72})) == Mobility::free);
  CHECK(mobility_of(path_of({0.1, -0.4, -0.72})) == Mobility::free);
  CHECK(mobility_of(path_of({})) == Mobility::undecided);
}

TEST_CASE("a breather that is not kicked stays, and opposite kicks are mirror images",
          "[property][kick]") {
  const RestingBreather at = breather(Centre::bond, 1.1);
  const KickedPath rest = kicked_path(at, 0, 1000), right = kicked_path(at, 1e-4, 1000),
                   left = kicked_path(at, -1e-4, 1000);
  CHECK(std::abs(right.travelled()) > 0.2);
  CHECK(std::abs(rest.travelled()) < 1e-5 * std::abs(right.travelled()));
  check_close(right.travelled(), -left.travelled(), 2e-3);
  CHECK(right.travelled() < 0);  // against the kick: the mass is negative
}

TEST_CASE("hill and trough have opposite curvatures of one size", "[property][kick]") {
  const Pinning hill = pinning_of(breather(Centre::site, 1.1)),
                trough = pinning_of(breather(Centre::bond, 1.1)),
                later = pinning_of(breather(Centre::bond, 1.1, Phase::stretched));
  CHECK(trough.frequency2 > 0);
  check_close(trough.frequency2, -hill.frequency2, 0, 1e-4);
  check_close(trough.frequency2, later.frequency2, 0, 1e-5);  // both phases belong to one orbit
  // By the integrator of tests/second
  check_close(trough.phi, -0.02521309492, 0, 1e-6);
  check_close(later.phi, -0.02374023066, 0, 1e-6);
}

TEST_CASE("a breather swings at the frequency of linear theory", "[published][kick]") {
  const RestingBreather at = breather(Centre::bond, 1.1);
  const double omega = std::sqrt(pinning_of(at).frequency2);
  const KickedPath path = kicked_path(at, 2e-6, 8 / omega, 0.3);
  REQUIRE(mobility_of(path) == Mobility::pinned);
  std::size_t top = 0;
  for (std::size_t k = 0; k < path.size(); ++k)
    if (std::abs(path.moved(k)) > std::abs(path.moved(top))) top = k;
  // A quarter of a period, a little longer than that of small swings.
  check_close(path[top].t * omega, 1.571, 0.2);
}

TEST_CASE("the speed on the hill is that of the slowest place", "[unit][kick]") {
  const double V = 2e-6, Omega = 4e-5;
  KickedPath path;
  for (int k = 0; k < 2000; ++k) {
    const double t = 60 * k;
    if (k == 0 || t > 3e4)
      path.add(t, k == 0 ? 0.3 : 0.3 - (0.5 + V / Omega * std::sinh(Omega * (t - 7.1e4))));
    if (path.travelled() < -0.7) break;
  }
  check_close(hill_speed(path), V, 0, 2e-3);
  CHECK_THROWS_AS(hill_speed(path_of({0, 0.3, 0.9})), std::invalid_argument);
}

TEST_CASE("the mean speed of a pendulum", "[unit][kick]") {
  const double omega = 3e-5, change = omega / M_PI;
  CHECK(pendulum_speed(0.99 * change, omega, false) == 0);
  // Fast: less by a quarter of the square of the change over the speed; the two starts are one motion
  check_close(pendulum_speed(20 * change, omega, false), change * (20 - 1 / 80.0), 0, 1e-6);
  check_close(pendulum_speed(change, omega, true),
              pendulum_speed(std::sqrt(2) * change, omega, false), 0, 1e-12);
}

TEST_CASE("three free breathers know the kick that frees", "[property][kick]") {
  const RestingBreather at = breather(Centre::bond, 1.1, Phase::stretched);
  const Prediction p = predict_threshold(at, {-2.3522916e-13, 1e-17});
  check_close(p.threshold.value, 4.4516e-6, 0, 1e-4);
  const Estimate c = depinning(at, p.threshold.value, EventCorrected{0.3}, 3e5).threshold;
  CHECK(c.error < 1e-3 * c.value);
  check_close(c.value, p.threshold.value, 0, 1e-3);
  CHECK_FALSE(predict_threshold(breather(Centre::site, 1.1), p.barrier).exists());
  // Along the mode all of the kick is in the slow plane, so less is needed: c_c is shorter by the cosine
  const RestingBreather mode = along_pinning_mode(at);
  const double cosine = std::inner_product(mode.g.begin(), mode.g.end(), at.g.begin(), 0.0);
  check_close(predict_threshold(mode, p.barrier).threshold.value, cosine * p.threshold.value, 0,
              1e-9);
  CHECK(reversed(at).g[3] == -at.g[3]);
}

TEST_CASE("a kick and the path after it by hand", "[unit][kick]") {
  CHECK_THROWS_AS(kick_direction(std::vector<double>(5, 0.0)), std::invalid_argument);
  const auto g = kick_direction({1, 4, 2, -3});
  const double norm = std::sqrt(16. + 1 + 49 + 4);
  for (const auto& [n, x] :
       std::vector<std::pair<std::size_t, double>>{{0, 4}, {1, 1}, {2, -7}, {3, -2}})
    check_close(g[n], x / norm, 1e-14);
  State<double> state(4);
  state.y = {1, 4, 2, -3}, state.v = {1, 1, 1, 1};
  check_close(kicked(state, -2).v[2], 1 + 14 / norm, 1e-14);
  CHECK(kicked(state, -2).y == state.y);
  check_close(sample_of_mean(3), 3 * 0.1236067977499789696, 1e-14);
  check_close(breather_place({0, 1, 5, 2}), (2 + 15 + 8) / 8.0 - 2.5, 1e-14);
  CHECK(KickedPath{}.share == 1);
  CHECK(KickedPath{}.travelled() == 0);

  KickedPath path = path_of({3, 3.5, 2, 1.2, 1.6}, {0, 1, 2, 4, 5});
  check_close(path.farthest(), 1.8, 1e-14);
  check_close(path.travelled(), -1.4, 1e-14);
  check_close(path.speed_during(1, 4).value,
              ((1 - 7 / 3.0) * 3.5 + (2 - 7 / 3.0) * 2 + (4 - 7 / 3.0) * 1.2) / (14 / 3.0), 1e-13);
  check_close(path.mean_speed(1.4), 1.4 / (2 + 2 * 0.4 / 0.8), 1e-14);
  check_close(path.mean_speed(0.5), 0.5 / 1, 1e-14);
  check_close(path.mean_speed(2, 1), 2 / (2 + 2 * 0.5 / 0.8 - 1), 1e-14);
  CHECK_THROWS_AS(path.mean_speed(1.81), std::runtime_error);
  path.run.energy_drift = 1e-8;
  check_close(path.drift_margin(3, 5), 9 / 10.0 / 1e-8, 0, 1e-13);
}

TEST_CASE("an exchange is found between two frequencies and nowhere else", "[property][floquet]") {
  const Cut cut{false, 0};
  const Orbit<double> near = find_breather(problem_at(Centre::site, {1.07, 0}));
  const Exchange found = exchange<double>(Centre::site, cut, 1.07, 1.08, near);
  check_close(found.place.value, 1.07503529, 5e-8 + found.place.error);
  CHECK(found.place.error < 1e-6);
  CHECK_THROWS_AS(exchange<double>(Centre::site, cut, 1.08, 1.09, near), NoBranch);
}

TEST_CASE("exchanges near the end of a family are found one by one", "[property][floquet]") {
  // Near the fold kappa turns within a step of the search, and would be seen with one sign at its ends
  const InWells all = exchanges_in_wells(Centre::bond, 2);
  CHECK(all.places.size() == 8);
  for (const auto& [low, high] : {std::pair{-0.094, -0.091}, {-0.091, -0.085}})
    CHECK(std::count_if(all.places.begin(), all.places.end(),
                        [&, low = low, high = high](const Estimate& e) {
                          return e.value - e.error > low && e.value + e.error < high;
                        }) == 1);
  // By a program of its own, in 113 bits
  const Orbit<double> near = find_breather(problem_at(Centre::site, {1.9, -0.165, 10}));
  const Estimate place = exchange<Wide>(Centre::site, {true, 1.9, 10}, -0.167, -0.1674, near).place;
  check_close(place.value, -0.1672073123952, 3 * place.error + 1e-13);
  CHECK(place.error < 1e-9);
}

TEST_CASE("two exchanges between neighbouring wells are found", "[property][exchange]") {
  const double omega_b = 1.3265;
  const auto kappa = [&](double s) {
    Orbit<double> orbit = find_breather(problem_at(Centre::site, {omega_b, 0}));
    return quick_kappa(Centre::site, {omega_b, s}, orbit);
  };
  const auto found = exchanges_in_wells(Centre::site, omega_b);
  CHECK((found.from == -1 && found.to == 1));
  REQUIRE(found.places.size() == 2);
  CHECK(kappa(0) * kappa(0.05) > 0);  // at the neighbours nothing is seen
  for (const Estimate& e : found.places) {
    CHECK((e.value > 0 && e.value < 0.05));
    CHECK(kappa(e.value - 1e-5) * kappa(e.value + 1e-5) < 0);
  }
  // Whichever end of the bracket comes first; kappa, in extended precision, vanishes there
  const Orbit<double> linear = find_breather(problem_at(Centre::site, {1.5, 0}));
  for (const auto& [low, high] : {std::pair{-0.25, -0.2}, {-0.2, -0.25}}) {
    const Estimate place = exchange<double>(Centre::site, {true, 1.5}, low, high, linear).place;
    check_close(place.value, -0.202052324796, 3 * place.error);
    CHECK(place.error < 1e-6);
  }
}
