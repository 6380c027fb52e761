// What is shown of a computation while it runs: the line, the time that it still takes, and who is inside of what.

#include "report/heartbeat.hpp"

#include <atomic>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

#include "check.hpp"
#include "lattice/numerics/parallel.hpp"
#include "lattice/integrators/accuracy.hpp"

using namespace lattice;

namespace {

double hands = 0;
double hand_set() {
  return hands;
}

}  // namespace

TEST_CASE("the line of progress says how far it is and how long it takes", "[unit][progress]") {
  CHECK(progress_line("p run", 71.9, {}) == "p run 71 s");
  CHECK(progress_line("p run", 71, {{"step 0.05", 0.349, 1, 140.4}}) ==
        "p run 71 s, step 0.05: 34 % (about 140 s more)");
  CHECK(progress_line("p", 5, {{"kicks", 3, 12}}) == "p 5 s, kicks 3/12");
  CHECK(progress_line("p", 5, {{"", 0.5, 1}}) == "p 5 s, 50 %");
  // What does not count introduces what does, and of three counts two are shown
  CHECK(progress_line("p", 9,
                      {{"wells", 3, 12, 7260}, {"Newton step 2"}, {"", 0.5, 1}, {"x", 1, 2}}) ==
        "p 9 s, wells 3/12 (about 120 min more), Newton step 2: 50 %");
  CHECK(progress_line("p", 9, {{"eigenvalues"}}) == "p 9 s, eigenvalues");
  CHECK(number_label("step", 0.2 / 128) == "step 0.0016");
}

TEST_CASE("times left are told to two digits", "[unit][progress]") {
  const auto told = [](double seconds) {
    const std::string line = progress_line("p", 1, {{"n", 1, 2, seconds}});
    return line.substr(line.find('(') + 7, line.find(" more") - line.find('(') - 7);
  };
  CHECK(told(0.2) == "1 s");
  CHECK(told(7.4) == "7 s");
  CHECK(told(47.4) == "47 s");
  CHECK(told(144) == "140 s");
  CHECK(told(1000) == "17 min");
  CHECK(told(16000) == "4.4 h");
  CHECK(told(1e6) == "280 h");
}

TEST_CASE("the time left follows the pace", "[unit][progress]") {
  const auto left = [](auto share, double now) {
    Forecast forecast;
    for (double t = 1; t <= now; ++t) forecast.see(t, share(t));
    return forecast.left(now);
  };
  CHECK(left([](double) { return 0; }, 9) == std::nullopt);
  // A constant pace, counted finely or in twelve parts, and one that falls as more and more beads move
  check_close(*left([](double t) { return t / 200; }, 50), 150, 1e-9);
  check_close(*left([](double t) { return std::floor(t / 10) / 12; }, 45), 75, 1e-9);
  check_close(*left([](double t) { return std::sqrt(t / 200); }, 50), 150, 1e-9);
  // A stage that hardly moves on for a while may take long, but not without end
  check_close(*left([](double t) { return std::min(t, 10.0) / 20 + t / 1e4; }, 20),
              20 * (std::pow(0.502, -2) - 1), 1e-9);
  // Nothing is said of a part that takes longer than was to be expected
  CHECK(left([](double t) { return t < 10 ? 0 : 0.5; }, 19));
  CHECK(left([](double t) { return t < 10 ? 0 : 0.5; }, 21) == std::nullopt);
}

TEST_CASE("stages are seen from the outermost on, and only if somebody watches",
          "[unit][progress]") {
  CHECK(Progress::here() == nullptr);
  {
    Progress unseen("unseen", 2);
    unseen.tick();
    CHECK(Progress::here() == nullptr);
  }
  const Watch watch(hand_set);
  CHECK(watch.stages().empty());
  const auto line = [&] { return progress_line("p", 0, watch.stages()); };
  Progress outer("outer", 4);
  outer.tick();
  {
    const Progress named("named");
    Progress inner("", 1);
    inner.reach(0.25);
    CHECK(line() == "p 0 s, outer 1/4");
    ++hands;
    CHECK(line() == "p 0 s, outer 1/4, named: 25 %");
  }
  CHECK(line() == "p 0 s, outer 1/4");
}

TEST_CASE("the time left is told of what takes long", "[unit][progress]") {
  const Watch watch(hand_set);
  const auto told = [&](double pace) {
    hands = 100;
    Progress run("run", 1);
    std::string all;
    for (double t = 1; t <= 4; ++t) {
      hands = 100 + t;
      run.reach(pace * t);
      all += watch.stages()[0].left ? "yes " : "no ";
    }
    return all;
  };
  CHECK(told(0.01) == "no no yes yes ");
  CHECK(told(0.1) == "no no no no ");
}

TEST_CASE("of workers the stage around them is shown, or else the slowest", "[unit][progress]") {
  const Watch watch(hand_set);
  const auto line = [&] { return progress_line("p", 0, watch.stages()); };
  set_threads(2);
  std::atomic<int> inside{0};
  std::string seen[2];
  const auto meet = [&](int people) {
    ++inside;
    while (inside < people) std::this_thread::yield();
  };
  const auto work = [&](std::size_t i, std::string& out) {
    Progress part(i ? "second" : "first", 1);
    part.reach(i ? 0.25 : 0.75);
    meet(2);
    if (i == 0) out = line();
    meet(4);
  };
  parallel_for("runs", 2, [&](std::size_t i) { work(i, seen[0]); });
  inside = 0;
  parallel_for(2, [&](std::size_t i) { work(i, seen[1]); });
  set_threads(0);
  CHECK(seen[0] == "p 0 s, runs 0/2");
  CHECK(seen[1] == "p 0 s, second: 25 %");
  CHECK(watch.stages().empty());
}

TEST_CASE("a run says how far it is, and no number depends on it", "[unit][progress]") {
  const auto run = [](auto look) {
    State<double> state(20);
    state.v[0] = 1;
    evolve(ContactAware{0.1}, Chain{20, Harmonic{}}, state, 10.0, 1.0, look);
    return state;
  };
  const State<double> unseen = run(Unobserved{});
  const Watch watch(hand_set);
  std::vector<std::string> lines;
  const State<double> seen =
      run([&](const State<double>&) { lines.push_back(progress_line("p", 0, watch.stages())); });
  REQUIRE(lines.size() == 11);
  CHECK(lines[1] == "p 0 s, step 0.1: 0 %");
  CHECK(lines[10] == "p 0 s, step 0.1: 90 %");
  CHECK(unseen.y == seen.y);
  CHECK(unseen.v == seen.v);
}
