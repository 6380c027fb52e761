#include "sec5/branches_in_s.hpp"

#include <cmath>
#include <numbers>

namespace lattice {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

Place place(const Branch& branch) {
  const Shooting<double> problem = branch.problem();
  const Vector<double> x = branch.unknowns();
  return {problem.chain.well.as<Quartic>().s, x[x.size() - 1] / two_pi,
          energy(problem.chain, problem.expand(x))};
}

}  // namespace

Branch branch_in_s(const Orbit<double>& start, int direction, double longest) {
  const double time = shift_time(start);
  const auto problem = with_free_time(travelling_problem(time, 0, start.start.y.size() / 2 - 1));
  const Orbit<double> orbit = newton(problem, with_time(start.x, time));
  const Stride stride{.first = 0.02, .least = 1e-6, .most = longest};
  return {problem, along_s<double>(), orbit, direction, {}, stride};
}

std::vector<Place> follow_branch(const Orbit<double>& start, int direction, int steps) {
  Branch branch = branch_in_s(start, direction);
  std::vector<Place> way{place(branch)};
  try {
    for (int i = 0; i < steps; ++i) {
      branch.advance();
      way.push_back(place(branch));
      if (std::abs(way.back().s) > 3 || way.back().turns < 0.5) break;
    }
  } catch (const NewtonFailed&) {
    // the branch is shown up to there
  }
  return way;
}

}  // namespace lattice
