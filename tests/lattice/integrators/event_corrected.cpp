// Splittings, integrators that know the contact, and the event location flow with its tangent map: orders, agreement,
// exactness of the window, symmetry, reversal, energy.

#include <random>

#include "lattice/events/event_driven.hpp"
#include "lattice/gsl/reference.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/integrators/refinement.hpp"
#include "support/check.hpp"

using namespace lattice;

namespace {

template <class Stepper>
State<double> after(const Stepper& method, const Chain& chain, State<double> s, double time) {
  evolve(method, chain, s, time, time);
  return s;
}

template <class T = double>
State<T> event_driven(const Chain& chain, const State<double>& start, double time,
                      Tangent<T>* tangent = nullptr) {
  State<T> s(chain.sites);
  std::copy(start.y.begin(), start.y.end(), s.y.begin());
  std::copy(start.v.begin(), start.v.end(), s.v.begin());
  flow(chain, s, T(time), EventTolerance<T>{}, tangent);
  return s;
}

/// Root mean square over several impacts of the error of the end state.
template <class Make>
double impact_error(double h, Make make) {
  double squares = 0;
  for (double v0 : {1.3, 1.4, 1.5, 1.6, 1.7, 1.8, 1.9}) {
    const Chain chain{60, Quartic{1}};
    const auto exact = after(EventCorrected{0.004}, chain, struck(60, v0), 20);
    squares += std::pow(distance(after(make(h), chain, struck(60, v0), 20), exact), 2);
  }
  return std::sqrt(squares / 7);
}

EventCorrected corrected(double h) {
  return {h};
}
EventCorrected uncorrected(double h) {
  return {h, dormand_prince_6(), 1e300};
}

State<double> random_state(std::size_t sites, double size, unsigned seed) {
  std::mt19937_64 bits(seed);
  State<double> s(sites);
  for (auto* x : {&s.y, &s.v})
    for (double& value : *x) value = size * (double(bits() >> 11) * 0x1p-52 - 1);
  return s;
}

}  // namespace

TEST_CASE("schemes have their order where contacts stay closed", "[convergence][contact]") {
  const Chain ring{20, Quartic{1}, CompressedHertz{2}, Ends::periodic};
  State<double> wave(20);
  for (int n = 0; n < 20; ++n) wave.y[n] = 0.3 * std::sin(0.3 * M_PI * n);
  const auto exact = after(EventCorrected{0.01}, ring, wave, 5);
  const auto order = [&](const auto& coarse, const auto& fine) {
    return std::log2(distance(after(coarse, ring, wave, 5), exact) /
                     distance(after(fine, ring, wave, 5), exact));
  };
  for (const Nystrom& base :
       {dormand_prince_6(), nystrom(blanes_moan_6()), nystrom(blanes_moan_6_14())}) {
    CAPTURE(base.name);
    check_close(order(EventCorrected{0.2, base}, EventCorrected{0.1, base}), 6, 0.5);
  }
  const struct {
    Scheme scheme;
    double step, within;
  } splittings[] = {{verlet(), 0.02, 0.1},
                    {blanes_moan_4(), 0.1, 0.2},
                    {blanes_moan_6(), 0.2, 0.4},
                    {blanes_moan_6_14(), 0.4, 0.4}};
  for (const auto& [scheme, step, within] : splittings) {
    CAPTURE(scheme.name);
    check_close(order(Splitting{scheme, step}, Splitting{scheme, step / 2}), scheme.order, within);
  }
}

TEST_CASE("the correction restores the order across switching contacts", "[convergence][contact]") {
  const auto slope = [](double h, double k, auto make) {
    return std::log(impact_error(h, make) / impact_error(k, make)) / std::log(h / k);
  };
  const double order = slope(0.1, 0.0125, corrected), stalled = slope(0.05, 0.0125, uncorrected);
  CAPTURE(order, stalled);
  CHECK(order > 4.2);
  CHECK(stalled < 3.2);
  // Without knowledge of the contacts every splitting is held near 2.5
  for (const Scheme& scheme : {blanes_moan_4(), blanes_moan_6()})
    check_close(slope(0.08, 0.01, [&](double h) { return Splitting{scheme, h}; }), 2.6, 0.6);
  check_close(slope(0.02, 0.005, [](double h) { return Splitting{verlet(), h}; }), 2, 0.3);
  CHECK(impact_error(0.05, corrected) < 1e-3 * impact_error(0.05, uncorrected));
}

TEST_CASE("the order at t = 100 on the hard impact is at least 4.5", "[convergence][contact]") {
  const Chain chain{200, Quartic{1}};
  const auto exact = after(EventCorrected{0.004}, chain, struck(200, 1.9), 100);
  const auto error = [&](double h) {
    double worst = 0;
    const auto s = after(EventCorrected{h}, chain, struck(200, 1.9), 100);
    for (std::size_t n = 0; n < 200; ++n) worst = std::max(worst, std::abs(s.y[n] - exact.y[n]));
    return worst;
  };
  CHECK(std::log(error(0.05) / error(0.0125)) / std::log(4) > 4.5);
}

TEST_CASE("three families agree on the same problems", "[property][contact]") {
  const auto compare = [](const auto& chain, const State<double>& start, double time) {
    const auto aware = after(EventCorrected{0.005}, chain, start, time);
    auto theirs = start, ours = event_driven(chain, start, time);
    ours.t = aware.t;
    evolve_reference(chain, theirs, time, 1e-13);
    theirs.t = aware.t;
    check_close(distance(aware, ours), 0, 2e-11);
    check_close(distance(theirs, ours), 0, 2e-11);
    check_close(distance(after(Splitting{blanes_moan_6(), 5e-4}, chain, start, time), ours), 0,
                1e-8);
  };
  compare(Chain{30, Quartic{1}}, struck(30, 1.9), 15);
  compare(Chain{12}, random_state(12, 1, 3), 10);
  compare(Chain{12, Quartic{-0.1}, CompressedHertz{0.3}, Ends::fixed}, random_state(12, 0.6, 5),
          10);
  compare(Chain{12, Pendulum{}, {}, Ends::periodic}, random_state(12, 1, 7), 10);
  Chain varied{12};
  std::vector<double> mass(12, 1), eta(13, 1);
  mass[4] = 3, eta[4] = 0.6, eta[5] = 1.4;
  vary(varied, mass, eta);
  compare(varied, random_state(12, 1, 9), 10);
}

TEST_CASE("any exponent is corrected", "[property][contact]") {
  for (double alpha : {1.25, 1.4, 2.0, 2.5}) {
    CAPTURE(alpha);
    const Chain chain{20, Quartic{0.5}, PowerContact{alpha, 0}};
    const auto exact = after(EventCorrected{0.004}, chain, struck(20, 1.5), 15);
    const double with = distance(after(corrected(0.05), chain, struck(20, 1.5), 15), exact);
    const double without = distance(after(uncorrected(0.05), chain, struck(20, 1.5), 15), exact);
    CAPTURE(with, without);
    CHECK(with < 2e-6);
    CHECK(with < without / 50);
  }
}

TEST_CASE("a windowed run has the bits of the full run", "[property][window]") {
  const auto same_by = [](const auto& method, const Chain& chain, const State<double>& start) {
    auto windowed = start, full = start;
    Window some = waking(chain, windowed), all{0, chain.sites};
    Method(method).on(chain)(windowed, some, 0.05, 2000);
    Method(method).on(chain)(full, all, 0.05, 2000);
    CHECK(some.last - some.first < chain.sites);
    CHECK(windowed.y == full.y);
    CHECK(windowed.v == full.v);
  };
  const auto same = [&](const Chain& chain, const State<double>& start) {
    same_by(EventCorrected{0.05}, chain, start);
    same_by(Splitting{blanes_moan_6(), 0.05}, chain, start);
  };
  same(Chain{120, Quartic{1}}, struck(120, 1.9));
  State<double> middle(160);
  middle.v[80] = 1;
  same(Chain{160}, middle);
  same(Chain{400, Quartic{1}, CompressedHertz{0.5}}, struck(400, 1.9));
}

TEST_CASE("a run is undone by turning the velocities round", "[property]") {
  const Chain chain{60, Quartic{1}};
  for (const Scheme& scheme : {verlet(), blanes_moan_4(), blanes_moan_6()}) {
    CAPTURE(scheme.name);
    auto s = after(Splitting{scheme, 0.05}, chain, struck(60, 1.9), 20);
    for (double& v : s.v) v = -v;
    s.t = 0;
    s = after(Splitting{scheme, 0.05}, chain, s, 20);
    auto start = struck(60, 1.9);
    start.v[0] = -1.9;
    check_close(largest_difference(s, start), 0, 1e-11);
  }
}

TEST_CASE("energy drift is small and reported", "[property]") {
  const Chain chain{200, Quartic{1}};
  auto s = struck(200, 1.9);
  const Run run = evolve(Splitting{blanes_moan_6(), 0.02}, chain, s, 200, 1);
  CHECK(run.energy_drift > 0);
  CHECK(run.energy_drift < 1e-5);
  check_close(energy(chain, s), 1.9 * 1.9 / 2, 0, run.energy_drift * 1.01);
}

TEST_CASE("the chain agrees with GSL's adaptive method", "[property]") {
  const Chain chain{40, Quartic{-0.3}};
  auto ours = after(Splitting{blanes_moan_6(), 1e-3}, chain, struck(40, 0.9), 30);
  check_close(distance_from_reference(chain, struck(40, 0.9), 30, ours, 1e-6), 0, 1e-7);
  ours.v[3] += 1e-5;  // a state that GSL does not confirm is refused
  CHECK_THROWS_AS(distance_from_reference(chain, struck(40, 0.9), 30, ours, 1e-6),
                  std::runtime_error);
}

TEST_CASE("contact-aware runs are symmetric, conserve energy and can be reversed",
          "[property][contact]") {
  const Chain chain{31, Quartic{1}};
  const auto start = random_state(31, 0.8, 11);
  State<double> mirrored(31);
  for (std::size_t n = 0; n < 31; ++n) {
    mirrored.y[n] = -start.y[30 - n];
    mirrored.v[n] = -start.v[30 - n];
  }
  const auto a = after(EventCorrected{0.05}, chain, start, 30),
             b = after(EventCorrected{0.05}, chain, mirrored, 30);
  for (std::size_t n = 0; n < 31; ++n) CHECK(b.y[n] == -a.y[30 - n]);

  auto s = struck(31, 1.9);
  const Run run = evolve(EventCorrected{0.05}, chain, s, 30, 1);
  CHECK(run.energy_drift < 1e-7);
  for (double& v : s.v) v = -v;
  s = after(EventCorrected{0.05}, chain, s, 30);
  check_close(s.v[0], -1.9, 1e-6);
  for (double y : s.y) check_close(y, 0, 1e-6);
}

namespace {

/// Errors of a motion during which the overlap of two beads turns round at zero.
struct Graze {
  double gap, tangent, orbit, aware;
};

/// Follows two beads that reach `turn`, where both rest, after one unit of time, and leave it as
/// they came. The truth is computed without any look-out: since the instant is known, a run with
/// 64-bit mantissas ends there and another one begins.
Graze graze(const Chain& chain, const State<double>& turn) {
  const auto past = event_driven<long double>(chain, turn, 1);
  State<double> start(2);
  for (int n : {0, 1}) start.y[n] = double(past.y[n]), start.v[n] = -double(past.v[n]);

  Tangent<long double> fine(2, 4);
  auto exact = event_driven<long double>(chain, start, 1, &fine);
  Graze found{double(exact.y[1] - exact.y[0]) - chain.contact.opening(), 0, 0, 0};
  flow(chain, exact, 1.0L, EventTolerance<long double>{}, &fine);

  Tangent<double> m(2, 4);
  const auto with = event_driven(chain, start, 2, &m), alone = event_driven(chain, start, 2);
  const auto aware = after(EventCorrected{0.05}, chain, start, 2);
  const auto off = [](double a, long double b) { return double(std::abs(a - b)); };
  for (std::size_t i = 0; i < 16; ++i)
    found.tangent = std::max(found.tangent, off(m.entries[i], fine.entries[i]));
  for (int n : {0, 1}) {
    found.orbit = std::max({found.orbit, off(with.y[n], exact.y[n]), off(alone.y[n], exact.y[n]),
                            off(with.v[n], exact.v[n]), off(alone.v[n], exact.v[n])});
    found.aware = std::max(found.aware, off(aware.y[n], exact.y[n]));
  }
  return found;
}

/// Not touching, exactly zero, and touching, down to the last bit of a number near one.
std::vector<double> lifts() {
  std::vector<double> all{0};
  for (int k = 2; k <= 52; k += 2) all.insert(all.end(), {std::ldexp(1, -k), -std::ldexp(1, -k)});
  return all;
}

void check_graze(const Graze& found, double gap) {
  CAPTURE(gap);
  check_close(found.gap, gap, 1e-15);
  check_close(found.tangent, 0, 1e-12);
  check_close(found.orbit, 0, 1e-13);
  check_close(found.aware, 0, 1e-9);
}

}  // namespace

// The wells have the frequencies 1 and 1/2, so that beads that swing out together part by themselves.
TEST_CASE("beads that almost or just touch are followed exactly", "[property][contact][events]") {
  Chain chain{2};
  vary(chain, {1, 4}, {});
  for (double lift : lifts()) {
    State<double> turn(2);
    turn.y = {0.5, 0.5 * (1 + lift)};
    check_graze(graze(chain, turn), 0.5 * lift);
  }
}

TEST_CASE("beads that almost or just part are followed exactly", "[property][contact][events]") {
  const Chain chain{2, {}, CompressedHertz{0.25}};
  for (double lift : lifts()) {
    State<double> turn(2);
    turn.y = {-0.125 * (1 + lift), 0.125 * (1 + lift)};
    check_graze(graze(chain, turn), 0.25 * lift);
  }
}

namespace {

/// Two beads with a stiff contact, the position and velocity that the first one has at the end (from DOP853 between the
/// zeros of the overlap), and what is found.
struct Stiff {
  std::vector<double> mass;
  double eta;
  std::vector<double> y, v;
  double time, y_end, v_end;

  Chain chain() const {
    Chain two{2};
    vary(two, mass, {0, eta, 0});
    return two;
  }
  State<double> start() const {
    State<double> s(2);
    s.y = y, s.v = v;
    return s;
  }
};

/// A light bead that swings from the phase `f` on and meets a heavy one near its turning point, where the overlap reaches
/// less than A - 1, for a time of less than 2 sqrt(2 (A - 1)).
Stiff swing(double eta, double A, double f, double y_end, double v_end) {
  return {{1, 1e6}, eta, {A * std::cos(f), 1}, {-A * std::sin(f), 0}, 6, y_end, v_end};
}

}  // namespace

TEST_CASE("contacts that are shorter than a step are not missed", "[property][contact]") {
  for (const Stiff& c :
       {swing(1e5, 1.000048, 3.29614, -0.991841245840, -0.127855183591),
        swing(100, 1.00005, 2.17, -0.310800649504, -0.950527726462),
        swing(1e4, 1.00002, 2.2, -0.339174205137, -0.940744842706),
        swing(1e6, 1.00002, 2.2, -0.340227272429, -0.940364510573),
        Stiff{{1e-3, 1}, 1e3, {-0.3, 0.5}, {2, 0.1}, 3, -0.416068070829, 10.707525283},
        Stiff{{1e-2, 5}, 1e5, {-0.3, 0.2}, {1, 0.1}, 3, -0.061614768036, 2.8950477276}}) {
    CAPTURE(c.eta, c.mass[0]);
    auto s = c.start();
    const Run run = evolve(Converged{1e-8}, c.chain(), s, c.time, c.time);
    CHECK(run.error <= 1e-8);
    const double scale = std::max(1.0, std::abs(c.v_end));
    check_close(s.y[0], c.y_end, 3 * run.error * scale);
    check_close(s.v[0], c.v_end, 3 * run.error * scale);
    auto event_driven = c.start();
    flow(c.chain(), event_driven, c.time);
    check_close(event_driven.y[0], c.y_end, 1e-10);
    check_close(event_driven.v[0], c.v_end, 1e-9);
  }
}

TEST_CASE("the error of stiff contacts contains the truth", "[property][contact]") {
  std::mt19937_64 bits(49);
  const auto random = [&](double from, double to) {
    return from + (to - from) * double(bits() >> 11) * 0x1p-53;
  };
  for (double eta : {1.0, 1e2, 1e4, 1e6})
    for (int k = 0; k < 12; ++k) {
      const double A = 1 + std::pow(10, random(-7, -2)), f = random(0, 2 * M_PI);
      const Stiff c = swing(eta, A, f, 0, 0);
      auto s = c.start();
      const Run run = evolve(Converged{1e-8}, c.chain(), s, c.time, c.time);
      auto exact = c.start();
      flow(c.chain(), exact, c.time);
      exact.t = s.t;
      CAPTURE(eta, A, f);
      CHECK(distance(s, exact) <= 5 * run.error);
    }
}

TEST_CASE("a tolerance is met and reported", "[property][contact]") {
  const Chain chain{60, Quartic{1}};
  const auto exact = after(EventCorrected{0.004}, chain, struck(60, 1.9), 20);
  for (double tolerance : {1e-3, 1e-5, 1e-7, 1e-9}) {
    auto s = struck(60, 1.9);
    const Run run = evolve(Converged{tolerance}, chain, s, 20, 5);
    CAPTURE(tolerance, run.error);
    CHECK(run.error <= tolerance);
    CHECK(distance(s, exact) <= run.error);
  }
}

TEST_CASE("a tolerance that chaos forbids is refused with its history", "[property][contact]") {
  const Chain chain{20, Quartic{1}};
  auto s = random_state(20, 1.5, 13);
  const auto message =
      refusal<RefinementFailed>([&] { evolve(Converged{1e-6}, chain, s, 3000, 3000); });
  CHECK(message.find("step 0.1:") != std::string::npos);
}

TEST_CASE("the event-driven flow is exact, reversible and conserves energy", "[property][events]") {
  const Chain chain{16, Quartic{0.5}, Hertz{.floor = 0}};
  const auto start = random_state(16, 1, 17);
  auto s = start;
  const auto there = flow(chain, s, 12.0);
  CHECK(there.energy_drift < 1e-12);
  CHECK(there.contact_events > 20);
  const auto fine = event_driven<long double>(chain, start, 12);
  for (std::size_t n = 0; n < 16; ++n) check_close(s.y[n], double(fine.y[n]), 1e-12);
  for (double& v : s.v) v = -v;
  flow(chain, s, 12.0);
  for (std::size_t n = 0; n < 16; ++n) check_close(s.y[n], start.y[n], 1e-11);
}

TEST_CASE("the tangent map is symplectic, and good to twelve digits", "[property][events]") {
  const Chain chain{8, Quartic{0.5}, Hertz{.floor = 0}};
  const auto start = random_state(8, 0.7, 19);
  Tangent<double> m(8, 16);
  Tangent<long double> fine(8, 16);
  event_driven(chain, start, 6, &m);
  event_driven(chain, start, 6, &fine);
  for (std::size_t i = 0; i < 16; ++i)
    for (std::size_t j = 0; j < 16; ++j) {
      check_close(m(i, j), double(fine(i, j)), 1e-12);
      double form = 0;
      for (std::size_t k = 0; k < 8; ++k) form += m(k, i) * m(k + 8, j) - m(k + 8, i) * m(k, j);
      check_close(form, j == i + 8 ? 1 : i == j + 8 ? -1 : 0, 2e-12);
    }
}

TEST_CASE("tiny contacts in a tail are neither missed nor looped on", "[property][events]") {
  const Chain chain{12, {}, Hertz{.floor = 0}};
  State<double> s(12);
  for (std::size_t n = 0; n < 12; ++n)
    s.y[n] = (n % 2 ? -0.1 : 0.1) * std::pow(10.0, -3.0 * double(n));  // down to 1e-34
  const auto start = s;
  EventTolerance<double> rule;
  rule.floor = 0;
  const auto f = flow(chain, s, 6.0, rule);
  CHECK(f.steps < 5000);
  CHECK(f.contact_events > 10);
  CHECK(f.missed_events == 0);
  const auto fine = event_driven<long double>(chain, start, 6);
  for (std::size_t n = 0; n < 12; ++n) check_close(s.y[n], double(fine.y[n]), 0, 1e-9);
  State<double> rest(12);
  CHECK(flow(chain, rest, 6.0).steps < 100);
}
