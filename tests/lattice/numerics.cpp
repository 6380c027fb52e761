// Numbers with errors, fits of lines, workers, and what is shown of a computation while it runs.

#include <chrono>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "lattice/integrators/refinement.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "lattice/numerics/parallel.hpp"
#include "report/heartbeat.hpp"
#include "support/check.hpp"

using namespace lattice;
using namespace report;

namespace {

double hands = 0;
double hand_set() {
  return hands;
}

}  // namespace

TEST_CASE("estimates are never without an error unless they are exact", "[unit][accuracy]") {
  CHECK(with_error(1.0, 1.0).error > 0);
  CHECK(with_error(0.0, 0.0).error > 0);
  CHECK(with_error(2.0, 1.5).error == 0.5);
  CHECK_FALSE(with_error(1.0, 1.0).is_exact);
  CHECK(std::isnan(with_error(std::nan(""), 1.0).error));
  CHECK(exact(3).is_exact);
  CHECK(with_error(3, 3).is_exact);
  CHECK_FALSE(with_error(3, 4).is_exact);
  CHECK(with_error(3, 4).error == 1);
  check_close(with_error(Estimate{1, 0.1}, Estimate{1.5, 0.2}).error, 0.7, 1e-15);
  // Nor can one be written: a double is known to its last digit
  for (double x : {3.0, -1e-30, 0.0}) CHECK(Estimate{x, 0}.error >= 1e-16 * std::abs(x));
  CHECK(Estimate{0, 0}.error > 0);
  CHECK(Estimate{1, 1e-30}.error > 1e-16);
  CHECK(Estimate{1, 0.5}.error == 0.5);
  CHECK(std::isnan(Estimate{1, std::nan("")}.error));
  CHECK((exact(3).error == 0 && quotient(exact(3), exact(4)).is_exact));
}

TEST_CASE("two resolutions that agree by chance have the error of the step before",
          "[unit][accuracy]") {
  const Estimate before = with_error(1.0, 1.064), last = with_error(1.064, 1.064 + 1e-9);
  check_close(after_halving(before, last).error, 0.001, 1e-9);
  CHECK(after_halving(before, last, 2).error > 0.03);
  CHECK(after_halving(last, before).error == before.error);
  CHECK(after_halving(before, exact(2)).is_exact);
  CHECK(after_halving({1, std::nan("")}, last).error == last.error);
}

TEST_CASE("a curve that is no line is found out although its fit is good", "[unit][accuracy]") {
  std::vector<double> t, steady, slowing;
  for (int k = 0; k < 1000; ++k) {
    t.push_back(k);
    steady.push_back(0.3 * k + 0.1 * std::sin(k));
    slowing.push_back(0.3 * k - 2e-5 * k * k);
  }
  const Line fit = fit_line(t, slowing);
  CHECK(fit.slope_error < 0.002 * fit.slope);      // the standard error sees nothing,
  CHECK(std::abs(bend(t, slowing).value) > 0.05);  // the halves do
  CHECK(std::abs(bend(t, steady).value) < 1e-3);
}

TEST_CASE("the vertex of a parabola through three samples, by hand", "[unit][formulas]") {
  // 3 - 2 (x - 1/4)^2 at -1, 0 and 1
  const Parabola top(-0.125, 2.875, 1.875);
  check_close(top.slope, 1, 1e-15);
  check_close(top.bend, -4, 1e-15);
  check_close(top.vertex(), 0.25, 1e-15);
  check_close(top.extremum(), 3, 1e-15);
}

TEST_CASE("the number of workers is a choice without influence", "[unit][accuracy]") {
  const auto workers = [] {
    std::vector<double> square(200);
    std::vector<std::thread::id> by(200);
    parallel_for("squares", square.size(), [&](std::size_t i) {
      square[i] = double(i) * double(i);
      by[i] = std::this_thread::get_id();
      std::this_thread::sleep_for(std::chrono::microseconds(100));
    });
    for (std::size_t i = 0; i < square.size(); ++i) CHECK(square[i] == double(i * i));
    return std::set(by.begin(), by.end()).size();
  };
  CHECK(granted_cores() >= 1);
  CHECK(threads() == granted_cores());
  set_threads(1);
  CHECK(workers() == 1);
  set_threads(3);
  CHECK(threads() == 3);
  CHECK(workers() > 1);
  set_threads(0);
}

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
    evolve(EventCorrected{0.1}, Chain{20, Harmonic{}}, state, 10.0, Every{1.0}, look);
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
