// Branches of breathers: slopes along them, folds, other parameters, and paths to other chains.

#include "lattice/orbits/continuation.hpp"

#include "sec3/article_chains.hpp"
#include "support/check.hpp"
#include "support/return_error.hpp"

using namespace lattice;

using Problem = Shooting<double>;

TEST_CASE("along a branch dE = dA / T, and the slopes are exact", "[property][periodic]") {
  const struct {
    Centre centre;
    double omega, s, mass;  // of the bead in the middle
  } rows[] = {
      {Centre::site, 1.02, 0, 1}, {Centre::site, 1.3, 0.5, 1.05}, {Centre::bond, 1.1, -0.2, 1}};
  for (const auto& [centre, omega, s, mass] : rows) {
    CAPTURE(omega, s);
    const double h = 1e-4 * (omega - 1);
    Problem problem = problem_of(centre, omega, s);
    std::vector<double> masses(problem.chain.sites, 1);
    masses[masses.size() / 2] = mass;
    if (mass != 1) vary(problem.chain, masses, {});
    const auto at = [&](double frequency) {
      Problem there = problem;
      there.omega = frequency;
      return find_breather(there);
    };
    const auto up = at(omega + h), down = at(omega - h), here = at(omega);
    check_close((up.energy - down.energy) / (2 * h), here.energy_omega, 0, 1e-6);
    check_close((up.energy - down.energy) / (up.action_integral - down.action_integral),
                1 / problem.period(), 0, 1e-6);
    const Vector<double> slope = (up.x - down.x) / (2 * h);
    CHECK(sup<double>(slope - here.x_omega) < 1e-5 * sup<double>(slope));
  }
}

TEST_CASE("a breather does not depend on how it was reached", "[property][periodic]") {
  for (Centre centre : both_centres) {
    const auto p = problem_of(centre, 1.1, 0.5);
    const Orbit<double> direct = find_breather(p);
    const auto low = problem_of(centre, 1.03, 0.5), linear = problem_of(centre, 1.1, 0);
    Branch rising(low, along_omega<double>(), find_breather(low), 1);
    Branch hardening(linear, along_s<double>(), find_breather(linear), 1);
    for (const Orbit<double>& other : {rising.orbit_at(1.1), hardening.orbit_at(0.5)}) {
      CHECK(sup<double>(other.x - direct.x) < 1e-12 * direct.amplitude);
      check_close(other.energy, direct.energy, 0, 1e-12);
    }
  }
}

TEST_CASE("a branch passes its fold, beyond which there is no breather", "[property][periodic]") {
  const auto p = problem_of(Centre::bond, 1.6, -1);
  const Orbit<double> start = find_breather(p);
  Branch branch(p, along_omega<double>(), start, 1);
  const double turn = branch.fold();
  CHECK(branch.slope() < 0);
  const Estimate fold =
      fold_of({p, along_omega<double>(), start, 1, {}, {.first = 0.05, .most = 0.2}});
  CAPTURE(turn, fold.value, fold.error);
  CHECK((fold.value > 1.6 && fold.value < 1.65));
  CHECK(fold.error < 1e-5);
  check_close(turn, fold.value, 1e-5);
  CHECK_THROWS_AS(find_breather(problem_of(Centre::bond, fold.value + 1e-3, -1)), NoBranch);
  CHECK(find_breather(problem_of(Centre::bond, fold.value - 1e-3, -1)).amplitude > start.amplitude);
}

TEST_CASE("a branch follows any parameter, here to a breather without mirror symmetry",
          "[property][orbits]") {
  // The bead beside the centre is made heavier
  Problem problem = breather_problem(Centre::site, 1.1, 0, 21);
  const Orbit<double> plain = find_breather(problem);
  problem.symmetry = even_in_time(21);
  const auto set = [](Problem& p, const double& m) {
    std::vector<double> masses(21, 1);
    masses[11] = m;
    vary(p.chain, masses, {});
  };
  set(problem, 1);
  const Along<double> mass{"mass", [](const Problem& p) { return p.chain.mass_of(11); }, set, 1e-5};
  Branch branch(problem, mass, newton(problem, problem.reduce(plain.start)), 1, {},
                {.first = 1e-3, .least = 1e-7, .most = 0.05});
  for (int k = 0; k < 12; ++k) branch.advance();
  problem = branch.problem();
  const Orbit<double> orbit = newton(problem, branch.unknowns());
  CHECK(return_error(problem, orbit) < 1e-11);
  CHECK(std::abs(orbit.start.y[11] - orbit.start.y[9]) > 1e-2 * orbit.amplitude);
}

TEST_CASE("a path in the exponent ends at the breather of the ansatz", "[property][chains]") {
  for (Centre centre : both_centres) {
    const Problem spheres = problem_of(centre, 1.1);
    Problem other = spheres;
    other.chain.contact = PowerContact{1.75};
    const Orbit<double> followed = continue_to(spheres, find_breather(spheres), other.chain);
    const Orbit<double> direct = find_breather(other);
    CHECK(sup<double>(followed.x - direct.x) < 1e-12 * direct.amplitude);
    CHECK_THROWS_AS(continue_to(spheres, direct, Chain{35}), std::invalid_argument);
  }
}
