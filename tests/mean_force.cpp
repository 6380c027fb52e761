// The mean contact force of periodic motions, and shooting by leapfrog steps.

#include "sec2/mean_force.hpp"

#include <numbers>

#include "check.hpp"
#include "lattice/gsl/random.hpp"
#include "lattice/orbits/breather.hpp"
#include "sec2/fixed_leapfrog.hpp"
#include "sec2/periodic_motions.hpp"

using namespace lattice;

namespace {

/// A chain of six unequal beads between walls, at rest and far from equilibrium.
template <class Onsite>
std::pair<Chain, State<double>> walled() {
  Chain chain{6, Onsite{}, {}, Ends::fixed};
  vary(chain, shaken(std::vector<double>(6, 1), 0.3, 1), shaken(std::vector<double>(7, 1), 0.3, 2));
  State<double> state(6);
  for (std::size_t n = 0; n < 6; ++n) state.y[n] = (n % 2 == 0 ? 0.3 : -0.2) + 0.01 * double(n);
  return {chain, state};
}

}  // namespace

TEST_CASE("mean forces change the momentum of every bead", "[property][mean_force]") {
  const auto [chain, state] = walled<Harmonic>();
  const double time = 7;
  const MeanForces means = mean_forces(chain, state, time, 1e-12);
  for (std::size_t n = 0; n < 6; ++n)
    check_close(chain.mass_of(n) * means.end.v[n] / time,
                means.contact[n] - means.contact[n + 1] - means.well[n], 1e-11);
  CHECK(means.imbalance() > 1e-3);  // not periodic: the balance must be missed
  // The end is that of the other integrator.
  State<double> other = state;
  flow(chain, other, time);
  for (std::size_t n = 0; n < 6; ++n) check_close(means.end.y[n], other.y[n], 1e-9);
}

TEST_CASE("one bead between walls: the mean force by hand", "[unit][mean_force]") {
  // Twice per period the bead turns, and each wall gives it the impulse 2 v that it needs.
  Chain chain{1, None{}, {}, Ends::fixed};
  State<double> state(1);
  state.v[0] = 0.5;
  // Half a period by the energy: quarter from y = 0 to the turning point.
  double lo = 0.1, hi = 20;
  for (int k = 0; k < 60; ++k) {
    const double middle = (lo + hi) / 2;
    State<double> z = state;
    flow(chain, z, middle);
    (z.v[0] > 0 ? lo : hi) = middle;
  }
  const double period = 4 * lo;
  const MeanForces means = mean_forces(chain, state, period, 1e-13);
  check_close(means.contact[0], 2 * 0.5 / period, 1e-10);
  check_close(means.contact[1], 2 * 0.5 / period, 1e-10);
  check_close(means.end.y[0], 0, 1e-10);
}

TEST_CASE("a breather balances with its wells and with nothing else", "[property][mean_force]") {
  const auto problem = breather_problem(Centre::site, 1.3, 0, 21);
  const Orbit<double> orbit = find_breather(problem);
  const MeanForces means = mean_forces(problem.chain, orbit.start, orbit.period(), 1e-12);
  CHECK(means.imbalance() < 1e-10);
  CHECK(means.spread(1, 20) > 0.9 * means.contact[10]);
  // The wrong period, the wrong start and the wrong wells fail.
  CHECK(mean_forces(problem.chain, orbit.start, 0.9 * orbit.period(), 1e-12).imbalance() > 1e-5);
  State<double> wrong = orbit.start;
  wrong.y[10] *= 1.001;
  CHECK(mean_forces(problem.chain, wrong, orbit.period(), 1e-12).imbalance() > 1e-7);
  Chain free{21, None{}};
  CHECK(mean_forces(free, orbit.start, orbit.period(), 1e-12).imbalance() > 1e-4);
}

TEST_CASE("shooting by leapfrog has the exact derivative of its map", "[unit][orbits]") {
  LeapfrogShooting problem;
  problem.chain = walled<Harmonic>().first;
  problem.symmetry = travelling(6, 0, false);
  problem.omega = 1.3;
  Vector<double> x(12);
  x << 0.3, -0.2, 0.25, -0.3, 0.2, -0.1, 0.1, 0, -0.1, 0.05, 0, 0.1;
  const Evaluation<double> here = problem.evaluate(x);
  for (Eigen::Index k = 0; k < 12; ++k) {
    const Vector<double> h = 1e-6 * Vector<double>::Unit(12, k);
    const Vector<double> slope =
        (problem.evaluate(x + h, false).residual - problem.evaluate(x - h, false).residual) / 2e-6;
    CAPTURE(k);
    CHECK(sup<double>(slope - here.jacobian.col(k)) < 1e-4);
  }
}

namespace {

double push(double x, double power = 1.5) {
  return x > 0 ? std::pow(x, power) : 0;
}

/// Fourth-order steps of x' = rate(x).
template <class Rate>
std::vector<double> carried(std::vector<double> x, double time, int steps, Rate rate) {
  const double h = time / steps;
  const auto at = [&](double by, const std::vector<double>& k) {
    std::vector<double> z(x);
    for (std::size_t i = 0; i < z.size(); ++i) z[i] += by * k[i];
    return z;
  };
  for (int s = 0; s < steps; ++s) {
    const auto a = rate(x), b = rate(at(h / 2, a)), c = rate(at(h / 2, b)), e = rate(at(h, c));
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + e[i]);
  }
  return x;
}

}  // namespace

TEST_CASE("mean forces and what they leave, by hand", "[unit][mean_force]") {
  MeanForces means{{5, 2, 9, 4, 3}, {3.5, -7.25, 5, 0.5}, State<double>(4)};
  CHECK(means.spread(1, 3) == 7);
  CHECK(means.spread(3, 4) == 1);
  CHECK(means.spread(0, 1) == 3);
  check_close(means.imbalance(), 0.5, 1e-15);  // of the first and of the last
  means.well = {3, -7, 5, 3};
  check_close(means.imbalance(), 2, 1e-15);
  means.well = {3, -7, 4.25, 1};
  check_close(means.imbalance(), 0.75, 1e-15);
  CHECK(MeanForces{{2, 1}, {1}, State<double>(1)}.imbalance() == 0);
  // Two unequal beads between walls, each contact of its own kind
  const motions::MixedChain chain{2, {}, {1.3, 0.7}, {1.1, 0.9, 1.2}, {1.5, 1.7, 1.4}};
  const double y[] = {0.3, -0.2};
  check_close(motions::contact_push(chain, y, 1), 0.9 * std::pow(0.5, 1.7), 1e-15);
  CHECK(motions::contact_push(chain, y, 0) == 0);
  CHECK(motions::contact_push(chain, y, 2) == 0);
  const double other[] = {-0.3, 0.2};
  check_close(motions::contact_push(chain, other, 0), 1.1 * std::pow(0.3, 1.5), 1e-15);
  check_close(motions::contact_push(chain, other, 2), 1.2 * std::pow(0.2, 1.4), 1e-15);
  CHECK(motions::contact_push(chain, other, 1) == 0);
  State<double> start(2);
  start.t = 4, start.y = {0.3, -0.2}, start.v = {0.1, -0.05};
  const MeanForces walls = mean_forces(chain, start, 2, 1e-12);
  const auto rate = [](const std::vector<double>& x) {
    const double a = 1.1 * push(-x[0]), b = 0.9 * push(x[0] - x[1], 1.7), c = 1.2 * push(x[1], 1.4);
    return std::vector<double>{x[2], x[3], (a - b) / 1.3, (b - c) / 0.7, a, b, c};
  };
  const auto end = carried({0.3, -0.2, 0.1, -0.05, 0, 0, 0}, 2, 2000, rate);
  CHECK(walls.end.t == 6);
  for (std::size_t k = 0; k < 2; ++k) {
    check_close(walls.end.y[k], end[k], 1e-8);
    check_close(walls.end.v[k], end[2 + k], 1e-8);
    CHECK(walls.well[k] == 0);
  }
  for (std::size_t k = 0; k < 3; ++k) check_close(walls.contact[k], end[4 + k] / 2, 1e-8);
  // Wells pull as well
  const Chain held{1, Quartic{2}, Hertz{}, Ends::fixed};
  State<double> one(1);
  one.y = {0.4};
  const MeanForces pulled = mean_forces(held, one, 3, 1e-12);
  const auto hold = carried({0.4, 0, 0}, 3, 2000, [](const std::vector<double>& x) {
    const double pull = x[0] + 2 * x[0] * x[0] * x[0];
    return std::vector<double>{x[1], push(-x[0]) - push(x[0]) - pull, pull};
  });
  check_close(pulled.well[0], hold[2] / 3, 1e-8);
  check_close(pulled.end.v[0], hold[1], 1e-8);
}

TEST_CASE("a wave of a ring without wells moves on by one site", "[unit][orbits]") {
  using namespace motions;
  check_close(wave_amplitude(std::numbers::pi, 1.5), std::pow(0.457 * std::pow(2, 2.5), -2), 1e-15);
  check_close(wave_amplitude(std::numbers::pi / 3, 2), 1 / 0.457, 1e-12);
  // A wave moves on by one site in its period, and all 6 pi / N of its phase
  Shooting<double> problem;
  problem.chain = {9, None{}, Hertz{.floor = 0}, Ends::periodic};
  const Orbit<double> wave = ring_wave(problem);
  const double q = 6 * std::numbers::pi / 9;
  check_close(problem.omega, 2 * std::numbers::pi / q, 1e-13);
  std::vector<double> x(wave.start.y);
  x.insert(x.end(), wave.start.v.begin(), wave.start.v.end());
  const auto rate = [](const std::vector<double>& z) {
    std::vector<double> out(z.begin() + 9, z.end());
    for (std::size_t n = 0; n < 9; ++n)
      out.push_back(push(z[(n + 8) % 9] - z[n]) - push(z[n] - z[(n + 1) % 9]));
    return out;
  };
  x = carried(x, q, 800, rate);
  const double shift = x[1] - wave.start.y[0];
  CHECK(wave.amplitude > 0.1);
  for (std::size_t n = 0; n < 9; ++n) {
    check_close(x[(n + 1) % 9] - shift, wave.start.y[n], 1e-6 * wave.amplitude);
    check_close(x[9 + (n + 1) % 9], wave.start.v[n], 1e-6 * wave.amplitude);
  }
}
