#pragma once
/**
# Newton's method

To find $x$ with $f(x) = 0$, Newton's method repeats $x \leftarrow x - f'(x)^{-1} f(x)$ from a guess; once
it is close, each step doubles the number of correct digits. Here $x$ is the initial state of a periodic
orbit, as far as it is unknown, and $f$ says by how much the orbit fails to close (symmetry.hpp).

The same code serves every periodic orbit, because it knows only *problems*: objects that turn a vector of
unknowns into residuals and their derivatives, and that say how large unknowns and equations are. This
file holds the method, its history and its failures; shooting.hpp makes a problem of a chain.

A problem `P` has

| member | meaning |
|---|---|
| `P::Scalar` | the number type |
| `shoot(x, landing, with_jacobian)` | a `Shot`: residuals, derivatives, report of the integrator |
| `sizes(x, graded)` | the units in which unknowns and equations are measured |
| `name()` | what is looked for, for messages | */

#include <Eigen/Dense>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "lattice/landing/landing.hpp"
#include "lattice/numbers/dense.hpp"

namespace lattice {

/// The largest modulus in a vector; infinite if any entry is not a finite number.
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

/**
Newton's method learns about a problem from one integration at a time, a shot. It tells by how much the
equations are missed, how that depends on the unknowns, and how accurate the flow was (landing.hpp). */
template <class T>
struct Shot {
  Vector<T> miss, miss_period;  ///< residuals and their derivative with respect to the period
  Matrix<T> jacobian;           ///< with respect to the unknowns; empty if it was not asked for
  Flow<T> flow;
};

/// The units of unknowns and of equations.
template <class T>
struct Sizes {
  Vector<T> unknown, equation;
};

/**
## A step

Each step solves a linear system, and its numbers differ vastly: the tail of a breather falls
double-exponentially, $|y_{n+1}|\sim|y_n|^{3/2}$, and its equations are as small as its positions. If each
unknown and each equation is measured in units of the local size (`Sizes`), elimination finds every
position to the same relative accuracy.

If there are as many equations as unknowns the system is solved as it stands. Otherwise, or if the problem
leaves a direction free, the step is the shortest one that solves the equations in the sense of least
squares. A direction counts as free if its singular value, relative to the largest, is below `rank`, if
that is positive. Least squares need a built-in type; others throw std::logic_error. */
template <class T>
Vector<T> solve_system(const Matrix<T>& matrix, const Vector<T>& right, double rank = 0) {
  if (matrix.rows() == matrix.cols() && rank <= 0) return solve_square(matrix, right);
  if constexpr (std::is_floating_point_v<T>) {
    Eigen::CompleteOrthogonalDecomposition<Matrix<T>> shortest;
    if (rank > 0) shortest.setThreshold(T(rank));
    return shortest.compute(matrix).solve(right);
  } else {
    throw std::logic_error("this type solves as many equations as unknowns, no others");
  }
}

/// The step x with matrix * x = right, computed in the units of `size` and returned in those of `matrix`
/// and `right`.
template <class T>
Vector<T> solve_scaled(Matrix<T> matrix, Vector<T> right, const Sizes<T>& size, double rank) {
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index k = 0; k < matrix.cols(); ++k)
      matrix(i, k) *= size.unknown[k] / size.equation[i];
    right[i] /= size.equation[i];
  }
  return solve_system<T>(matrix, right, rank).cwiseProduct(size.unknown);
}

/**
## History and failure

A result that has not converged must not leave a program unnoticed, so every iteration is recorded.
Residual and step are relative to the amplitude of the orbit, or, if `graded`, to the local size, so that
the tail has to converge as well as the centre. */
struct Iteration {
  double residual, step;
};
using History = std::vector<Iteration>;

inline std::string to_text(const History& history) {
  std::string text;
  for (const Iteration& i : history) {
    char buffer[48];
    std::snprintf(buffer, sizeof buffer, "%s%.1e", text.empty() ? "" : ", ", i.residual);
    text += buffer;
  }
  return text;
}

/**
If the method fails, the residuals of all iterations are in the message: they tell whether the guess was
bad, the flow inaccurate, or the branch at its end. */
struct NoConvergence : std::runtime_error {
  History history;
  NoConvergence(const std::string& what, History steps)
      : std::runtime_error(what + "; relative residuals " + to_text(steps)),
        history(std::move(steps)) {}
};

/// How Newton's method proceeds and when it stops.
template <class T>
struct NewtonRule {
  Landing<T> landing{};
  int most = 30;        ///< iterations
  bool graded = false;  ///< demand relative accuracy of every site
  bool damped = false;  ///< halve a step until it lowers the residual
  double rank = 0;      ///< see solve_system
  /// A residual below which the method may stop, as soon as the residual no longer falls. A shot of many
  /// steps misses by some multiple of the tolerance of one; relative to the local size, in the tail, by
  /// a thousand times more.
  T enough() const { return T(graded ? 65536 : 64) * landing.tolerance; }
};

/**
An orbit is no better than the flow from which it was computed. Every step of the integrator estimates its
own error. If one could not meet the tolerance, or if a contact that matters opened or closed in the middle
of a step (`unlanded`), the residual means nothing and the orbit is refused. */
template <class T>
bool is_accurate(const Flow<T>& flow, const Landing<T>& landing) {
  const T tolerance = std::max(landing.tolerance, T(16) * std::numeric_limits<T>::epsilon());
  return flow.unlanded == 0 && flow.error <= tolerance * T(double(flow.steps + 1));
}

/// Where the iteration ended: unknowns, the shot from there, and all iterations.
template <class T>
struct Solution {
  Vector<T> x;
  Shot<T> shot;
  History history;
};

/// The exception that names the problem and what went wrong.
template <class Problem, class T>
NoConvergence failure(const Problem& problem, const std::string& why, const Solution<T>& so_far) {
  return {problem.name() + ": " + why, so_far.history};
}

/// The solution, if its flow was accurate; throws NoConvergence otherwise.
template <class Problem, class T>
Solution<T> accepted(const Problem& problem, Solution<T> found, const NewtonRule<T>& rule) {
  if (is_accurate(found.shot.flow, rule.landing)) return found;
  throw failure(problem, "the integration is not accurate enough for an orbit", found);
}

/**
The residual is that of the worst equation, each in its own unit. Far from any orbit a full step may lead
even farther away. A damped iteration tries the step, its half, its quarter and so on until the residual
falls, and gives up below a thousandth of the step. */
template <class Problem, class T>
T residual_of(const Problem& problem, const Shot<T>& shot, const Vector<T>& at,
              const NewtonRule<T>& rule) {
  return sup<T>(shot.miss.cwiseQuotient(problem.sizes(at, rule.graded).equation));
}

/// The share of the step to be taken from the best point so far; throws NoConvergence if none helps.
template <class Problem, class T>
T damping(const Problem& problem, const Vector<T>& step, const T& last, const Solution<T>& best,
          const NewtonRule<T>& rule) {
  for (T share(1); share > T(1e-3); share /= T(2)) {
    const Vector<T> trial = best.x - share * step;
    const Shot<T> shot = problem.shoot(trial, rule.landing, false);
    if (residual_of(problem, shot, trial, rule) < last) return share;
  }
  throw failure(problem, "no step lowers the residual", best);
}

/**
## The iteration

Now everything is put together. `direction` gives the step from a shot: `solve`, below, uses the exact
derivative, `polish` of shooting.hpp one that was computed before. We stop when the residual is small and
no longer falls by a factor of four, and keep the better of the last two points; rounding then forbids
more. Anything else is a failure. Throws NoConvergence. */
template <class Problem, class T, class Direction>
Solution<T> iterate(const Problem& problem, Vector<T> x, const NewtonRule<T>& rule, bool jacobian,
                    Direction direction) {
  Solution<T> best{x, {}, {}};
  T last = std::numeric_limits<T>::infinity();
  for (int i = 0; i <= rule.most; ++i) {
    Shot<T> shot = problem.shoot(x, rule.landing, jacobian);
    const T residual = residual_of(problem, shot, x, rule);
    best.history.push_back({double(residual), 0});
    if (!(residual < T(rule.graded ? 1e300 : 1e3)))
      throw failure(problem, "Newton runs away", best);
    const bool small = last <= rule.enough(), better = residual < last;
    if (better || !small) best.shot = std::move(shot), best.x = x;
    if (small && !(residual < last / T(4))) {
      if (!better) best.history.pop_back();
      return accepted(problem, std::move(best), rule);
    }
    last = residual;
    const Vector<T> step = direction(best.shot, x), unit = problem.sizes(x, rule.graded).unknown;
    best.history.back().step = double(sup<T>(step.cwiseQuotient(unit)));
    x -= (rule.damped && last > rule.enough() ? damping(problem, step, last, best, rule) : T(1)) *
         step;
  }
  throw failure(problem, "Newton does not converge", best);
}

/**
The plain method uses the derivative at each point. `solve` returns the solution near the guess `x`, or
throws NoConvergence, with the history. */
template <class Problem, class T = typename Problem::Scalar>
Solution<T> solve(const Problem& problem, const Vector<T>& x, const NewtonRule<T>& rule = {}) {
  return iterate(problem, x, rule, true, [&](const Shot<T>& shot, const Vector<T>& at) {
    return solve_scaled<T>(shot.jacobian, shot.miss, problem.sizes(at, true), rule.rank);
  });
}

}  // namespace lattice
