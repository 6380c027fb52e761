// What is shown of a computation while it runs: the line, and the time that it still takes.

#include "report/heartbeat.hpp"

#include <string>
#include <vector>

#include "lattice/integrators/refinement.hpp"
#include "lattice/numerics/parallel.hpp"
#include "support/check.hpp"

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
  CHECK(progress_line("p", 9, {{"Newton step 2"}, {"wells", 3, 12, 7260}}) ==
        "p 9 s, Newton step 2: wells 3/12 (about 120 min more)");
  CHECK(progress_line("p", 9, {{"eigenvalues"}}) == "p 9 s, eigenvalues");
  CHECK(progress_line("p", 1, {{"n", 1, 2, 16000}}) == "p 1 s, n 1/2 (about 4.4 h more)");
  CHECK(number_label("step", 0.2 / 128) == "step 0.0016");
}

TEST_CASE("stages are seen up to the first that counts, and only if somebody watches",
          "[unit][progress]") {
  Progress unseen("unseen", 2);
  unseen.tick();
  const Watch watch(hand_set);
  CHECK(watch.stages().empty());
  const auto line = [&] { return progress_line("p", 0, watch.stages()); };
  const Progress named("named");
  Progress outer("outer", 4);
  outer.tick();
  CHECK(line() == "p 0 s, named");
  ++hands;
  const Progress inner("inner", 1);
  CHECK(line() == "p 0 s, named: outer 1/4");
}

TEST_CASE("the time left follows the pace, and is told of what takes long", "[unit][progress]") {
  const Watch watch(hand_set);
  const auto left = [&](double share, double seconds) {
    hands = 100;
    Progress run("run", 1);
    run.reach(share);
    hands += seconds;
    return watch.stages()[0].left;
  };
  CHECK(*left(0.25, 50) == 150);
  CHECK(left(0, 50) == std::nullopt);
  CHECK(left(0.01, 2) == std::nullopt);
  CHECK(left(0.5, 5) == std::nullopt);
}

TEST_CASE("of workers the stage around them is shown", "[unit][progress]") {
  const Watch watch(hand_set);
  std::vector<std::string> seen(2);
  parallel_for("runs", 2, [&](std::size_t i) {
    const Progress part("part", 1);
    seen[i] = watch.stages()[0].label;
  });
  CHECK(seen == std::vector<std::string>{"runs", "runs"});
  CHECK(watch.stages().empty());
}

TEST_CASE("a run says how far it is, and no number depends on it", "[unit][progress]") {
  const auto run = [](const Look& look) {
    State<double> state(20);
    state.v[0] = 1;
    evolve(EventCorrected{0.1}, Chain{20, Harmonic{}}, state, 10.0, 1.0, look);
    return state;
  };
  const State<double> unseen = run({});
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
