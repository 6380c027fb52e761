#include "sec32/full_map.hpp"

namespace lattice {

FullMap solve_full_map(double omega_b, int steps, const NewtonRule<double>& how) {
  Shooting<double> problem = problem_of(Centre::site, omega_b);
  problem.symmetry = returning(problem.chain.sites);
  FullMap out;
  out.x = problem.reduce(ansatz(Centre::site, omega_b, problem.chain.sites));
  for (int k = 0; k <= steps; ++k) {
    const Evaluation<double> here = problem.evaluate(out.x, how.events);
    const Sizes<double> size = problem.sizes(out.x, false);
    const Vector<double> step = solve_scaled<double>(here.jacobian, here.residual, size, how.rank);
    out.soft = condition_of(here.jacobian);
    out.history.push_back({sup<double>(here.residual) / sup(out.x), sup(step) / sup(out.x)});
    if (k < steps) out.x -= step;
  }
  return out;
}

}  // namespace lattice
