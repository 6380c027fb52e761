// The event-driven flow: its look-out, errors, beads that just touch or part, and its tangent map, also where sites do
// not sit in a well of curvature one: no well, the top of a hill, heavy and light beads, precompressed contacts.

#include "lattice/events/event_driven.hpp"

#include "lattice/impact/impact.hpp"
#include "support/check.hpp"
#include "support/states.hpp"

using namespace lattice;

namespace {

/// Carries a start in double precision over `time`, in any precision. A contact that is at rest and within a rounding of
/// zero may count as a missed event, so that `flow` would throw.
template <class T = double>
State<T> carried(const Chain& chain, const State<double>& start, double time,
                 Tangent<T>* tangent = nullptr) {
  State<T> s(chain.sites);
  std::copy(start.y.begin(), start.y.end(), s.y.begin());
  std::copy(start.v.begin(), start.v.end(), s.v.begin());
  const FlowReport<T> report = try_flow(chain, s, T(time), EventTolerance<T>{}, tangent);
  CHECK(double(report.error) < 1e-10);
  return s;
}

}  // namespace

TEST_CASE("the look-out's parabola and cubic by hand", "[unit][formulas]") {
  // 3 - 4 t + t^2 leaves the positive side at t = 1, its mirror image the negative one.
  check_close(Overlap<double>{3, -4, 2}.leaves(1), 1, 1e-14);
  check_close(Overlap<double>{-3, 4, -2}.leaves(-1), 1, 1e-14);
  check_close(Overlap<double>{3, -4, 2}.turns(), 2, 1e-14);
  // 3 + 2 t - t^2 first rises and leaves at t = 3.
  check_close(Overlap<double>{3, 2, -2}.leaves(1), 3, 1e-14);
  CHECK(std::isinf(Overlap<double>{3, -1, 2}.leaves(1)));
  // 1 - t + 2 t^2 - t^3 on an interval of length 2.
  const Arc<double> arc{1, -1, -1, -5, 2};
  for (double s : {0.0, 0.2, 0.9, 1.0}) {
    const double t = 2 * s;
    check_close(arc.value(s), 1 - t + 2 * t * t - t * t * t, 1e-14);
    check_close(arc.slope(s), -1 + 4 * t - 3 * t * t, 1e-13);
  }
}

TEST_CASE("the extrapolation is worth its name", "[unit][formulas]") {
  // A wrong extrapolation still arrives, because its error is seen and the steps become short: 398 of
  // them instead of 10 for a single bead, 1220 instead of 45 for six.
  State<double> turned(1);
  turned.y[0] = 0.5;
  const auto smooth = flow(Chain{1, Quartic{1}}, turned, 3.0);
  CHECK(smooth.steps <= 15);
  CHECK(smooth.error < 1e-12);
  auto hit = struck(6, 1.5);
  Tangent<double> tangent(6, 12);
  const auto switching = flow(Chain{6, Quartic{1}}, hit, 3.0, {}, &tangent);
  CHECK(switching.steps <= 70);
  CHECK(switching.contact_events > 0);
  CHECK(switching.missed_events == 0);
  CHECK(switching.error < 3e-12);
}

TEST_CASE("the action integral counts the masses", "[unit][formulas]") {
  Chain chain{1};
  vary(chain, {4}, {1, 1});
  State<double> s(1);
  s.y[0] = 0.3;
  // v = -0.15 sin(t / 2): 4 * 0.15^2 * 2 pi over the period 4 pi.
  check_close(flow(chain, s, 4 * M_PI).action_integral, 0.18 * M_PI, 1e-12);
  check_close(s.y[0], 0.3, 1e-12);
}

TEST_CASE("the event-driven flow is exact, reversible and conserves energy", "[property][events]") {
  const Chain chain{16, Quartic{0.5}, Hertz{.negligible = 0}};
  const auto start = random_state(16, 1);
  auto s = start;
  const auto there = flow(chain, s, 6.0);
  CHECK(there.energy_drift < 1e-12);
  CHECK(there.contact_events > 20);
  const auto fine = carried<long double>(chain, start, 6);
  for (std::size_t n = 0; n < 16; ++n) check_close(s.y[n], double(fine.y[n]), 1e-12);
  for (double& v : s.v) v = -v;
  flow(chain, s, 6.0);
  for (std::size_t n = 0; n < 16; ++n) check_close(s.y[n], start.y[n], 1e-11);
}

TEST_CASE("a flow that is not accurate throws, and is reported by try_flow", "[unit][events]") {
  const auto check_refused = [&](const Chain& chain, double y, double time,
                                 const EventTolerance<double>& rule, const char* why) {
    State<double> s(1);
    s.y[0] = y;
    State<double> other = s;
    const FlowReport<double> report = try_flow(chain, s, time, rule);
    CHECK_FALSE(is_accurate(report, rule));
    check_line(refusal<FlowFailed>([&] { flow(chain, other, time, rule); }), why);
    return report;
  };
  CHECK_FALSE(check_refused(Chain{1, Quartic{-1}}, 1.1, 10, {}, "runs away").error <= 1);
  // No more than two leapfrogs a step, and steps of 1/16384 of a long run are still too long
  EventTolerance<double> poor;
  poor.levels = 2;
  CHECK(check_refused(Chain{1}, 0.5, 1000, poor, "(allowed: ").error <= 1);
  FlowReport<double> missed;
  missed.missed_events = 1;
  CHECK_FALSE(is_accurate(missed, {}));
}

TEST_CASE("beads that move alike touch by roundings, which are no events", "[property][events]") {
  const Chain chain{3, Quartic{1}};
  for (double apart : {0.0, 1e-15, -3e-15}) {
    State<double> s(3);
    s.y = {0.7, 0.7 + apart, 0.7};
    const FlowReport<double> report = flow(chain, s, 2.7);
    CHECK(report.contact_events == 0);
    CHECK(report.missed_events == 0);
    CHECK(report.evaluations < 2000);
    // One bead alone moves as they do
    State<double> one(1);
    one.y = {0.7};
    flow(Chain{1, Quartic{1}}, one, 2.7);
    for (std::size_t n = 0; n < 3; ++n) check_close(s.y[n], one.y[0], 1e-13);
  }
}

TEST_CASE("tiny contacts in a tail are neither missed nor looped on", "[property][events]") {
  const Chain chain{12, {}, Hertz{.negligible = 0}};
  State<double> s(12);
  for (std::size_t n = 0; n < 12; ++n)
    s.y[n] = (n % 2 ? -0.1 : 0.1) * std::pow(10.0, -3.0 * double(n));  // down to 1e-34
  const auto start = s;
  EventTolerance<double> rule;
  rule.slowest_event = 0;
  const auto f = flow(chain, s, 6.0, rule);
  CHECK(f.steps < 5000);
  CHECK(f.contact_events > 10);
  CHECK(f.missed_events == 0);
  const auto fine = carried<long double>(chain, start, 6);
  for (std::size_t n = 0; n < 12; ++n) check_close(s.y[n], double(fine.y[n]), 0, 1e-9);
  State<double> rest(12);
  CHECK(flow(chain, rest, 6.0).steps < 100);
}

namespace {

/// Two beads reach `turn`, where both rest and are `gap` from parting or touching, after one unit of time, and leave it
/// as they came. The truth is computed without any look-out: since the instant is known, a run with 64-bit mantissas
/// ends there and another one begins.
void check_graze(const Chain& chain, const State<double>& turn, double gap) {
  CAPTURE(gap);
  const auto past = carried<long double>(chain, turn, 1);
  State<double> start(2);
  for (int n : {0, 1}) start.y[n] = double(past.y[n]), start.v[n] = -double(past.v[n]);

  Tangent<long double> fine(2, 4);
  auto exact = carried<long double>(chain, start, 1, &fine);
  check_close(double(exact.y[1] - exact.y[0]) - chain.contact.opening(), gap, 1e-15);
  CHECK(try_flow(chain, exact, 1.0L, {}, &fine).error < 1e-15L);

  Tangent<double> tangent(2, 4);
  const auto with = carried(chain, start, 2, &tangent), alone = carried(chain, start, 2);
  const auto aware = after(EventCorrected{0.05}, chain, start, 2);
  for (std::size_t i = 0; i < 16; ++i)
    check_close(tangent.entries[i], double(fine.entries[i]), 1e-12);
  for (int n : {0, 1}) {
    check_close(with.y[n], double(exact.y[n]), 1e-13);
    check_close(with.v[n], double(exact.v[n]), 1e-13);
    check_close(alone.y[n], double(exact.y[n]), 1e-13);
    check_close(alone.v[n], double(exact.v[n]), 1e-13);
    check_close(aware.y[n], double(exact.y[n]), 1e-9);
  }
}

}  // namespace

TEST_CASE("beads that almost or just touch or part are followed exactly",
          "[property][contact][events]") {
  // The wells have the frequencies 1 and 1/2, so that beads that swing out together part by themselves.
  Chain touching{2};
  vary(touching, {1, 4}, {});
  const Chain parting{2, {}, CompressedHertz{0.25}};
  // Not touching, exactly zero, and touching, down to the last bit of a number near one
  std::vector<double> lifts{0};
  for (int k = 2; k <= 52; k += 5)
    lifts.insert(lifts.end(), {std::ldexp(1, -k), -std::ldexp(1, -k)});
  for (double lift : lifts) {
    State<double> turn(2);
    turn.y = {0.5, 0.5 * (1 + lift)};
    check_graze(touching, turn, 0.5 * lift);
    turn.y = {-0.125 * (1 + lift), 0.125 * (1 + lift)};
    check_graze(parting, turn, 0.25 * lift);
  }
}

namespace {

/// A few beads in the middle move, the others rest: those are outside the core.
template <class T = double>
State<T> stirred(std::size_t sites) {
  State<T> s(sites);
  s.v[sites / 2] = T(0.75);
  s.v[sites / 2 + 1] = T(-0.5);
  s.y[sites / 2 - 1] = T(0.25);
  return s;
}

/// Against extended precision, whose core is another one, and against difference quotients. At a
/// contact that just touches these err by the square root of h.
void check_tangent(const Chain& chain) {
  const std::size_t n = chain.sites;
  const double time = 1.5;
  Tangent<long double> fine(n, 2 * n);
  Tangent<double> ours(n, 2 * n);
  carried(chain, stirred(n), time, &fine);
  carried(chain, stirred(n), time, &ours);
  double worst = 0;
  for (std::size_t i = 0; i < ours.entries.size(); ++i) {
    REQUIRE(std::isfinite(ours.entries[i]));
    worst = std::max(worst, std::abs(ours.entries[i] - double(fine.entries[i])));
  }
  CHECK(worst < 1e-9);

  for (std::size_t column : {std::size_t(0), n / 2, n, n + n / 2}) {
    const auto moved = [&](long double by) {
      State<long double> s = stirred<long double>(n);
      (column < n ? s.y[column] : s.v[column - n]) += by;
      flow(chain, s, (long double)time, {});
      s.y.insert(s.y.end(), s.v.begin(), s.v.end());
      return s.y;
    };
    const long double h = 1e-10L;
    const auto plus = moved(h), minus = moved(-h);
    for (std::size_t row = 0; row < 2 * n; ++row)
      check_close(ours(row, column), double((plus[row] - minus[row]) / (2 * h)), 5e-5);
  }
}

}  // namespace

TEST_CASE("the tangent of any chain is the derivative of the flow", "[property][tangent]") {
  const Hertz whole{.negligible = 0};
  std::vector<double> mass, eta(11, 1);
  for (std::size_t n = 0; n < 10; ++n) mass.push_back(1 + 0.5 * double(n % 3));
  eta[5] = 0.7, eta[6] = 1.3;
  const Chain plain[]{{10, NoWell{}, whole}, {10, Hill{}, whole}};
  for (Chain chain : plain) {
    check_tangent(chain);
    vary(chain, mass, eta);
    check_tangent(chain);
  }
  check_tangent({10, NoWell{}, CompressedHertz{0.5}});
  check_tangent({10, {}, CompressedHertz{0.5}, Ends::periodic});
}

TEST_CASE("a bead light enough to feel a faint contact belongs to the core", "[unit][tangent]") {
  Chain chain{3, {}, Hertz{.negligible = 0}};
  StepRecord<double> record;
  const std::vector<double> wells_and_links{1, 1, 1, 0, 1e-18, 0, 0};
  std::copy(wells_and_links.begin(), wells_and_links.end(), record.nodes.add(3, 0, 0));
  CHECK(core_of(chain, record, 1e-16) == Window{3, 3});
  vary(chain, {1, 1e-6, 1}, {});
  CHECK(core_of(chain, record, 1e-16) == Window{0, 2});
}

TEST_CASE("masses that are all one change no bit of a flow, of its tangent and of its energies",
          "[unit][tangent]") {
  constexpr std::size_t n = 12;
  for (const Ends ends : {Ends::free, Ends::fixed, Ends::periodic}) {
    CAPTURE(int(ends));
    Chain plain{n, Quartic{0.5}, {}, ends}, varied = plain;
    vary(varied, std::vector<double>(n, 1), std::vector<double>(n + 1, 1));
    const auto all_of = [&](const Chain& chain) {
      State<double> state = stirred(n);
      Tangent<double> tangent(n, 2 * n);
      const FlowReport<double> report = flow(chain, state, 3.0, {}, &tangent);
      CHECK(report.error < 1e-11);
      return std::tuple{state.y,      state.v,     tangent.entries, energy_density(chain, state),
                        report.error, report.steps};
    };
    CHECK(all_of(plain) == all_of(varied));
  }
}

TEST_CASE("a mirrored flow has the mirrored errors", "[unit][tangent]") {
  constexpr std::size_t n = 5;
  Chain chain{n, Quartic{0.5}};
  vary(chain, {}, std::vector<double>(n + 1, 0));
  State<double> state = stirred(n), mirrored = state;
  for (std::size_t i = 0; i < n; ++i) mirrored.y[i] = -state.y[i], mirrored.v[i] = -state.v[i];
  const FlowReport<double> one = flow(chain, state, 3.0), other = flow(chain, mirrored, 3.0);
  CHECK(one.error > 0);
  CHECK(one.error == other.error);
}

TEST_CASE("the tangent vector is the derivative of a step, on every site of every kind of chain",
          "[unit][tangent]") {
  for (Ends ends : {Ends::free, Ends::fixed, Ends::periodic})
    for (std::size_t n : {1U, 2U, 3U, 6U})
      for (bool heavy : {false, true}) {
        if (ends == Ends::periodic && n < 3) continue;
        Chain chain{.sites = n, .well = Quartic{0.7}, .ends = ends};
        std::vector<double> mass(n), z;
        for (std::size_t i = 0; i < n; ++i) mass[i] = 1 + 0.3 * double(i);
        if (heavy) vary(chain, mass, {});
        for (std::size_t i = 0; i < 2 * n; ++i) z.push_back(std::sin(3.0 * double(i) + 0.4));
        z.push_back(0);
        // The tangent vector, and the step from two neighbours along it
        std::vector<double> with = z, ahead = z, behind = z;
        const double change = 1e-6, dt = 0.1;
        for (std::size_t i = 0; i < 2 * n; ++i) {
          const double u = std::cos(2.0 * double(i) + 0.1);
          with.push_back(u), ahead[i] += change * u, behind[i] -= change * u;
        }
        Leapfrog<double>(chain, true).step(with, dt);
        Leapfrog<double> alone(chain, false);
        alone.step(ahead, dt), alone.step(behind, dt);
        CAPTURE(n, int(ends), heavy);
        for (std::size_t i = 0; i < 2 * n; ++i)
          check_close(with[2 * n + 1 + i], (ahead[i] - behind[i]) / (2 * change), 1e-8);
      }
}
