#pragma once
/**
# Newton's method

One Newton serves every periodic orbit, because it knows only problems: something that turns a
vector of unknowns into the residuals of its equations and their derivatives, and that says how
large unknowns and equations are. This file holds the method, its history and its failures; what
a problem is in a chain is told in shooting.hpp.

A problem `P` has

| member | meaning |
|---|---|
| `P::Scalar` | the number type |
| `shoot(x, landing, with_jacobian)` | a `Shot`: residuals, derivatives, what the integrator says |
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

namespace lattice {

template <class T>
using Vector = Eigen::Matrix<T, Eigen::Dynamic, 1>;
template <class T>
using Matrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;

/// The largest modulus in a vector; infinite where anything is not a number.
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
Newton learns about a problem from one integration at a time. It says by how much the equations are
missed, how that depends on the unknowns, and how accurate the flow was. */
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

The tail of a breather falls double-exponentially, and an equation of the tail is smaller than one
of the centre by as many orders of magnitude as the positions are. With each unknown and each
equation in units of the local size, elimination keeps every position to the same relative
accuracy.

As many equations as unknowns are solved as they are. Otherwise, or where the problem leaves some
direction free (`rank` > 0, the singular values below which a direction counts as free), the step is
the shortest one that solves them in the sense of least squares. */
template <class T>
Vector<T> solve_system(const Matrix<T>& matrix, const Vector<T>& right, double rank = 0) {
  if (matrix.rows() == matrix.cols() && rank <= 0) return matrix.partialPivLu().solve(right);
  if constexpr (std::is_floating_point_v<T>) {
    Eigen::CompleteOrthogonalDecomposition<Matrix<T>> shortest;
    if (rank > 0) shortest.setThreshold(T(rank));
    return shortest.compute(matrix).solve(right);
  } else {
    throw std::logic_error("this type solves as many equations as unknowns, no others");
  }
}

/// The step in the units of `size`; `matrix` and `right` come as they are.
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

Residual and step are relative to the orbit's amplitude, or with `graded` to the local size, so that
convergence is demanded of the tail as of the centre. */
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
Where the method fails, the residuals of all iterations are the message: they tell a bad guess from
an inaccurate flow or a branch that ends. */
struct NoConvergence : std::runtime_error {
  History history;
  NoConvergence(const std::string& what, History steps)
      : std::runtime_error(what + "; relative residuals " + to_text(steps)),
        history(std::move(steps)) {}
};

template <class T>
struct NewtonRule {
  Landing<T> landing{};
  int most = 30;        ///< iterations
  bool graded = false;  ///< demand relative accuracy of every site
  bool damped = false;  ///< halve a step until it lowers the residual
  double rank = 0;      ///< see solve_scaled
  /// A residual below which Newton may stop, as soon as it no longer falls.
  T enough() const { return T(graded ? 65536 : 64) * landing.tolerance; }
};

/**
An orbit is no better than the flow on which it stands. Every step of the integrator estimates its
own error; where one could not meet the tolerance, or a contact that matters switched in the middle
of a step, the residual means nothing and the orbit is refused. With a floor of zero every contact
counts, however faint; those at the end of the tail switch at speeds below rounding, and their
landings are not asked for (a wider type bounds what they cost). */
template <class T>
bool is_accurate(const Flow<T>& flow, const Landing<T>& landing) {
  const T tolerance = std::max(landing.tolerance, T(16) * std::numeric_limits<T>::epsilon());
  return (flow.unlanded == 0 || landing.floor == T(0)) &&
         flow.error <= tolerance * T(double(flow.steps + 1));
}

/// Where the iteration ended.
template <class T>
struct Solution {
  Vector<T> x;
  Shot<T> shot;
  History history;
};

template <class Problem, class T>
NoConvergence failure(const Problem& problem, const std::string& why, const Solution<T>& so_far) {
  return {problem.name() + ": " + why, so_far.history};
}

template <class Problem, class T>
Solution<T> accepted(const Problem& problem, Solution<T> found, const NewtonRule<T>& rule) {
  if (is_accurate(found.shot.flow, rule.landing)) return found;
  throw failure(problem, "the integration is not accurate enough for an orbit", found);
}

/**
The residual is the largest of the equations, each in its unit. Far from any orbit a full step may
lead farther away; a damped iteration then takes the largest half, quarter, ... of it that lowers
the residual, and gives up below a thousandth. */
template <class Problem, class T>
T residual_of(const Problem& problem, const Shot<T>& shot, const Vector<T>& at,
              const NewtonRule<T>& rule) {
  return sup<T>(shot.miss.cwiseQuotient(problem.sizes(at, rule.graded).equation));
}

/// The share of the step from the best point so far; throws where none helps.
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

`Direction` gives the step from a shot: `newton` solves with the exact derivative, `polish` of
shooting.hpp with one that was computed before. We stop where the residual, already small, no longer
falls by a factor of four, and keep the better of the last two. Anything else is a failure. */
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
The plain method solves with the derivative at each point. Throws NoConvergence, with the history. */
template <class Problem, class T = typename Problem::Scalar>
Solution<T> solve(const Problem& problem, const Vector<T>& x, const NewtonRule<T>& rule = {}) {
  return iterate(problem, x, rule, true, [&](const Shot<T>& shot, const Vector<T>& at) {
    return solve_scaled<T>(shot.jacobian, shot.miss, problem.sizes(at, true), rule.rank);
  });
}

}  // namespace lattice
