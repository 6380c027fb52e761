// Driven and damped chains a second time: the alternating steps and what they book, in plain loops; what a run says of
// packets, from its record.

#include <limits>
#include <numbers>

#include "check.hpp"
#include "sec5/driven_end.hpp"

namespace driven_again {

using namespace lattice;
using By = Drive::By;

namespace {

constexpr double turn = 2 * std::numbers::pi, forever = std::numeric_limits<double>::infinity();
constexpr std::size_t many = std::numeric_limits<std::size_t>::max();

/// Half steps of drive and losses about a conservative step, the whole chain at once.
struct Again {
  DrivenChain d;
  double h;
  State<double> s;
  EnergyBudget b{0, 0, 0};

  double mass(std::size_t n) const { return d.chain.mass.empty() ? 1 : d.chain.mass[n]; }
  double kinetic() const {
    double sum = 0;
    for (std::size_t n = 0; n < s.v.size(); ++n) sum += mass(n) * s.v[n] * s.v[n] / 2;
    return sum;
  }
  void push(double t) {
    const Drive& by = d.drive;
    const double a =
        t < by.ramp ? by.from * (1 - t / by.ramp) + by.amplitude * t / by.ramp : by.amplitude;
    const double x = a * std::sin(by.omega * t), before = kinetic();
    const double touch = x > s.y[0] ? std::pow(x - s.y[0], 1.5) : 0;
    s.v[0] += h / 2 / mass(0) * (by.by == By::base ? x : by.by == By::piston ? touch : 0);
    b.work += kinetic() - before;
  }
  void beams() {
    const double before = kinetic();
    for (std::size_t n = 0; n < s.v.size(); ++n)
      s.v[n] *= std::exp(-h / 2 * (d.losses.of_site.empty() ? d.losses.rate : d.losses.of_site[n]));
    b.beams += before - kinetic();
  }
  // The momentum of a pair stays, its relative velocity decays
  void contact(std::size_t i) {
    const double x = s.y[i] - s.y[i + 1], m = mass(i), k = mass(i + 1), before = kinetic();
    if (x <= 0) return;
    const double eta = d.chain.eta.empty() ? 1 : d.chain.eta[i + 1];
    const double common = (m * s.v[i] + k * s.v[i + 1]) / (m + k);
    const double left =
        std::exp(-h / 2 * 1.5 * d.losses.contact * eta * std::sqrt(x) * (1 / m + 1 / k));
    for (std::size_t n : {i, i + 1}) s.v[n] = common + left * (s.v[n] - common);
    b.contacts += before - kinetic();
  }
  void step() {
    const std::size_t pairs = s.v.size() - 1;
    Window all{0, s.v.size()};
    push(s.t), beams();
    for (std::size_t i = 0; i < pairs; ++i) contact(i);
    ContactAware{h}.advance(d.chain, s, all, h, 1);
    for (std::size_t i = pairs; i-- > 0;) contact(i);
    beams(), push(s.t += h);
  }
};

Chain uneven(std::size_t sites) {
  Chain chain{sites};
  std::vector<double> mass, eta{1};
  for (std::size_t n = 0; n < sites; ++n)
    mass.push_back(1 + 0.3 * double(n % 3)), eta.push_back(1.5 - 0.2 * double(n % 4));
  vary(chain, mass, eta);
  return chain;
}

/// Runs both ways, from one state, and compares all that comes out.
void same_run(const DrivenChain& d, const State<double>& start, double interval, int samples,
              int steps) {
  Again again{d, interval / steps, start};
  const double begin = energy(d.chain, start);
  double scale = begin, open = 0;
  int seen = -1;
  State<double> end = start;
  const double budget =
      run_driven(d, end, TimeGrid{interval * samples, std::size_t(samples), std::size_t(steps)},
                 [&](const State<double>& now, const EnergyBudget& l) {
                   if (++seen > 0)
                     for (int k = 0; k < steps; ++k) again.step();
                   const double e = energy(d.chain, again.s);
                   scale = std::max(scale, std::max(e, again.b.work));
                   open = std::max(
                       open, std::abs(e - begin + again.b.beams + again.b.contacts - again.b.work));
                   check_close(now.t, start.t + interval * seen, 1e-12);
                   for (std::size_t n = 0; n < now.y.size(); ++n) {
                     check_close(now.y[n], again.s.y[n], 1e-12);
                     check_close(now.v[n], again.s.v[n], 1e-12);
                   }
                   check_close(l.beams, again.b.beams, 1e-13);
                   check_close(l.contacts, again.b.contacts, 1e-13);
                   check_close(l.work, again.b.work, 1e-13);
                   return true;
                 });
  CHECK(seen == samples);
  check_close(budget, scale > 0 ? open / scale : 0, 1e-13);
}

/// What `drive_chain` should say, from all samples of a run that nothing ends early.
Emission emission_again(const DrivenChain& d, double duration, std::size_t detector, double step,
                        std::size_t enough, double silence) {
  std::vector<State<double>> states;
  std::vector<double> work;
  TimeGrid grid = time_grid(duration / 2, 0.4, step);
  grid.duration = duration, grid.samples *= 2;
  State<double> state(d.chain.sites);
  run_driven(d, state, grid, [&](const State<double>& now, const EnergyBudget& l) {
    states.push_back(now), work.push_back(l.work);
    return true;
  });
  const double a = std::max(d.drive.from, d.drive.amplitude), excess = d.drive.omega - 1;
  const double unit = d.drive.by == By::piston ? a * a : a * a / (excess * excess);
  Emission out;
  std::vector<double> tops;  // of the periods so far
  double top = 0, low = 0, high = 0, half = 0;
  bool in = false;
  std::size_t last = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const State<double>& now = states[last = i];
    const double y = now.y[detector - 1], v = now.v[detector - 1], e = 0.5 * y * y + 0.5 * v * v;
    top = std::max(top, e), out.loudest = std::max(out.loudest, e / unit);
    // A period is over with the first sample at its end or later
    if (now.t >= double(tops.size()) * turn / d.drive.omega) {
      tops.push_back(top), low = in ? low : std::min(low, top), high = std::max(high, top);
      if (in && 2 * top < high)
        in = false, low = top;
      else if (!in && top > 4 * low && top > 0.03 * unit)
        in = true, high = top, out.passages.push_back(now.t);
      top = 0;
    }
    out.far = std::max(out.far, std::abs(now.y.back()));
    if (now.t < (duration + grid.interval()) / 2) half = work[i];
    const double heard = out.passages.empty() ? 0 : out.passages.back();
    if (out.passages.size() >= enough || now.t >= heard + silence) break;
    if (silence < forever && !out.passages.empty() && heard + silence > duration) break;
  }
  out.power = (work[last] - half) / (duration / 2);
  State<double> anew(d.chain.sites);
  out.budget = run_driven(d, anew, grid, [&](const State<double>& now, const EnergyBudget&) {
    return now.t < states[last].t;
  });
  return out;
}

void same_emission(const Emission& value, const Emission& expected) {
  CHECK(value.passages == expected.passages);
  check_close(value.power, expected.power, 1e-15, 1e-12);
  check_close(value.far, expected.far, 0);
  check_close(value.loudest, expected.loudest, 0, 1e-12);
  check_close(value.budget, expected.budget, 0);
}

}  // namespace

TEST_CASE("drive, friction and motion alternate and book what they take", "[unit][driven]") {
  Drive piston{By::piston, 1.3, 0.8, 0.2, 3}, base{By::base, 0.7, 0.3, 0.9, 1.5};
  std::vector<double> rates{0.3, 0, 0.1, 0.2, 0.4, 0.05};
  State<double> rest(6), moving(6), late(6);
  moving.y = {0.3, -0.2, 0.5, 0.1, 0.4, -0.3}, moving.v = {1, -0.5, 0.2, -0.8, 0.6, 0.3};
  late.v[3] = 1, late.v[4] = -0.7, late.t = 2.5;
  for (const State<double>& start : {rest, moving, late}) {
    same_run({uneven(6), {0, 0.4, rates}, piston}, start, 0.9, 4, 3);
    same_run({uneven(6), {0.05, 0.2}, base}, start, 0.9, 4, 3);
    same_run({Chain{6}, {0, 0.3}, piston}, start, 0.9, 4, 3);
    same_run({Chain{6}, {0.2, 0}}, start, 0.9, 4, 3);
    same_run({Chain{6}, {1, 0}}, start, 0.9, 4, 3);
    same_run({uneven(6)}, start, 0.9, 4, 3);
  }
  // More work than there ever is energy; one bead, and two
  same_run({Chain{1}, {3, 0}, {By::base, 0.2, 1}}, State<double>(1), 1, 30, 4);
  State<double> two(2);
  two.y = {0.4, -0.1}, two.v = {0.5, -1};
  same_run({Chain{2}, {0.1, 0.3}, piston}, two, 0.9, 4, 3);
}

TEST_CASE("an amplitude rises on a straight line, a run ends when nobody looks", "[unit][driven]") {
  const Drive drive{By::piston, 2, 3, 1, 4};
  for (double t : {0.0, 1.0, 3.5}) check_close(drive.amplitude_at(t), 1 + t / 2, 1e-15);
  for (double t : {4.0, 5.0}) CHECK(drive.amplitude_at(t) == 3);
  check_close(drive.displacement(1), 1.5 * std::sin(2), 1e-15);
  check_close(drive.force(1, 0.5), std::pow(1.5 * std::sin(2) - 0.5, 1.5), 1e-14);
  CHECK(drive.force(1, 1.5) == 0);
  check_close(Drive{By::base, 2, 3}.force(1, 0.5), 3 * std::sin(2), 1e-15);
  CHECK(Drive{By::base, 2, 3}.amplitude_at(0) == 3);
  const Drive none;
  CHECK((none.by == By::nothing && none.omega == 1 && none.amplitude == 0));
  CHECK((none.from == 0 && none.ramp == 0));
  const Losses lossless;
  CHECK((lossless.rate == 0 && lossless.contact == 0));
  for (int looks : {1, 3}) {
    State<double> state(2);
    state.v[0] = 1;
    int seen = 0;
    run_driven({Chain{2}}, state, TimeGrid{8, 8, 4},
               [&](const State<double>&, const EnergyBudget&) { return ++seen < looks; });
    CHECK(seen == looks);
    CHECK(state.t == looks - 1);
  }
  // A drive and viscous contacts need free ends, other losses do not
  const DrivenObserver on = [](const State<double>&, const EnergyBudget&) { return true; };
  const auto refused = [&](Ends ends, Losses losses, Drive by) {
    Chain chain{4};
    chain.ends = ends;
    State<double> state(4);
    return !refusal([&] { run_driven({chain, losses, by}, state, TimeGrid{1, 1, 4}, on); }).empty();
  };
  for (Ends ends : {Ends::fixed, Ends::periodic}) {
    CHECK(refused(ends, {0, 0.1}, {}));
    CHECK(refused(ends, {}, {By::base, 1, 1}));
    CHECK(!refused(ends, {0.1, 0}, {}));
  }
  CHECK(!refused(Ends::free, {0, 0.1}, {By::base, 1, 1}));
  for (double bad : {-0.1, forever}) CHECK(refused(Ends::free, {0, 0, {0, 0, bad, 0}}, {}));
  CHECK(refused(Ends::free, {0, 0, {0, 0, 0, 0, 0}}, {}));
}

TEST_CASE("a collision of two beads, step by step", "[unit][driven]") {
  for (double v : {0.7, 3.0}) {
    const double unit = std::pow(v, -0.2);
    Again again{{Chain{2, None{}}, {0, 0.2}}, unit / 512, State<double>(2)};
    again.s.v[0] = v;
    for (int k = 0; k < 6 * 512; ++k) again.step();
    State<double> state(2);
    state.v[0] = v;
    run_driven(again.d, state, time_grid(6 * unit, 6 * unit, unit / 512),
               [](const State<double>&, const EnergyBudget&) { return true; });
    check_close((state.v[1] - state.v[0]) / v, (again.s.v[1] - again.s.v[0]) / v, 1e-12);
    // The alternating steps err where the contact switches
    check_close(restitution(0.2, v), (again.s.v[1] - again.s.v[0]) / v, 3e-5);
  }
  CHECK(contact_loss(1, 0.7) == 0);
  const double strong = contact_loss(0.02, 0.7);
  CHECK(strong > 1);
  check_close(restitution(strong, 0.7), 0.02, 1e-9);
  for (double e : {0.0, -0.1, 1.0001}) CHECK_THROWS_AS(contact_loss(e, 0.7), std::invalid_argument);
}

TEST_CASE("packets are counted as a record of the run has them", "[unit][driven]") {
  std::size_t passages = 0, between = 0;
  for (const Drive& by : {Drive{By::base, 1.1, 0.1, 0, 0},
                          {By::base, 1.4, 0.02, 0.05, 20},
                          {By::piston, 1.3, 0.3, 0, 0},
                          {By::piston, 1.15, 0.1, 0.2, 30}})
    for (double rate = 0.02; rate < 3; rate *= 1.4) {
      const DrivenChain d{Chain{3}, {rate, 0}, by};
      const Emission seen = drive_chain(d, 120, 1, 0.2);
      same_emission(seen, emission_again(d, 120, 1, 0.2, many, forever));
      passages += seen.passages.size(), between += seen.loudest > 0.03 && seen.loudest < 0.06;
    }
  CHECK(passages > 40);
  CHECK(between > 3);
  // Another bead; an end after some packets, after a silence, or with the last one
  const DrivenChain d{Chain{5}, {0.05, 0}, {By::piston, 1.2, 0.6}};
  for (std::size_t detector : {2, 4})
    for (std::size_t enough : {std::size_t(1), std::size_t(3), many})
      for (double silence : {15.0, 30.0, 70.0, forever}) {
        CAPTURE(detector, enough, silence);
        same_emission(drive_chain(d, 150, detector, 0.2, enough, silence),
                      emission_again(d, 150, detector, 0.2, enough, silence));
      }
}

TEST_CASE("a map has the largest energy of each bead in each span", "[unit][driven]") {
  const DrivenChain d{Chain{3}, {0.01, 0}, {By::piston, 1.2, 0.6}};
  State<double> state(3);
  std::vector<double> expected(4 * 3, 0);
  run_driven(d, state, time_grid(30, 0.8, 0.3), [&](const State<double>& now, const auto&) {
    std::size_t bin = 0;
    while (bin < 3 && now.t >= 7.5 * double(bin + 1)) ++bin;
    for (std::size_t n = 0; n < 3; ++n)
      expected[bin * 3 + n] =
          std::max(expected[bin * 3 + n], now.y[n] * now.y[n] / 2 + now.v[n] * now.v[n] / 2);
    return true;
  });
  const std::vector<double> map = drive_map(d, 30, 4, 0.3);
  REQUIRE(map.size() == 12);
  for (std::size_t i = 0; i < 12; ++i) check_close(map[i], expected[i], 0, 1e-14);
  CHECK(map[4] != map[7]);
}

}  // namespace driven_again
