#include "sec33/uncorrected.hpp"

#include <limits>

#include "lattice/gsl/reference.hpp"

namespace lattice {

UncorrectedEnd uncorrected_newton(const Shooting<double>& problem, const State<double>& start,
                                  double tolerance) {
  Vector<double> x = problem.reduce(start);
  const Matrix<double> matrix = problem.shoot(x, {}).jacobian;
  const Sizes<double> size = problem.sizes(x, false);
  const Tolerance both(0.01 * tolerance, tolerance, gsl_odeiv2_step_rk8pd);
  double residual = 0;
  for (int k = 0; k < 6; ++k) {
    const State<double> begin = problem.expand(x);
    State<double> end = begin;
    evolve_reference(problem.chain, end, problem.period() / problem.symmetry.parts, both);
    const Vector<double> left = problem.residuals(begin, end);
    residual = sup(left) / largest(begin);
    x -= solve_scaled<double>(matrix, left, size, 0);
  }
  return {energy(problem.chain, problem.expand(x)), residual};
}

// With an infinite `negligible` no contact is corrected. Samples at whole eighths of a period see the same phases again
// and again, the others (creep_sample) all of them
Creep StepTrial::path(const RestingBreather& at, double time) const {
  const double step = at.period / steps;
  const ContactAware blind{.step = step,
                           .base = classical_runge_kutta(),
                           .negligible = std::numeric_limits<double>::infinity()};
  const double sample = commensurate ? at.period / 8 : creep_sample(at.period);
  return creep(corrected ? fourteen_stages(step) : blind, at.chain, kicked(at.rest, c), sample,
               time);
}

}  // namespace lattice
