// Refinement: two resolutions are two runs, what must agree is named, and errors are not omitted.

#include "lattice/integrators/refinement.hpp"

#include <chrono>
#include <filesystem>
#include <mutex>
#include <set>
#include <thread>
#include <tuple>
#include <utility>

#include "lattice/impact/impact.hpp"
#include "lattice/model/potential_names.hpp"
#include "lattice/numerics/parallel.hpp"
#include "report/table.hpp"
#include "support/check.hpp"
#include "support/run.hpp"

using namespace lattice;

namespace {

/// What must agree, the relative difference of a number that is read from each result.
template <class Of>
struct Reading {
  std::string name;
  Of of;

  template <class Result>
  double operator()(const Result& coarse, const Result& fine) const {
    const double a = of(coarse), b = of(fine);
    return a == b ? 0 : std::abs(a - b) / std::max(std::abs(a), std::abs(b));
  }
};
template <class Of>
Reading<Of> reading(std::string name, Of of) {
  return {std::move(name), std::move(of)};
}

const Chain hard{40, Quartic{1}};

/// A result for `refined`: the struck chain after ten units of time, seen every `sample`.
struct Struck {
  State<double> end;
  Run run;
};

Struck after_impact(const EventCorrected& method, double sample) {
  Struck out{struck(hard.sites, 1.9), {}};
  out.run = evolve(method, hard, out.end, 10, sample);
  return out;
}

/// What is said of a run; nothing if it comes to its time.
std::string evolved(const Chain& chain, State<double> state, double time, double sample,
                    double tolerance = 1e-6) {
  const auto said = refusal([&] { evolve(Converged{tolerance}, chain, state, time, sample); });
  return said.empty() && state.t != time ? "a silent short run" : said;
}

/// A harmonic well until it is told otherwise: its force may become nan, or wrong by a cubic term.
struct Changing {
  const bool* nothing;
  const double* wrong;
  double energy(double y) const { return y * y / 2; }
  double force(double y) const { return *nothing ? std::nan("") : -y - *wrong * y * y * y; }
  double stiffness(double) const { return 1; }
};

}  // namespace

TEST_CASE("a halved step halves, whatever the samples", "[unit][accuracy]") {
  for (double sample : {0.03, 0.07, 0.1, 0.2, 0.25, 0.3, 1.0, 10.0}) {
    CAPTURE(sample);
    const TimeGrid first = time_grid(EventCorrected{0.2}, 10, sample);
    CHECK(first.step() <= 0.2 * (1 + 1e-12));
    CHECK(first.interval() <= sample * (1 + 1e-12));
    for (int k = 1; k <= 5; ++k) {
      const EventCorrected finer = method_for(1e-6, 0.2, k);
      const TimeGrid same = time_grid(finer, 10, sample),
                     dense = time_grid(finer, 10, denser(sample));
      CHECK(same.samples == first.samples);
      CHECK(same.steps == first.steps << k);
      CHECK(dense.samples == first.samples << k);
      CHECK(dense.steps == first.steps);
      CHECK(same.step() == std::ldexp(first.step(), -k));
      check_close(dense.step(), same.step(), 0, 1e-15);
    }
  }
}

TEST_CASE("samples shorter than the step still give two different runs",
          "[convergence][accuracy]") {
  const auto exact = after_impact(EventCorrected{1. / 1024}, 0.1);
  for (double sample : {0.05, 0.1, 0.25}) {
    const auto pair =
        refined(1e-6, [&](const EventCorrected& s) { return after_impact(s, sample); });
    CAPTURE(sample, pair.history);
    CHECK(pair.fine.run.steps == 2 * pair.coarse.run.steps);
    CHECK(pair.error > 0);
    CHECK(distance(pair.fine.end, exact.end) <= pair.error);
  }
}

TEST_CASE("two identical runs are refused as a proof of agreement", "[unit][accuracy]") {
  const auto deaf = [](const EventCorrected&) { return after_impact(EventCorrected{0.2}, 0.1); };
  CHECK_THROWS_AS(refined(1e-6, deaf), std::logic_error);
  CHECK_THROWS_AS(
      refined(1e-6, deaf, reading("energies", [](const Struck& s) { return energy(hard, s.end); })),
      std::logic_error);
  // A chain at rest has the same bits at every step, and that is no mistake.
  const auto rest = [](const EventCorrected& method) {
    Struck out{State<double>(5), {}};
    out.run = evolve(method, Chain{5, Quartic{1}}, out.end, 10, 1);
    return out;
  };
  CHECK(refined(1e-6, rest).error == 0);
}

TEST_CASE("what must agree is named, and named again where it does not", "[unit][accuracy]") {
  const auto share = reading("shares of the first bead", [](const Struck& s) {
    const auto e = energy_density(hard, s.end);
    return e[0] / total(e);
  });
  const auto compute = [](const EventCorrected& s) { return after_impact(s, 1); };
  const auto loose = refined(1e-2, compute, share), tight = refined(1e-7, compute, share);
  CHECK(tight.error <= 1e-7);
  CHECK(tight.method.halvings > loose.method.halvings);
  const auto message = refusal<RefinementFailed>([&] { refined(0, compute, share); });
  CHECK(message.find("shares of the first bead") != std::string::npos);
  CHECK(message.find("step 0.1:") != std::string::npos);
}

TEST_CASE("a refinement gives up when halvings cannot help any more", "[unit][accuracy]") {
  // Two halvings are left after five, and divide by 64 twice
  CHECK(hopeless(1, 1e-4, 5));
  CHECK(hopeless(4097e-4, 1e-4, 5));
  CHECK_FALSE(hopeless(4095e-4, 1e-4, 5));
  CHECK_FALSE(hopeless(1, 1e-4, 4));
  CHECK_FALSE(hopeless(1e-5, 1e-4, 5));
  // The first errors and infinite ones do not tell
  CHECK_FALSE(hopeless(1, 1e-30, 2));
  CHECK(hopeless(1, 1e-30, 3));
  for (double strange : {std::nan(""), double(INFINITY)}) CHECK_FALSE(hopeless(strange, 1e-4, 5));

  // What never agrees is run six times
  struct Outcome {
    double x;
    Run run{};
  };
  int runs = 0;
  const auto erratic = [&](const EventCorrected&) { return Outcome{++runs % 2 ? 1.0 : 2.0}; };
  const auto number = reading("numbers", [](const Outcome& out) { return out.x; });
  const auto message = refusal<RefinementFailed>([&] { refined(1e-4, erratic, number); });
  CHECK(runs == 6);
  CHECK(message.find("differ by more than the tolerance (step 0.1: 0.5, ") != std::string::npos);
  CHECK(message.find("a larger tolerance") != std::string::npos);
}

TEST_CASE("a run of no duration returns its start", "[unit][accuracy]") {
  auto s = struck(10, 1);
  const auto start = s;
  int shown = 0;
  const Run run = evolve(Converged{1e-9}, Chain{10, Quartic{1}}, s, 0, 1,
                         [&](const State<double>&) { ++shown; });
  CHECK(shown == 1);
  CHECK(run.steps == 0);
  CHECK(s.y == start.y);
  CHECK(s.v == start.v);
  CHECK(s.t == 0);
  for (double bad : {-1.0, std::nan(""), double(INFINITY)}) {
    CHECK_THROWS_AS(time_grid(bad, 1, 1), std::invalid_argument);
    if (!(bad > 0) || std::isnan(bad)) {
      CHECK_THROWS_AS(time_grid(1, bad, 1), std::invalid_argument);
      CHECK_THROWS_AS(time_grid(1, 1, bad), std::invalid_argument);
    }
  }
  CHECK_THROWS_AS(time_grid(1, 0, 1), std::invalid_argument);
}

TEST_CASE("a run in which a bead runs away says when, whatever the samples are",
          "[unit][accuracy]") {
  const Chain soft{60, Quartic{-1.0 / 6}};
  for (double sample : {0.2, 10.0, 100.0})
    for (double tolerance : {1e-4, 1e-9}) {
      CAPTURE(sample, tolerance);
      const auto [near, further, held] =
          std::tuple{evolved(soft, struck(60, 2.12), 100, sample, tolerance),
                     evolved(soft, struck(60, 2.125), 100, sample, tolerance),
                     evolved(soft, struck(60, 2.13), 100, sample, tolerance)};
      check_line(near, "a bead runs away at t = 44.48, having left its well at t = 41.5");
      check_line(further, "a bead runs away at t = 44.84");
      CHECK(held == "");
    }
  // A strong blow sends the bead away within the first steps
  check_line(evolved(soft, struck(60, 100), 100, 1), "a bead runs away at t = 0.351");
  CHECK_THROWS_AS(
      refined(1e-4,
              [&](const EventCorrected& method) {
                return strike(method, on_long_chain({2.12, {.well = Quartic{-1.0 / 6}}, 100}));
              }),
      RanAway);
}

TEST_CASE("a start that is not finite, or absurd, is refused", "[unit][accuracy]") {
  const double nan = std::nan(""), inf = INFINITY;
  const Chain chain{20, Quartic{1}};
  for (double bad : {nan, inf, -inf, 1e20, -1e20}) {
    State<double> off = struck(20, 1), fast = off;
    off.y[2] = fast.v[4] = bad;
    check_line(evolved(chain, off, 10, 1), "bead 3 starts with the displacement ");
    check_line(evolved(chain, fast, 10, 1), "bead 5 starts with the velocity ");
  }
  for (double bad : {nan, inf, -1.0}) {
    check_line(evolved(chain, struck(20, 1), bad, 1), "a run of duration ");
    check_line(evolved(chain, struck(20, 1), 10, bad), "with samples ");
    check_line(evolved(chain, struck(20, 1), 10, 1, bad), "tolerance = ");
  }
  check_line(evolved(chain, struck(20, 1), 10, 1e-300), "at most 1e+12 steps");
}

TEST_CASE("runs that end early prove nothing by their end", "[unit][accuracy]") {
  Run whole, broken, left;
  broken.escape_time = 0.2;
  left.escape_time = 44.5, left.t_end = 44.25, left.leave_time = 41;
  CHECK(broken.broken());
  CHECK_FALSE(left.broken());
  const auto apart = [](const Run& a, const Run& b) {
    Attempts two(1, "ends");
    two.enter(a);
    CHECK_FALSE(two.agree(a, b, [] { return 0.0; }));
    return two.error;
  };
  for (const auto& [a, b] : {std::pair(broken, broken), {broken, left}, {left, whole}})
    CHECK(std::isinf(apart(a, b)));
  Attempts gone(1e-6, "ends");
  gone.enter(left);
  CHECK_FALSE(gone.agree(left, left, [] { return 0.0; }));
  check_close(gone.error, 0.25 / 44.5, 0, 1e-15);
  State<double> a(3), b(3);
  CHECK(distance(a, b) == 0);
  a.v[1] = std::nan("");
  CHECK(std::isinf(distance(a, b)));
  CHECK(std::isinf(distance(a, a)));
}

TEST_CASE("a step that is too long is halved until a run holds", "[convergence][accuracy]") {
  // Stiff wells after a strong blow, and a light bead
  Chain stiff{8, Quartic{1e6}}, light{8};
  vary(light, {1e-6, 1, 1, 1, 1, 1, 1, 1}, {});
  for (const auto& [chain, velocity] : {std::pair(stiff, 100.0), {light, 1.87}}) {
    const Impact impact{velocity, chain, 3, 0.2, may_move};
    CHECK(strike(method_for(1e-4, largest_step, 2), impact).run.broken());
    const auto runs =
        refined(1e-4, [&](const EventCorrected& method) { return strike(method, impact); });
    CAPTURE(runs.history);
    CHECK(runs.history.find("breaks at t = ") < runs.history.find("holds"));
    CHECK(runs.fine.end.t == 3);
    CHECK(runs.error <= 1e-4);
    CHECK(runs.fine.run.energy_drift < 1e-5);
    const auto finer = strike(method_for(1e-4, largest_step, runs.method.halvings + 1), impact);
    CHECK(distance(runs.fine.end, finer.end) <= runs.error);
  }
  // Stiff contacts divide the steps themselves
  const Impact hard{100, {8, Quartic{0}, PowerContact{10, 0}}, 3, 0.2, may_move};
  const auto runs =
      refined(1e-4, [&](const EventCorrected& method) { return strike(method, hard); });
  CHECK(runs.history.find("breaks") == std::string::npos);
  const auto finer = strike(method_for(1e-4, largest_step, runs.method.halvings + 1), hard);
  CHECK(distance(runs.fine.end, finer.end) <= runs.error);
  // Free flight is no escape, however far it leads
  CHECK(evolved({2, None{}}, struck(2, 1000), 2000, 1000) == "");
}

TEST_CASE("nothing is said to leave a well without a rim", "[property][accuracy]") {
  for (double velocity : {3.0, 30.0, 100.0})
    for (double alpha : {1.5, 3.0, 10.0})
      for (const Well& well :
           {Well(None{}), Well(Harmonic{}), Well(Quartic{1}), Well(Quartic{10})}) {
        const Chain chain{6, well, PowerContact{alpha, 0}};
        CAPTURE(velocity, alpha, describe(well));
        CHECK(evolved(chain, struck(6, velocity), 2, 0.2).find("runs away") == std::string::npos);
        CHECK_NOTHROW(refined(1e-2, [&](const EventCorrected& method) {
          return strike(method, {velocity, chain, 2, 0.2, may_move});
        }));
      }
}

TEST_CASE("forces that are nothing or wrong are told by the run", "[unit][accuracy]") {
  bool nothing = false;
  double wrong = 0;
  const Chain chain{20, Changing{&nothing, &wrong}};
  const auto start = struck(20, 1.5);
  CHECK(evolved(chain, start, 20, 1) == "");
  nothing = true;
  check_line(evolved(chain, start, 20, 1), "no step is short enough (step ");
  nothing = false;
  for (double by : {0.1, 1e-2, 1e-3}) {
    wrong = by;
    check_line(evolved(chain, start, 20, 1), "the energy drifts by ");
    check_line(evolved(chain, start, 20, 1), "with half of the step as well");
  }
  // Under a strong compression the energies are small, and known all the same
  const auto pressed = refined(1e-4, [&](const EventCorrected& method) {
    return strike(method, {1e-3, {5, Harmonic{}, PowerContact{8, 8}}, 1, 0.2, may_move});
  });
  CHECK(pressed.fine.run.energy_drift < 1e-5);
  // From rest on a hill the energy is nearly zero, and its relative drift says nothing
  struct Hill {
    double energy(double y) const { return y * y * (y * y / 4 - 0.5); }
    double force(double y) const { return y - y * y * y; }
    double stiffness(double y) const { return 3 * y * y - 1; }
  };
  CHECK(evolved({5, Hill{}}, struck(5, 1e-6), 30, 1) == "");
}

TEST_CASE("commands halve a step that is too long, and say when a bead leaves", "[cli]") {
  const Result stiff =
      call("sec34_impact run --velocity 100 --contact power --alpha 10 --sites 10 --time 5");
  CHECK(stiff.code == 0);
  CHECK(quantity(stiff, "energy_drift") < 1e-5);
  const Result pressed =
      call("sec4_precompression_mi impact --velocity 100 --d 10 --s 10 --time 60");
  CHECK(pressed.code == 0);
  CHECK(quantity(pressed, "energy_drift") < 1e-5);
  const Result gone = call("sec4_precompression_mi impact --velocity 5 --s -1/6");
  CHECK(gone.code == 1);
  check_line(gone.errors.substr(0, gone.errors.find('\n')), "a bead runs away at t = 2.30");
}

TEST_CASE("the peak of a packet is a maximum in time and no flank", "[cli]") {
  // By an integrator of order eight and samples every hundredth; at site 20 the density falls from 0.139 and from 0.211
  for (const auto& [options, peak] :
       {std::pair{"--well harmonic --sites 41 --velocity 1 --time 150", 0.126289144},
        {"--well harmonic --sites 41 --velocity 1.2 --time 120", 0.192802249},
        {"--well harmonic --sites 41 --velocity 1.03 --time 130", 0.175245315},
        {"--well none --sites 56 --velocity 2.723633454804505 --time 90", 2.725489064}}) {
    const Result answer = call("sec34_impact run --tolerance 1e-7 " + std::string(options));
    CAPTURE(options);
    check_close(quantity(answer, "peak_energy_density"), peak,
                quantity(answer, "peak_energy_density", "error"));
  }
}

TEST_CASE("packets are followed with samples that differ, up to the same time",
          "[unit][accuracy]") {
  const auto runs = refined(1e-4, [&](const EventCorrected& method) {
    return strike(method, {.velocity = 1, .chain = {60}, .time = 400, .until = 40});
  });
  const Path &coarse = runs.coarse.path, &fine = runs.fine.path;
  CHECK(runs.fine.end.t == runs.coarse.end.t);
  CHECK(fine.t.size() + 2 >= 2 * coarse.t.size());
  CHECK(coarse.largest_peak(20, 40).value != fine.largest_peak(20, 40).value);
  check_close(coarse.largest_peak(20, 40).value, fine.largest_peak(20, 40).value, 0, 1e-3);
}

TEST_CASE("estimates are never without an error unless they are exact", "[unit][accuracy]") {
  CHECK(compare(1.0, 1.0).error > 0);
  CHECK(compare(0.0, 0.0).error > 0);
  CHECK(compare(2.0, 1.5).error == 0.5);
  CHECK_FALSE(compare(1.0, 1.0).is_exact);
  CHECK(std::isnan(compare(std::nan(""), 1.0).error));
  CHECK(exact(3).is_exact);
  CHECK(compare(3, 3).is_exact);
  CHECK_FALSE(compare(3, 4).is_exact);
  CHECK(compare(3, 4).error == 1);
  check_close(compare(Estimate{1, 0.1}, Estimate{1.5, 0.2}).error, 0.7, 1e-15);
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
  const auto workers = [] {
    std::set<std::thread::id> seen;
    std::mutex guard;
    std::vector<double> square(200);
    parallel_for("squares", square.size(), [&](std::size_t i) {
      square[i] = double(i) * double(i);
      std::this_thread::sleep_for(std::chrono::microseconds(100));
      const std::lock_guard lock(guard);
      seen.insert(std::this_thread::get_id());
    });
    for (std::size_t i = 0; i < square.size(); ++i) CHECK(square[i] == double(i * i));
    return seen.size();
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

TEST_CASE("no number of a program is without an error unless it is exact",
          "[published][accuracy]") {
  for (const auto& folder : std::filesystem::directory_iterator(DATA_DIR)) {
    const auto file = folder.path() / "facts.ecsv";
    if (!std::filesystem::exists(file)) continue;
    const Table t = read(file);
    const auto label = t.texts("quantity"), kind = t.texts("kind");
    const auto value = t.numbers("value"), error = t.numbers("error");
    for (std::size_t i = 0; i < kind.size(); ++i) {
      CAPTURE(file.string(), label[i], error[i], kind[i]);
      if (kind[i] == "exact")
        CHECK(error[i] == 0);
      else
        CHECK((error[i] > 0 || std::isnan(value[i])));
    }
  }
}
