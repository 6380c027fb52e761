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

TEST_CASE("the larger and the smaller of two count their error bars", "[unit][accuracy]") {
  const Estimate wide{1.0, 0.3}, sharp{1.1, 0.05}, narrow{1.0, 0.05}, blurred{1.1, 0.3};
  CHECK((larger(wide, sharp).value == 1.0 && larger(sharp, narrow).value == 1.1));
  CHECK((smaller(narrow, blurred).value == 1.1 && smaller(narrow, sharp).value == 1.0));
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

TEST_CASE("the number of workers is a choice without influence", "[unit][accuracy]") {
  for (std::size_t workers : {1, 3}) {
    set_threads(workers);
    CHECK(threads() == workers);
    std::vector<double> square(200);
    std::vector<std::thread::id> by(200);
    parallel_for("squares", square.size(), [&](std::size_t i) {
      square[i] = double(i) * double(i);
      by[i] = std::this_thread::get_id();
      std::this_thread::sleep_for(std::chrono::microseconds(100));
    });
    for (std::size_t i = 0; i < square.size(); ++i) CHECK(square[i] == double(i * i));
    CHECK((std::set(by.begin(), by.end()).size() > 1) == (workers > 1));
  }
  set_threads(0);
  CHECK(threads() == granted_cores());
}

TEST_CASE("the line of progress says how far it is and how long it takes", "[unit][progress]") {
  ProgressLine line("p run");
  CHECK(line.at(0.9, {}) == "p run 0 s");
  CHECK(line.at(1, {"step 0.05", 0}) == "p run 1 s, step 0.05");
  CHECK(line.at(3.9, {"step 0.05", 0.1}) == "p run 3 s, step 0.05 10 %");  // too soon to tell
  CHECK(line.at(51, {"step 0.05", 0.259}) == "p run 51 s, step 0.05 25 % (about 143 s more)");
  // The pace of the next stage is its own, and so is that of the next one of this name
  CHECK(line.at(101, {"", 0.5}) == "p run 101 s, 50 %");
  CHECK(line.at(111, {"", 0.6}) == "p run 111 s, 60 % (about 40 s more)");
  CHECK(line.at(112, {"", 0.1}) == "p run 112 s, 10 %");
  CHECK(line.at(116, {"", 0.5}) == "p run 116 s, 50 %");  // takes nine seconds
  CHECK(line.at(512, {"", 0.6}) == "p run 512 s, 60 % (about 5 min more)");
  CHECK(line.at(20512, {"", 0.65}) == "p run 20512 s, 65 % (about 3.6 h more)");
  CHECK(number_label("step", 0.2 / 128) == "step 0.0016");
}

TEST_CASE("stages are seen up to the first that counts, and no number depends on them",
          "[unit][progress]") {
  const auto run = [](const Look& look) {
    State<double> state(20);
    state.v[0] = 1;
    evolve(EventCorrected{0.1}, Chain{20, Harmonic{}}, state, 10.0, Every{1.0}, look);
    return state;
  };
  const State<double> unseen = run({});
  std::vector<double> shares;
  const State<double> seen = run([&](const State<double>&) {
    CHECK(Progress::shown().label == "step 0.1");
    shares.push_back(std::floor(100 * Progress::shown().share));
  });
  CHECK(shares == std::vector<double>{0, 0, 10, 20, 30, 40, 50, 60, 70, 80, 90});
  CHECK(unseen.y == seen.y);
  CHECK(unseen.v == seen.v);
  // Those inside of the one that counts are not shown, also if they are other threads'
  const Progress named("named");
  parallel_for("runs", 2, [&](std::size_t) {
    Progress part("part", 1);
    part.reach(0.7);
    CHECK(Progress::shown().label == "named, runs");
    CHECK(Progress::shown().share != 0.7);
  });
  CHECK(Progress::shown().label == "named");
  Progress outer("outer", 4);
  outer.tick();
  CHECK(Progress::shown().share == 0.25);
}
