// Orbits against what defines them, on short chains: the second half of formulas.cpp.

#include "commands/one_barrier.hpp"
#include "lattice/orbits/breather.hpp"
#include "lattice/standing/stationary.hpp"
#include "support/check.hpp"

using namespace lattice;

TEST_CASE("quasi-continuum profiles by hand", "[unit][formulas]") {
  const auto g = [](double x) { return 0.027 * std::pow(std::cos(x / 3), 6); };
  for (long n = -3; n <= 3; ++n) {
    CAPTURE(n);
    const double sign = n % 2 == 0 ? 1 : -1;
    check_close(quasi_continuum(Centre::bond, n), sign * (g(double(n)) + g(double(n) - 1)), 1e-15);
    check_close(quasi_continuum(Centre::site, n), sign * (g(double(n) + 0.5) + g(double(n) - 0.5)),
                1e-15);
  }
  CHECK(quasi_continuum(Centre::bond, 6) == 0);
  // With alpha = 2 the envelope is cos^4(x/2)/9, and the first harmonic of the force is 4/(3 pi)
  const auto h = [](double x) { return std::pow(std::cos(x / 2), 4) / 9; };
  check_close(quasi_continuum(Centre::bond, 1, 2), -h(1) - h(0), 1e-15);
  check_close(quasi_continuum(Centre::site, 2, 2), h(2.5) + h(1.5), 1e-15);
  CHECK(quasi_continuum(Centre::bond, 5, 2) == 0);
  const auto guess = ansatz(Centre::bond, 1.1, 8, Phase::compressed, PowerContact{2});
  check_close(guess.y[3], 0.15 * M_PI * (h(0) + h(1)), 1e-14);
}

TEST_CASE("stationary states solve their equation on short chains", "[unit][formulas]") {
  for (Centre centre : {Centre::site, Centre::bond}) {
    const std::size_t sites = centre == Centre::site ? 9 : 10;
    const auto state = stationary<double>(centre, 2, sites);
    const auto pull = [&](std::size_t i) {
      if (i == 0 || i == sites) return 0.0;
      const double r = state.u[i] - state.u[i - 1];
      return r * std::sqrt(std::abs(r));
    };
    for (std::size_t i = 0; i < sites; ++i)
      check_close(2 * state.u[i], pull(i) - pull(i + 1), 0, 1e-12);
    CHECK(state.history.size() < 30);
    for (std::size_t i = 0; i < sites; ++i)
      check_close(state.u[i], 4 * quasi_continuum(centre, site_number(i, sites)), 0.015);
  }
}

TEST_CASE("the approximate breather is close to the breather", "[unit][formulas]") {
  for (Centre centre : {Centre::site, Centre::bond})
    for (Phase phase : {Phase::compressed, Phase::stretched}) {
      const std::size_t sites = centre == Centre::site ? 9 : 10;
      const auto problem = breather_problem(centre, 1.01, 0, sites);
      const auto guess = ansatz(centre, 1.01, sites, phase);
      const auto orbit = find_breather(problem, phase);
      for (std::size_t n = 0; n < sites; ++n)
        check_close(guess.y[n], orbit.start.y[n], 0.1 * orbit.amplitude);
    }
}

TEST_CASE("energy, area and frequency of a breather belong together", "[unit][formulas]") {
  for (Centre centre : {Centre::site, Centre::bond})
    for (double s : {-0.2, 0.5}) {
      const std::size_t sites = centre == Centre::site ? 7 : 8;
      CAPTURE(int(centre), s);
      const auto problem = breather_problem(centre, 1.3, s, sites);
      const auto orbit = find_breather(problem);
      auto end = orbit.start;
      const auto whole = flow(problem.chain, end, 2 * M_PI / 1.3);
      for (std::size_t n = 0; n < sites; ++n) {
        check_close(end.y[n], orbit.start.y[n], 1e-11 * orbit.amplitude);
        check_close(end.v[n], 0, 1e-11 * orbit.amplitude);
      }
      check_close(orbit.area, whole.area, 0, 1e-11);
      check_close(orbit.energy, energy(problem.chain, orbit.start), 0, 1e-14);
      const auto up = find_breather(breather_problem(centre, 1.3 + 1e-4, s, sites));
      const auto down = find_breather(breather_problem(centre, 1.3 - 1e-4, s, sites));
      check_close(orbit.energy_omega, (up.energy - down.energy) / 2e-4, 0, 1e-5);
      check_close(up.area - down.area, problem.period() * (up.energy - down.energy), 0, 1e-5);
      for (Eigen::Index k = 0; k < orbit.x.size(); ++k)
        check_close(orbit.x_omega[k], (up.x[k] - down.x[k]) / 2e-4, 1e-4 * orbit.amplitude);
      CHECK(orbit.iterations() < 12);
    }
}

TEST_CASE("the equations' derivatives by difference quotients", "[unit][formulas]") {
  for (Centre centre : {Centre::site, Centre::bond}) {
    const auto problem = breather_problem(centre, 1.2, 0.3, centre == Centre::site ? 7 : 8);
    const auto orbit = find_breather(problem);
    const auto here = problem.evaluate(orbit.x, {});
    auto faster = problem, slower = problem;
    faster.omega += 1e-5;
    slower.omega -= 1e-5;
    const Vector<double> slope = (faster.evaluate(orbit.x, {}, false).residual -
                                  slower.evaluate(orbit.x, {}, false).residual) /
                                 2e-5;
    CHECK(sup<double>(slope + problem.period() / problem.omega * here.residual_period) <
          1e-6 * orbit.amplitude);
    const double h = 1e-7 * orbit.amplitude;
    for (Eigen::Index k = 0; k < orbit.x.size(); ++k)
      CHECK(sup<double>(slope_along(problem, orbit.x, k, h) - here.jacobian.col(k)) < 1e-3);
  }
}

TEST_CASE("barriers compare what they say", "[unit][formulas]") {
  const auto at_site = breather_problem(Centre::site, 1.2, 0, 9);
  const auto at_bond = breather_problem(Centre::bond, 1.2, 0, 10);
  const auto site = find_breather(at_site), bond = find_breather(at_bond);
  const auto gap = barrier(at_site, site, bond);
  check_close(gap.equal_frequency, site.energy - bond.energy, 1e-16);
  auto moved = at_site;
  moved.omega = gap.omega_site;
  const auto same_area = newton(moved, site.x);
  check_close(same_area.area, bond.area, 0, 1e-9);
  check_close(gap.equal_area, same_area.energy - bond.energy,
              1e-12 + 1e-3 * std::abs(gap.equal_area));
}

TEST_CASE("a barrier at equal area needs more than one correction", "[property][formulas]") {
  // By breathers whose frequency a program of its own changed until the areas were equal
  struct {
    double omega, s, alpha, gap, known;
  } const cases[] = {{2, 1, 1.5, 0.0836230857106, 1e-12},
                     {2, 10, 1.5, 0.0588436529162, 1e-12},
                     {1.0035344741615633, 0, 2.8123385152184204, -2.86308885458e-08, 1e-18}};
  for (const auto& [omega, s, alpha, gap, known] : cases) {
    OneBarrier command;
    command.omega_b = omega, command.well = Quartic{s};
    if (alpha != 1.5) command.like.contact = PowerContact{alpha};
    CAPTURE(omega, s, alpha);
    const Estimate found = command.find().equal_area;
    check_close(found.value, gap, known + found.error);
    CHECK(found.error < 1e-7 * std::abs(gap));
  }
}
