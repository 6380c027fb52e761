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

#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "lattice/events/event_driven.hpp"
#include "lattice/orbits/linear.hpp"

namespace lattice {

/// The largest modulus in a vector; infinite if any entry is not a finite number.
template <class T>
T sup(const Vector<T>& x);

/**
Newton's method learns about a problem from one integration at a time, a shot. It tells by how much the
equations are missed, how that depends on the unknowns, and how accurate the flow was (event_driven.hpp). */
template <class T>
struct Shot {
  Vector<T> miss, miss_period;  ///< residuals and their derivative with respect to the period
  Matrix<T> jacobian;           ///< with respect to the unknowns; empty if it was not asked for
  FlowReport<T> flow;           ///< of the integration; all zero from another integrator
};

/// The units of unknowns and of equations.
template <class T>
struct Sizes {
  Vector<T> unknown, equation;
};

/**
## A step

Each step solves a linear system (linear.hpp), and its numbers differ vastly: the tail of a breather falls
double-exponentially, $|y_{n+1}|\sim|y_n|^{3/2}$, and its equations are as small as its positions. If each
unknown and each equation is measured in units of the local size (`Sizes`), elimination finds every
position to the same relative accuracy. */
/// The step x with matrix * x = right, computed in the units of `size` and returned in those of `matrix`
/// and `right`.
template <class T>
Vector<T> solve_scaled(Matrix<T> matrix, Vector<T> right, const Sizes<T>& size, double rank);

/**
## History and failure

A result that has not converged must not leave a program unnoticed, so every iteration is recorded.
Residual and step are relative to the amplitude of the orbit, or, if `graded`, to the local size, so that
the tail has to converge as well as the centre. */
struct Iteration {
  double residual, step;  ///< the step from that point on; zero where none was made
};
/// All iterations, from the guess on.
using History = std::vector<Iteration>;

/// Residuals and steps in one line, for messages.
std::string to_text(const History& history);

/**
If the method fails, the residuals of all iterations are in the message: they tell whether the guess was
bad, the flow inaccurate, or the branch at its end. */
struct NewtonFailed : std::runtime_error {
  History history;
  NewtonFailed(const std::string& what, History steps)
      : std::runtime_error(what + (steps.empty() ? "" : "; relative residuals " + to_text(steps))),
        history(std::move(steps)) {}
};

/// How Newton's method proceeds and when it stops.
template <class T>
struct NewtonRule {
  EventTolerance<T> events{};  ///< of the flow
  int most = 30;               ///< iterations
  bool graded = false;         ///< demand relative accuracy of every site
  bool damped = false;         ///< halve a step until it lowers the residual
  double rank = 0;             ///< see solve_system
  double keep = 0;             ///< where the residual falls below it the last derivative serves on
  /// A residual below which the method may stop, as soon as the residual no longer falls. A shot of many
  /// steps misses by some multiple of the tolerance of one; relative to the local size, in the tail, by
  /// a thousand times more.
  T enough() const { return T(graded ? 65536 : 64) * events.tolerance; }
};

/**
An orbit is no better than the flow from which it was computed. Every step of the integrator estimates its
own error. If one could not meet the tolerance, or if a contact that matters opened or closed in the middle
of a step (`missed_events`), the residual means nothing and the orbit is refused. */
/// Whether the flow is good enough for an orbit.
template <class T>
bool is_accurate(const FlowReport<T>& flow, const EventTolerance<T>& landing);

/// Where the iteration ended: unknowns, the shot from there, and all iterations.
template <class T>
struct Solution {
  Vector<T> x;
  Shot<T> shot;
  History history;
};

/**
What the method sees of a problem are these three functions. Any object with members of these names will do. */
template <class T>
struct NewtonProblem {
  std::function<Shot<T>(const Vector<T>& x, const EventTolerance<T>&, bool with_jacobian)> shoot;
  std::function<Sizes<T>(const Vector<T>& x, bool graded)> sizes;
  std::function<std::string()> name;
  /// How large the motion is; where this is given the method does not go to rest.
  std::function<T(const Vector<T>& x)> amplitude{};
};

/// `problem` as Newton's method sees it; it must live as long.
template <class P>
NewtonProblem<typename P::Scalar> seen(const P& problem) {
  using T = typename P::Scalar;
  return {[&](const Vector<T>& x, const EventTolerance<T>& landing, bool with_jacobian) {
            return problem.shoot(x, landing, with_jacobian);
          },
          [&](const Vector<T>& x, bool graded) { return problem.sizes(x, graded); },
          [&] { return problem.name(); }};
}

/**
## The iteration

Now everything is put together. `direction` gives the step from a shot: `solve`, below, uses the exact
derivative, `polish` of shooting.hpp one that was computed before. We stop when the residual is small and
no longer falls by a factor of four, and keep the better of the last two points; rounding then forbids
more. Anything else is a failure. */
/// The step from a shot at `x`; it is subtracted.
template <class T>
using Direction = std::function<Vector<T>(const Shot<T>&, const Vector<T>& x)>;

/// The solution near `x`, with steps from `direction`; shots have a derivative if `jacobian` is set. Throws
/// NewtonFailed.
template <class T>
Solution<T> iterate(const NewtonProblem<T>& problem, Vector<T> x, const NewtonRule<T>& rule,
                    bool jacobian, const Direction<T>& direction);

/**
The plain method uses the derivative at each point, of which the columns of the tangent take most of the time; once the
residual has fallen below `keep`, the derivative of that point is good enough for all digits. `solve` returns the solution near the guess `x`, or
throws NewtonFailed, with the history. */
template <class T>
Solution<T> solve(const NewtonProblem<T>& problem, const Vector<T>& x,
                  const NewtonRule<T>& rule = {});

/// The same for any problem.
template <class P, class T = typename P::Scalar>
Solution<T> solve(const P& problem, const Vector<T>& x, const NewtonRule<T>& rule = {}) {
  return solve(seen(problem), x, rule);
}

}  // namespace lattice
