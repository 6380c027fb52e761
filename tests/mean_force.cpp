// The mean contact force of periodic motions, and shooting by leapfrog steps.

#include "sec2/mean_force.hpp"
#include "check.hpp"
#include "lattice/gsl/random.hpp"
#include "lattice/orbits/breather.hpp"
#include "sec2/fixed_leapfrog.hpp"

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
  const Shot<double> shot = problem.shoot(x, {});
  for (Eigen::Index k = 0; k < 12; ++k) {
    const Vector<double> h = 1e-6 * Vector<double>::Unit(12, k);
    const Vector<double> slope =
        (problem.shoot(x + h, {}, false).miss - problem.shoot(x - h, {}, false).miss) / 2e-6;
    CAPTURE(k);
    CHECK(sup<double>(slope - shot.jacobian.col(k)) < 1e-4);
  }
}
