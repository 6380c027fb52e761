#pragma once
#include "lattice/orbits/newton.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <type_traits>

#include "lattice/numerics/progress.hpp"

namespace lattice {

template <class T>
T sup(const Vector<T>& x) {
  T most(0);
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (!(magnitude(x[i]) < std::numeric_limits<T>::infinity()))
      return std::numeric_limits<T>::infinity();
    most = std::max(most, magnitude(x[i]));
  }
  return most;
}

template <class T>
Vector<T> solve_system(const Matrix<T>& matrix, const Vector<T>& right, double rank, double scale) {
  if (matrix.rows() == matrix.cols() && rank <= 0) return solve_square(matrix, right);
  if constexpr (std::is_floating_point_v<T>)
    return shortest_solution(matrix, right, rank, scale);
  else
    throw std::logic_error("this number type solves only as many equations as unknowns");
}

// Measured by its own size, the tail of a breather counts as much as its centre
template <class T>
Vector<T> solve_scaled(Matrix<T> matrix, Vector<T> right, const Sizes<T>& size, double rank,
                       double scale) {
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index k = 0; k < matrix.cols(); ++k)
      matrix(i, k) *= size.unknown[k] / size.equation[i];
    right[i] /= size.equation[i];
  }
  return solve_system<T>(matrix, right, rank, scale).cwiseProduct(size.unknown);
}

namespace {

/// The exception that names the equations and what went wrong.
template <class T>
NewtonFailed failure(const Equations<T>& equations, const std::string& why,
                     const Solution<T>& so_far) {
  return {equations.name + ": " + why, so_far.history};
}

/// What is shown of an iteration: how many went before, and the residual they left.
std::string iteration_label(int i, double residual) {
  const std::string number = "Newton step " + std::to_string(i + 1);
  return i == 0 ? number : number_label(number + ", residual", residual);
}

/// Throws NewtonFailed if the unknowns `x` are close to rest, a periodic orbit of any frequency, or far beyond the
/// guess, where the flow over one period would take for ever.
template <class T>
void refuse_size(const Equations<T>& equations, const Vector<T>& guess, const Vector<T>& x,
                 const Solution<T>& so_far) {
  if (!equations.amplitude) return;
  const T begin = equations.amplitude(guess), now = equations.amplitude(x);
  const bool rests = equations.reach && equations.reach(x) <= T(1e-6) * equations.reach(guess);
  if (!rests && !(now > T(30) * begin)) return;
  char why[80];
  std::snprintf(why, sizeof why, "the iterate %s, from size %.2g to %.2g",
                rests ? "shrinks to rest" : "grows far beyond the guess",
                double(rests ? equations.reach(guess) : begin),
                double(rests ? equations.reach(x) : now));
  throw failure(equations, why, so_far);
}

/// The residual of the worst equation, each in its own unit.
template <class T>
T relative_residual(const Equations<T>& equations, const Evaluation<T>& at, const Vector<T>& x,
                    const NewtonRule<T>& rule) {
  return sup<T>(at.residual.cwiseQuotient(equations.sizes(x, rule.scaled).equation));
}

/// The largest sum of moduli in a row of the derivative, in the units of unknowns and equations; zero in the local ones of a
/// tail.
template <class T>
T norm_of(const Equations<T>& equations, const Matrix<T>& derivative, const Vector<T>& x,
          const NewtonRule<T>& rule) {
  T most(0);
  if (rule.scaled) return most;
  const Sizes<T> size = equations.sizes(x, false);
  for (Eigen::Index i = 0; i < derivative.rows(); ++i) {
    T sum(0);
    for (Eigen::Index k = 0; k < derivative.cols(); ++k)
      sum += magnitude(derivative(i, k)) * size.unknown[k];
    most = std::max(most, T(sum / size.equation[i]));
  }
  return most;
}

/// The share of the step to be taken from the best point so far, the largest power of 1/2 that lowers the residual;
/// throws NewtonFailed below a thousandth.
template <class T>
T damping(const Equations<T>& equations, const Vector<T>& step, const T& last,
          const Solution<T>& best, const NewtonRule<T>& rule) {
  for (T share(1); share > T(1e-3); share /= T(2)) {
    const Vector<T> trial = best.x - share * step;
    const Evaluation<T> at = equations.evaluate(trial, rule.events, false);
    if (relative_residual(equations, at, trial, rule) < last) return share;
  }
  throw failure(equations, "no Newton step lowers the residual", best);
}

}  // namespace

// x <- x - f'(x)^-1 f(x), with a record of all that was tried
template <class T>
Solution<T> newton(const Equations<T>& equations, Vector<T> x, const NewtonRule<T>& rule,
                   const Matrix<T>* derivative) {
  Solution<T> best{x, {}, {}};
  const Vector<T> guess = x;
  T last = std::numeric_limits<T>::infinity(), least(0);
  for (int i = 0; i <= rule.most_steps; ++i) {
    const Progress progress(iteration_label(i, double(last)));
    refuse_size(equations, guess, x, best);
    // By how much does the orbit from here fail to close?
    const bool fresh = !derivative && !(last < T(rule.reuse_below));
    Evaluation<T> at = equations.evaluate(x, rule.events, fresh);
    if (!fresh) at.jacobian = derivative ? *derivative : best.evaluation.jacobian;
    const T residual = relative_residual(equations, at, x, rule);
    best.history.push_back({double(residual), 0});
    if (!(residual < T(rule.scaled ? 1e300 : 1e3)))
      throw failure(equations, "Newton's method diverges", best);
    // Keep the better point, and stop once rounding keeps a small residual from falling further
    const bool small = last <= least, better = residual < last;
    if (better || !small) best.evaluation = std::move(at), best.x = x;
    if (small && !(residual < last / T(4))) {
      if (!better) best.history.pop_back();
      if (is_accurate(best.evaluation.flow, rule.events)) return best;
      // Where beads move alike the derivative suffers from rounding, and the orbit does not
      best.evaluation.flow = equations.evaluate(best.x, rule.events, false).flow;
      if (is_accurate(best.evaluation.flow, rule.events)) return best;
      throw failure(equations, "the integration is not accurate enough for a periodic orbit", best);
    }
    // Step on, with care as long as the orbit is far away
    last = residual;
    const Vector<T> step = solve_scaled<T>(best.evaluation.jacobian, best.evaluation.residual,
                                           equations.sizes(x, true), rule.rank, rule.scale),
                    unit = equations.sizes(x, rule.scaled).unknown;
    best.history.back().step = double(sup<T>(step.cwiseQuotient(unit)));
    least = rule.converged_below(norm_of(equations, best.evaluation.jacobian, best.x, rule));
    const bool far = last > least;
    x -= (rule.damped && far ? damping(equations, step, last, best, rule) : T(1)) * step;
  }
  throw failure(equations, "Newton's method does not converge", best);
}

}  // namespace lattice

/// The functions of this file in a number type.
#define LATTICE_NEWTON(T)                                                                    \
  template T sup<T>(const Vector<T>&);                                                       \
  template Vector<T> solve_system<T>(const Matrix<T>&, const Vector<T>&, double, double);    \
  template Vector<T> solve_scaled<T>(Matrix<T>, Vector<T>, const Sizes<T>&, double, double); \
  template Solution<T> newton<T>(const Equations<T>&, Vector<T>, const NewtonRule<T>&,       \
                                 const Matrix<T>*);
