// Refinement: two resolutions are two runs, what must agree is named, runs that end early say so.

#include "lattice/integrators/refinement.hpp"

#include <tuple>

#include "lattice/impact/impact.hpp"
#include "support/check.hpp"
#include "support/states.hpp"

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

const Chain hard{40, Quartic{1}};

/// A result for `refined`: the struck chain after ten units of time, seen every `sample`.
struct Struck {
  State<double> end;
  Run run;
};

Struck after_impact(const EventCorrected& method, double sample) {
  Struck out{struck(hard.sites, 1.9), {}};
  out.run = evolve(method, hard, out.end, 10, Every{sample});
  return out;
}

Refined<ImpactRun> refined_impact(double tolerance, const Impact& impact) {
  return refined(tolerance, [&](const EventCorrected& method) { return strike(method, impact); });
}

/// What is said of a run; nothing if it comes to its time.
std::string evolved(const Chain& chain, State<double> state, double time, double sample,
                    double tolerance = 1e-6) {
  const auto said =
      refusal([&] { evolve(Converged{tolerance}, chain, state, time, Every{sample}); });
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
  for (double sample : {0.03, 0.1, 0.25, 0.3, 10.0}) {
    CAPTURE(sample);
    const TimeGrid first = time_grid(EventCorrected{0.2}, 10, Every{sample});
    CHECK(first.step() <= 0.2 * (1 + 1e-12));
    CHECK(first.interval() <= sample * (1 + 1e-12));
    for (int k = 1; k <= 5; ++k) {
      const EventCorrected finer = method_for(1e-6, 0.2, k);
      const TimeGrid same = time_grid(finer, 10, Every{sample}),
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

TEST_CASE("two identical runs are refused as a proof of agreement", "[unit][accuracy]") {
  const auto deaf = [](const EventCorrected&) { return after_impact(EventCorrected{0.2}, 0.1); };
  const Reading energies{"energies", [](const Struck& s) { return energy(hard, s.end); }};
  CHECK_THROWS_AS(refined(1e-6, deaf), std::logic_error);
  CHECK_THROWS_AS(refined(1e-6, deaf, energies), std::logic_error);
  // A chain at rest has the same bits at every step, and that is no mistake.
  CHECK(refined_impact(1e-6, {0, {5, Quartic{1}}, 10}).error == 0);
}

TEST_CASE("what must agree is named, and named again where it does not", "[unit][accuracy]") {
  const Reading share{"shares of the first bead", [](const Struck& s) {
                        const auto e = energy_density(hard, s.end);
                        return e[0] / total(e);
                      }};
  const auto compute = [](const EventCorrected& s) { return after_impact(s, 1); };
  const auto loose = refined(1e-2, compute, share), tight = refined(1e-7, compute, share);
  CHECK(tight.error <= 1e-7);
  CHECK(tight.method.halvings > loose.method.halvings);
  const auto message = refusal<RefinementFailed>([&] { refined(0, compute, share); });
  check_line(message, "shares of the first bead");
  check_line(message, "step 0.1:");
}

TEST_CASE("a refinement gives up when halvings cannot help any more", "[unit][accuracy]") {
  // What never agrees is run six times
  struct Outcome {
    double x;
    Run run{};
  };
  int runs = 0;
  const auto erratic = [&](const EventCorrected&) { return Outcome{++runs % 2 ? 1.0 : 2.0}; };
  const Reading number{"numbers", [](const Outcome& out) { return out.x; }};
  const auto message = refusal<RefinementFailed>([&] { refined(1e-4, erratic, number); });
  CHECK(runs == 6);
  CHECK(message.find("differ by more than the tolerance (step 0.1: 0.5, ") != std::string::npos);
  CHECK(message.find("a larger tolerance") != std::string::npos);
}

TEST_CASE("two runs that agree by chance are found out", "[unit][accuracy]") {
  struct Outcome {
    double x;
    Run run{};
  };
  const Reading number{"numbers", [](const Outcome& out) { return out.x; }};
  // Twice the first step, the first step, and its halvings; x should be 1
  const auto with = [&](std::vector<double> x) {
    return refined(
        1e-4, [=](const EventCorrected& m) { return Outcome{x[std::size_t(m.halvings + 1)]}; },
        number);
  };
  const auto x_of = [](const Outcome& out) { return out.x; };
  const auto early = with({1.1, 1.003, 1.003 + 1e-9, 1 - 1e-3, 1 + 1e-5, 1 - 1e-7, 1 + 1e-9});
  CHECK(early.fine.x == 1 + 1e-9);
  CHECK(early.of(x_of).error > 1e-7);
  const auto late = with({1.1, 1.03, 1.01, 1.003, 1.003 + 1e-9, 1 - 1e-5, 1 + 1e-7, 1 + 1e-8});
  CHECK(late.fine.x == 1 + 1e-8);
  CHECK(late.of(x_of).error > 1e-7);
  // What converges as it should costs no more than the run before
  CHECK(with({1 + 1e-3, 1 + 1e-5, 1 + 1e-7}).fine.x == 1 + 1e-7);
}

TEST_CASE("a tolerance is met and reported, or refused with its history", "[property][contact]") {
  const Chain chain{60, Quartic{1}};
  const auto exact = after(EventCorrected{0.004}, chain, struck(60, 1.9), 20);
  for (double tolerance : {1e-3, 1e-5, 1e-7, 1e-9}) {
    auto s = struck(60, 1.9);
    const Run run = evolve(Converged{tolerance}, chain, s, 20, Every{5});
    CAPTURE(tolerance, run.error);
    CHECK(run.error <= tolerance);
    CHECK(distance(s, exact) <= run.error);
  }
  // Chaos forbids any
  const auto message = evolved({20, Quartic{1}}, random_state(20, 1.5), 1000, 1000);
  CHECK(message.find("step 0.1:") != std::string::npos);
}

TEST_CASE("a run of no duration returns its start", "[unit][accuracy]") {
  auto s = struck(10, 1);
  const auto start = s;
  int shown = 0;
  const Run run = evolve(Converged{1e-9}, Chain{10, Quartic{1}}, s, 0, Every{1},
                         [&](const State<double>&) { ++shown; });
  CHECK(shown == 1);
  CHECK(run.steps == 0);
  CHECK(s.y == start.y);
  CHECK(s.v == start.v);
  CHECK(s.t == 0);
  CHECK_THROWS_AS(evolve(Converged{1e-9}, Chain{10}, s, 5e-324, Every{1}), std::invalid_argument);
}

TEST_CASE("a run in which a bead runs away says when, whatever the samples are",
          "[unit][accuracy]") {
  const Chain soft{60, Quartic{-1.0 / 6}};
  for (const auto& [sample, tolerance] : {std::pair(0.2, 1e-4), {10, 1e-9}, {100, 1e-4}}) {
    CAPTURE(sample, tolerance);
    const auto said = [&](double velocity) {
      return evolved(soft, struck(60, velocity), 100, sample, tolerance);
    };
    check_line(said(2.12), "a bead runs away at t = 44.48, having left its well at t = 41.5");
    check_line(said(2.125), "a bead runs away at t = 44.84");
    CHECK(said(2.13) == "");
  }
  // A strong blow sends the bead away within the first steps
  check_line(evolved(soft, struck(60, 100), 100, 1), "a bead runs away at t = 0.351");
  CHECK_THROWS_AS(refined_impact(1e-4, on_long_chain({2.12, soft, 100})), RanAway);
}

TEST_CASE("a start that is not finite, or absurd, is refused", "[unit][accuracy]") {
  const double nan = std::nan(""), inf = INFINITY;
  const Chain chain{20, Quartic{1}};
  for (double bad : {nan, -inf, 1e20}) {
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
  CHECK_THROWS_AS(time_grid(1, 0, 1), std::invalid_argument);
  CHECK_THROWS_AS(time_grid(1, 1, 0), std::invalid_argument);
}

TEST_CASE("what is not a number is far from everything", "[unit][accuracy]") {
  State<double> a(3), b(3);
  CHECK(distance(a, b) == 0);
  a.v[1] = std::nan("");
  CHECK(std::isinf(distance(a, b)));
  CHECK(std::isinf(distance(a, a)));
}

TEST_CASE("a step that is too long is halved until a run holds", "[convergence][accuracy]") {
  // Stiff wells after a strong blow, a light bead, and stiff contacts, which divide the steps themselves
  Chain stiff{8, Quartic{1e6}}, light{8};
  vary(light, {1e-6, 1, 1, 1, 1, 1, 1, 1}, {});
  const Chain power{8, Harmonic{}, PowerContact{10, 0}};
  for (const auto& [chain, velocity, breaks] :
       {std::tuple(stiff, 100.0, true), {light, 1.87, true}, {power, 100, false}}) {
    const Impact impact{velocity, chain, 3, 0.2, may_move};
    CHECK(strike(method_for(1e-4, largest_step, 2), impact).run.broken() == breaks);
    const auto runs = refined_impact(1e-4, impact);
    CAPTURE(runs.history);
    const auto said =
        std::min(runs.history.find("fails at t = "), runs.history.find("changes the energy by "));
    CHECK((breaks ? said < runs.history.find("succeeds") : said == std::string::npos));
    CHECK(runs.fine.end.t == 3);
    CHECK(runs.error <= 1e-4);
    CHECK(runs.fine.run.energy_drift < 1e-5);
    const auto finer = strike(method_for(1e-4, largest_step, runs.method.halvings + 1), impact);
    CHECK(distance(runs.fine.end, finer.end) <= runs.error);
  }
  // Free flight is no escape, however far it leads
  CHECK(evolved({2, NoWell{}}, struck(2, 1000), 2000, 1000) == "");
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
  for (double by : {0.1, 1e-3}) {
    wrong = by;
    const std::string said = evolved(chain, start, 20, 1);
    check_line(said, "the energy drifts by ");
    check_line(said, "also with half the step");
  }
  // Under a strong compression the energies are small, and known all the same
  const Chain pressed{5, Harmonic{}, PowerContact{8, 8}};
  CHECK(refined_impact(1e-4, {1e-3, pressed, 1, 0.2, may_move}).fine.run.energy_drift < 1e-5);
  // From rest on a hill the energy is nearly zero, and its relative drift says nothing
  CHECK(evolved({5, Hill{}}, struck(5, 1e-6), 30, 1) == "");
}

TEST_CASE("packets are followed with samples that differ, up to the same time",
          "[unit][accuracy]") {
  const auto runs = refined_impact(1e-4, {.velocity = 1, .chain = {60}, .time = 400, .until = 40});
  const Path &coarse = runs.coarse.path, &fine = runs.fine.path;
  CHECK(runs.fine.end.t == runs.coarse.end.t);
  CHECK(fine.size() + 2 >= 2 * coarse.size());
  CHECK(coarse.largest_peak(20, 40).value != fine.largest_peak(20, 40).value);
  check_close(coarse.largest_peak(20, 40).value, fine.largest_peak(20, 40).value, 0, 1e-3);
}
