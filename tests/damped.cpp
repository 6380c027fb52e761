// Friction: the closed form of one bead, order two, the budget, absorbing ends, and no friction.

#include "lattice/stepping/damped.hpp"

#include "check.hpp"
#include "lattice/landing/landing.hpp"
#include "lattice/packets/impact.hpp"
#include "lattice/stepping/contact_rkn.hpp"

using namespace lattice;

namespace {

/// A wave on a ring whose contacts stay closed.

const Chain ring{20, Quartic{1}, CompressedHertz{2}, Ends::periodic};

State<double> wave() {
  State<double> s(20);
  for (int n = 0; n < 20; ++n) s.y[std::size_t(n)] = 0.3 * std::sin(0.3 * M_PI * n);
  return s;
}

template <class Stepper>
State<double> after(const Stepper& stepper, double time) {
  State<double> s = wave();
  evolve(stepper, ring, s, time, time, Unobserved{});
  return s;
}

}  // namespace

TEST_CASE("one damped bead follows the closed form", "[unit][damped]") {
  const Chain chain{1};
  const double nu = 0.2, time = 10, omega = std::sqrt(1 - nu * nu / 4);
  const double decay = std::exp(-nu * time / 2), c = std::cos(omega * time);
  const double sine = std::sin(omega * time) / omega;
  const auto error = [&](double step) {
    State<double> s(1);
    s.y[0] = 1;
    evolve(Damped(Splitting{blanes_moan_6(), step}, nu), chain, s, time, time, Unobserved{});
    return std::max(std::abs(s.y[0] - decay * (c + nu / 2 * sine)),
                    std::abs(s.v[0] + decay * sine));
  };
  const double coarse = error(0.02), fine = error(0.01);
  CAPTURE(coarse, fine);
  CHECK(fine < 1e-5);
  check_close(std::log2(coarse / fine), 2, 0.01);
}

TEST_CASE("the order is two with any conservative stepper", "[convergence][damped]") {
  const auto order = [](auto stepper_of) {
    const auto exact = after(stepper_of(0.0025), 5);
    return std::log2(largest_difference(after(stepper_of(0.08), 5), exact) /
                     largest_difference(after(stepper_of(0.04), 5), exact));
  };
  check_close(order([](double h) { return Damped(Splitting{verlet(), h}, 0.3); }), 2, 0.1);
  check_close(order([](double h) { return Damped(Splitting{blanes_moan_6(), h}, 0.3); }), 2, 0.1);
  check_close(order([](double h) { return Damped(ContactAware{h}, 0.3); }), 2, 0.1);
}

TEST_CASE("energy and dissipated energy add up", "[property][damped]") {
  Chain chain{80, Quartic{1}};
  std::vector<double> mass(80), nu(80, 0);
  for (std::size_t n = 0; n < 80; ++n) mass[n] = 1 + 0.3 * double(n % 4);
  for (std::size_t n = 0; n < 30; ++n) nu[n] = 0.002 * double(1 + n);
  vary(chain, mass, {});
  const auto check = [&](const auto& stepper, double bound) {
    State<double> s = struck(80, 1.9);
    const double before = energy(chain, s);
    double worst = 0, last = 0;
    const DampedRun run = evolve(stepper, chain, s, 100, 1, [&](const auto& now, double lost) {
      worst = std::max(worst, std::abs(energy(chain, now) + lost - before) / before);
      CHECK(lost >= last);
      last = lost;
    });
    CHECK(run.energy_drift == worst);
    CHECK(run.dissipated == last);
    CHECK(run.dissipated > 0.05 * before);  // there is something to account for
    check_close(energy(chain, s) + run.dissipated, before, 0, 1.01 * run.energy_drift);
    CAPTURE(run.energy_drift);
    CHECK(run.energy_drift < bound);
  };
  check(Damped(Splitting{blanes_moan_6(), 0.02}, nu), 2e-6);
  check(Damped(ContactAware{0.02}, nu), 1e-7);
}

TEST_CASE("an end that absorbs lets little return", "[property][damped]") {
  const Chain chain{120, {}, CompressedHertz{0.5}};
  std::vector<double> nu(120, 0);
  for (std::size_t n = 60; n < 120; ++n) nu[n] = 0.5 * std::pow(double(n - 59) / 60, 2);
  State<double> open = struck(120, 0.05), absorbing = open;
  evolve(Splitting{blanes_moan_4(), 0.05}, chain, open, 2000, 2000, Unobserved{});
  const DampedRun run = evolve(Damped(Splitting{blanes_moan_4(), 0.05}, nu), chain, absorbing, 2000,
                               2000, Unobserved{});
  CHECK(energy(chain, absorbing) < 0.1 * energy(chain, open));
  CHECK(run.energy_drift < 1e-5);
}

TEST_CASE("without friction the bits are those of the stepper", "[unit][damped]") {
  const Chain chain{60, Quartic{1}};
  const auto same = [&](const auto& stepper) {
    State<double> a = struck(60, 1.9), b = a, c = a;
    const Run plain = evolve(stepper, chain, a, 40, 10, Unobserved{});
    const DampedRun run = evolve(Damped(stepper, 0), chain, b, 40, 10, Unobserved{});
    evolve(Damped(stepper, std::vector<double>(60, 0)), chain, c, 40, 10, Unobserved{});
    CHECK(a.y == b.y);
    CHECK(a.v == b.v);
    CHECK(a.y == c.y);
    CHECK(run.dissipated == 0);
    CHECK(run.energy_drift == plain.energy_drift);
    CHECK(run.work == plain.work);
  };
  same(Splitting{blanes_moan_6(), 0.05});
  same(ContactAware{0.05});
}

TEST_CASE("impossible friction is refused", "[unit][damped]") {
  const Splitting stepper{verlet(), 0.1};
  CHECK_THROWS_AS(Damped(stepper, -0.1), std::invalid_argument);
  CHECK_THROWS_AS(Damped(stepper, std::nan("")), std::invalid_argument);
  State<double> s = wave();
  const Damped wrong(stepper, std::vector<double>(7, 0.1));
  CHECK_THROWS_AS(evolve(wrong, ring, s, 1, 1, Unobserved{}), std::invalid_argument);
}
