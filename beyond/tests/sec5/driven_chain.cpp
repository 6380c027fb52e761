// Driven and damped chains: losses, drives, what they book; thresholds.

#include "sec5/driven_chain.hpp"

#include <numbers>

#include "lattice/cantilever/cantilever.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/model/dps.hpp"
#include "lattice/standing/stationary.hpp"
#include "sec5/driven_array.hpp"
#include "sec5/solution_curve.hpp"
#include "support/check.hpp"

using namespace lattice;

namespace {

/// Unequal beads with both losses, driven by a piston.
DrivenChain busy() {
  DrivenChain driven{Chain{12}, {0.01, 0.05}, {Drive::By::piston, 1.3, 0.2, 0, 20}};
  std::vector<double> mass(12);
  for (std::size_t n = 0; n < 12; ++n) mass[n] = 1 + 0.2 * double(n % 3);
  vary(driven.chain, mass, {});
  return driven;
}

State<double> after(const DrivenChain& driven, double time, double step) {
  State<double> state(driven.chain.sites);
  evolve(driven, state, time_grid(time, time, step));
  return state;
}

}  // namespace

TEST_CASE("response and power of a driven end are not those of single looks", "[unit][driven]") {
  // Looks 0.4 apart fall on six phases of the first drive; half of the second run is no multiple of 0.4
  for (const auto& [omega, duration] :
       {std::pair(std::numbers::pi / 1.2, 480.0), {1.7, 160 * std::numbers::pi / 1.7}}) {
    CAPTURE(omega);
    DrivenChain bead{Chain{3}, {0.3, 0}, {Drive::By::base, omega, 0.1}};
    vary(bead.chain, {}, {0, 0, 0, 0});
    const Emission out = drive_chain(bead, duration, 2, 0.005);
    const double size = 0.1 / std::hypot(1 - omega * omega, 0.3 * omega);
    check_close(out.response, size, 0, 1e-3);
    check_close(out.power, 0.3 / 2 * omega * omega * size * size, 0, 1e-3);
  }
}

TEST_CASE("losses and work are booked to the last digits", "[property][driven]") {
  const DrivenChain driven = busy();
  State<double> state(12);
  EnergyBudget last;
  evolve(driven, state, time_grid(100, 1, 0.01), [&](const State<double>&, const EnergyBudget& l) {
    CHECK(l.beams >= last.beams);
    CHECK(l.contacts >= last.contacts);
    last = l;
    return true;
  });
  CHECK(last.beams > 0.01 * last.work);
  CHECK(last.contacts > 0.01 * last.work);
  check_close(energy(driven.chain, state) + last.beams + last.contacts, last.work, 0, 1e-9);
}

TEST_CASE("the alternation of losses, drive and motion has order two", "[convergence][driven]") {
  const State<double> exact = after(busy(), 20, 0.00125);
  const double coarse = largest_difference(after(busy(), 20, 0.04), exact);
  const double fine = largest_difference(after(busy(), 20, 0.02), exact);
  CAPTURE(coarse, fine);
  check_close(std::log2(coarse / fine), 2, 0.2);
}

TEST_CASE("viscous contacts have the restitution of perturbation theory", "[unit][driven]") {
  // The loss of an elastic collision to first order in A, with a beta function
  const double v = 0.7, contact = 1e-3, x = std::pow(5.0 / 8 * v * v, 0.4);
  const double beta = std::tgamma(0.6) * std::tgamma(1.5) / std::tgamma(2.1);
  const double lost = 3 * contact * v * x * std::sqrt(x) * 0.4 * beta / (v * v / 4);
  check_close(1 - restitution(contact, v), lost / 2, 0, 5e-3);
  check_close(restitution(0, v), 1, 1e-9);
  // Dormand and Prince's method of order eight, in another program
  check_close(restitution(0.2, 0.7), 0.66227774363, 1e-11);
  check_close(restitution(0.2, 3), 0.57813594145, 1e-11);
  check_close(restitution(0.03, 0.05), 0.96321156395, 1e-11);
  check_close(restitution(contact_loss(0.9, v), v), 0.9, 1e-9);
  CHECK_THROWS_AS(contact_loss(1.1, v), std::invalid_argument);
}

TEST_CASE("impossible losses are refused", "[unit][driven]") {
  State<double> state(3);
  for (const Losses& losses : {Losses{-1, 0}, Losses{0, -1}, Losses{std::nan(""), 0}})
    CHECK_THROWS_AS(evolve({Chain{3}, losses}, state, time_grid(1, 1, 0.1)), std::invalid_argument);
}

TEST_CASE("a driven chain runs with the length of its masses and in states of that length only",
          "[unit][driven]") {
  Chain twelve{12};
  vary(twelve, std::vector<double>(12, 1), {});
  const auto refused = [](const Chain& chain, const State<double>& state) {
    CAPTURE(chain.sites, bool(chain.variation), state.y.size());
    State<double> end = state;
    CHECK_THROWS_AS(evolve({chain}, end, time_grid(1, 1, 0.1)), std::invalid_argument);
  };
  for (const std::size_t sites : {8, 13, 136}) {
    Chain other = twelve;
    other.sites = sites;
    for (const Chain& chain : {other, twelve, Chain{12}}) refused(chain, struck(sites, 1));
  }
  State<double> ragged = struck(12, 1);
  ragged.v.pop_back();
  refused(twelve, ragged);
  // Masses without stiffnesses, and the other way round
  Chain half{12};
  half.variation = Variation{twelve.variation->mass, twelve.variation->mass, {}};
  refused(half, struck(12, 1));
  half.variation = Variation{{}, {}, twelve.variation->eta};
  refused(half, struck(12, 1));
}

TEST_CASE("a driven run for a tolerance balances its budget", "[property][driven]") {
  DrivenChain driven{Chain{12}, {}, {Drive::By::base, 1.2, 0.05}};
  driven.losses.of_site.assign(12, 0.1);
  State<double> state(12);
  std::size_t seen = 0;
  const auto pair = evolve(Converged{1e-5}, driven, state, 60, Every{0.5},
                           [&](const State<double>&, const EnergyBudget&) { return ++seen, true; });
  CHECK(seen == 121);
  CHECK(pair.error <= 1e-5);
  CHECK(pair.error > 0);
  CHECK(pair.fine.imbalance < 1e-8);
  CHECK(distance(state, pair.fine.end) == 0);
  check_close(pair.fine.energy + pair.fine.budget.beams, pair.fine.budget.work, 0, 1e-8);
}

TEST_CASE("a drive that is faster than the steps is seen", "[property][driven]") {
  // With 2 pi / omega = 0.1 and 0.2 the force vanishes at the ends of all steps of the first resolutions
  for (double omega : {20 * std::acos(-1.0), 10 * std::acos(-1.0), 40.0, 3.0}) {
    CAPTURE(omega);
    State<double> state(1);
    state.y[0] = 1;
    const auto pair =
        evolve(Converged{1e-4}, {Chain{1}, {}, {Drive::By::base, omega, 1}}, state, 10, Every{10},
               [](const State<double>&, const EnergyBudget&) { return true; });
    const double w = omega, y = std::cos(10) + (std::sin(10 * w) - w * std::sin(10)) / (1 - w * w),
                 v = -std::sin(10) + w * (std::cos(10 * w) - std::cos(10)) / (1 - w * w);
    check_close(state.y[0], y, 2 * pair.error);
    check_close(state.v[0], v, 2 * pair.error);
  }
}

TEST_CASE("packets of a strong drive are counted between the looks of a coarse run",
          "[unit][driven]") {
  // Extrapolated midpoint rule in another program, with looks ever closer: four packets in the second half
  DrivenArray drive;
  drive.frequency = 7955.80282808034, drive.amplitude = 200;
  drive.lifetime = 1.1669966356216845, drive.duration = 20.045936549755897;
  const Emission seen = drive.run(DrivenArray::step);
  check_close(drive.per_second(seen.rate(drive.horizon())), 199.5416872, 1e-6);
}

TEST_CASE("a drive has to lift the breather of the DpS limit to its top", "[unit][driven]") {
  const auto most = [](const auto& values) {
    double most = 0;
    for (double x : values) most = std::max(most, std::abs(x));
    return most;
  };
  const Estimate piston = dps_threshold(Drive::By::piston), base = dps_threshold(Drive::By::base);
  const double strain = most(stationary<double>(Centre::bond, 1.0, 30).strain);
  check_close(piston.value, most(stationary<double>(Centre::site, 1.0, 31).u), 0, 1e-7);
  check_close(base.value, strain * std::sqrt(strain), 0, 1e-7);
  // The maxima themselves, to forty digits from the same map: a grid of 4096 tails has nine of them
  check_close(piston.value, 0.05041478528676755684, 0, 1e-14);
  check_close(base.value, 0.028116631620059160114, 0, 1e-14);
  const double width = 2 * tau_0() * 0.07;
  check_close(threshold_law(Drive::By::piston, 1.07).value, 2 * width * width * piston.value, 0,
              1e-12);
  check_close(threshold_law(Drive::By::base, 1.07).value, 4 * 0.07 * width * width * base.value, 0,
              1e-12);
  for (Drive::By by : {Drive::By::piston, Drive::By::base}) {
    const Estimate law = threshold_law(by, 1.07), top = dps_threshold(by);
    check_close(law.error / law.value, top.error / top.value, 0, 1e-12);
    // As delta and nu go to zero, the fold tends to the law
    check_close(asymptotic_threshold(by, 1 + 1e-6, 0).error / threshold_law(by, 1 + 1e-6).value, 0,
                1e-5);
    CHECK(asymptotic_threshold(by, 1.07, 0.01).error > asymptotic_threshold(by, 1.07, 0).error);
  }
}

TEST_CASE("a curve of solutions is followed through its fold", "[unit][driven]") {
  // a = x (2 - x) has its largest a at x = 1, and the way there is known; a second unknown follows the first
  const auto parabola = [](const Vector<double>& x) {
    Vector<double> out(2);
    out << x[2] - x[0] * (2 - x[0]), x[1] - 3 * x[0];
    return out;
  };
  const SolutionCurve curve = follow_solutions(parabola, 3, 0.1, 0.02, 1, 0.5);
  check_close(curve.fold, 1, 1e-5);
  for (const Vector<double>& x : curve.points) CHECK(parabola(x).norm() < 1e-10);
  CHECK(curve.points.back()[0] > 1.6);
  check_close(curve.points.back()[2], 0.5, 0.05);
  CHECK(curve.length.back() > 3 * 1.7);
  const auto straight = [](const Vector<double>& x) {
    return Vector<double>::Constant(1, x[1] - x[0]);
  };
  CHECK_THROWS_AS(follow_solutions(straight, 2, 0.1, 0.1, 1, 0.5), std::runtime_error);
}

TEST_CASE("a threshold that is no sharp one lies among its neighbours", "[unit][driven]") {
  const auto sharp = threshold_among(1, 0.1, 3, [](double a) { return a > 1.04; });
  check_close(sharp.value, 1.05, 1e-12);
  check_close(sharp.error, 0.05, 1e-12);
  // 0.9 emits, 1.0 and 1.1 are quiet
  const auto mixed =
      threshold_among(1, 0.1, 3, [](double a) { return a > 0.85 && (a < 0.95 || a > 1.15); });
  check_close(mixed.value, 1.0, 1e-12);
  check_close(mixed.error, 0.1, 1e-12);
  for (bool always : {true, false})
    CHECK_THROWS_AS(threshold_among(1, 0.1, 3, [&](double) { return always; }), std::runtime_error);
  CHECK_THROWS_AS(threshold_among(1, 0.1, 3, [](double a) { return a < 1.04; }),
                  std::runtime_error);
}

TEST_CASE("rates and bisections", "[unit][driven]") {
  Emission e;
  e.passages = {10, 60, 70, 80, 90};
  check_close(e.rate(100), 0.08, 1e-15);
  const auto found = bisect_threshold(0, 1, 1e-3, [](double a) { return a > 0.3; });
  check_close(found.value, 0.3, found.error);
  CHECK(found.error < 1e-3);
  CHECK_THROWS_AS(bisect_threshold(0.4, 1, 1e-3, [](double a) { return a > 0.3; }),
                  std::runtime_error);
}

TEST_CASE("units of the array", "[unit][driven]") {
  const Scales u = CantileverArray{}.scales();
  check_close(u.hertz(u.omega(7000)), 7000, 1e-9);
  check_close(u.milliseconds(u.time(3)), 3, 1e-12);
  check_close(u.omega(7000), 2 * std::numbers::pi * 7000 * std::sqrt(u.m / u.k), 1e-12);
  check_close(u.rate(10) * u.time(10), 1, 1e-12);
  CHECK(u.rate(0) == 0);
}

TEST_CASE("an array whose far end moves is too short for its drive", "[unit][driven]") {
  DrivenArray array;
  array.duration = 20, array.amplitude = 200, array.lifetime = 1000;
  const auto whole = array.quantities();
  array.beads = 25;
  CHECK(array.run(0.04).far > 1e-9);
  const auto lengthened = array.quantities();
  for (std::size_t i = 0; i < 4; ++i)
    check_close(lengthened[i].value.value, whole[i].value.value, 1e-12, 1e-9);
  array.amplitude = 0.001;
  CHECK(array.run(0.04).far < 1e-9);
}
