#include "sec5/branches_in_s.hpp"

#include <cmath>
#include <numbers>

namespace lattice {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;
constexpr Stride in_s{.first = 0.02, .least = 1e-6, .most = 0.25};

Place place(const Branch<double>& branch) {
  const Shooting<double> problem = branch.problem();
  const Vector<double> x = branch.unknowns();
  return {problem.chain.well.as<Quartic>().s, x[x.size() - 1] / two_pi,
          energy(problem.chain, problem.expand(x))};
}

}  // namespace

Branch<double> branch_from(const Orbit<double>& start, int direction) {
  const Shooting<double> problem = with_free_time(travelling_problem(shift_time(start)));
  const Orbit<double> orbit = newton(problem, with_time(start.x, shift_time(start)));
  return {problem, along_s<double>(), orbit, direction, {}, in_s};
}

std::vector<Place> follow_branch(const Orbit<double>& start, int direction, int steps) {
  Branch<double> branch = branch_from(start, direction);
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
