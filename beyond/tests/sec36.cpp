// The breather of a light defect.

#include "lattice/integrators/event_corrected.hpp"
#include "sec36/defect_mode.hpp"
#include "support/check.hpp"

using namespace lattice;

namespace {

using Numbers = std::vector<double>;

const double half_turn = std::acos(-1.0);

}  // namespace

TEST_CASE("the mode of a light defect is a breather", "[property][cantilever]") {
  const CantileverArray array;
  const Shooting<double> problem = mode_problem(array, 0.925);
  const Orbit<double> orbit = mode_of_energy(problem, 1e-5);
  check_close(orbit.energy, 1e-5, 0, 1e-9);
  CHECK(orbit.residual() < 1e-12);
  CHECK(orbit.omega > array.linear_frequency(0.925));
  State<double> end = orbit.start;
  const double period = 2 * 3.141592653589793 / orbit.omega;
  evolve(EventCorrected{0.01}, problem.chain, end, period, period);
  for (std::size_t n = 0; n < mode_sites; ++n) {
    check_close(end.y[n], orbit.start.y[n], 1e-9);
    check_close(end.v[n], 0, 1e-9);
  }
  const auto e = energy_density(problem.chain, orbit.start);
  CHECK(e[mode_sites / 2] > 0.5 * orbit.energy);
  CHECK(e.front() < 1e-12 * orbit.energy);
}

TEST_CASE("the mode of a light defect by plain formulas", "[unit][cantilever]") {
  const CantileverArray array;
  const Shooting<double> problem = mode_problem(array, 0.9);
  CHECK((mode_sites == 31 && problem.chain.sites == 31));
  for (std::size_t n = 0; n < 31; ++n)
    check_close(problem.chain.mass_of(n), n == 15 ? array.mu(0.9) : 1, 1e-15);
  for (std::size_t i = 0; i <= 31; ++i)
    check_close(problem.chain.eta_of(i), i == 15 || i == 16 ? std::sqrt(1.8 / 1.9) : 1, 1e-15);
  CHECK(problem.chain.contact.force(-1e-100) > 0);
  const Orbit<double> orbit = mode_of_energy(problem, 2e-4);
  check_close(orbit.energy, 2e-4, 0, 2e-10);
  Shooting<double> there = problem;
  there.omega = orbit.omega;
  check_close(newton(there, orbit.x).energy, 2e-4, 0, 1e-9);
  CHECK(orbit.start.y[15] > 0);
  CHECK_THROWS_AS(mode_of_energy(problem, 1e-40), std::runtime_error);

  Numbers mean(31, 0);
  State<double> now = orbit.start;
  for (int k = 0; k <= 5; ++k) {
    const Numbers e = energy_density(problem.chain, now);
    for (std::size_t n = 0; n < 31; ++n) mean[n] += e[n] / 6;
    evolve(EventCorrected{0.05}, problem.chain, now, 2 * half_turn / orbit.omega / 5, 9);
  }
  const Numbers found = mean_density(problem, orbit, 5);
  for (std::size_t n = 0; n < 31; ++n) check_close(found[n], mean[n], 1e-13);
}
