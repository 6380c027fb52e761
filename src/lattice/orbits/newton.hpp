#pragma once
/**
# Newton's method

To find $x$ with $f(x) = 0$, Newton's method repeats $x \leftarrow x - f'(x)^{-1} f(x)$ from a guess; once
it is close, each step doubles the number of correct digits. Here $x$ is the initial state of a periodic
orbit, as far as it is unknown, and the residual $f(x)$ says by how much the orbit fails to close (symmetry.hpp).
`newton` knows nothing but the functions $f$ and $f'$; shooting.hpp has those of a chain. */

#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "lattice/algebra/dense.hpp"
#include "lattice/events/event_driven.hpp"

namespace lattice {

/// The largest modulus in a vector; infinite if any entry is not a finite number.
template <class T>
T sup(const Vector<T>& x);

/// What one integration tells of the equations at x.
template <class T>
struct Evaluation {
  Vector<T> residual, residual_period;  ///< f and its derivative with respect to the period
  Matrix<T> jacobian;                   ///< f', one row an equation; empty if it was not asked for
  FlowReport<T> flow;  ///< how accurate the integration was; all zero from another integrator
};

/// The units of unknowns and of equations.
template <class T>
struct Sizes {
  Vector<T> unknown, equation;
};

/// Equations f(x) = 0, as functions of the unknowns x.
template <class T>
struct Equations {
  std::string name;  ///< what is looked for, for messages
  /// f(x), and f'(x) if the `derivative` is wanted.
  std::function<Evaluation<T>(const Vector<T>& x, const EventTolerance<T>&, bool derivative)>
      evaluate;
  /// The units at x: the local size if `scaled`, else the amplitude.
  std::function<Sizes<T>(const Vector<T>& x, bool scaled)> sizes;
  /// The size of x and how far the motion leads; where these are given the method does not go to rest, which is a
  /// solution of any period.
  std::function<T(const Vector<T>&x)> amplitude{}, reach{};
};

/// The derivative of `residual` at `x`, from changes of each unknown by `change` to either side.
template <class T, class Residual>
Matrix<T> central_differences(const Residual& residual, const Vector<T>& x, const T& change) {
  Matrix<T> out;
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    Vector<T> more = x, less = x;
    more[k] += change, less[k] -= change;
    const Vector<T> column = (residual(more) - residual(less)) / (T(2) * change);
    if (k == 0) out.resize(column.size(), x.size());
    out.col(k) = column;
  }
  return out;
}

/// The equations residual(x) = 0, as many as unknowns, in units of the largest unknown; `change` is that of the
/// differences in this unit.
template <class T, class Residual>
Equations<T> by_differences(const std::string& name, const Residual& residual, const T& change) {
  return {name,
          [=](const Vector<T>& x, const EventTolerance<T>&, bool derivative) {
            Evaluation<T> out;
            out.residual = residual(x);
            if (derivative) out.jacobian = central_differences<T>(residual, x, change * sup(x));
            return out;
          },
          [](const Vector<T>& x, bool) {
            const Vector<T> size = Vector<T>::Constant(x.size(), sup(x));
            return Sizes<T>{size, size};
          }};
}

/// The x with matrix * x = right. With as many equations as unknowns and without a `rank` the system is solved as it
/// stands. Otherwise it is the shortest one in the sense of least squares, in which a direction counts as free if its
/// singular value, relative to the largest or to `scale`, is below `rank`; types that are not built in throw
/// std::logic_error.
template <class T>
Vector<T> solve_system(const Matrix<T>& matrix, const Vector<T>& right, double rank = 0,
                       double scale = 0);

/**
The tail of a breather falls double-exponentially, $|y_{n+1}|\sim|y_n|^{3/2}$, and its equations are as small as its
positions. If each unknown and each equation is measured in units of the local size (`Sizes`), elimination finds every
position to the same relative accuracy. */
/// The step x with matrix * x = right, computed in the units of `size` and returned in those of `matrix`
/// and `right`.
template <class T>
Vector<T> solve_scaled(Matrix<T> matrix, Vector<T> right, const Sizes<T>& size, double rank,
                       double scale = 0);

/// Residual and step are relative to the amplitude of the orbit, or, if `scaled`, to the local size, so that
/// the tail has to converge as well as the centre.
struct Iteration {
  double residual, step;  ///< the step from that point on; zero where none was made
};
/// All iterations, from the guess on.
using History = std::vector<Iteration>;

/// Its message has the residuals of all iterations: they tell whether the guess was bad, the flow inaccurate, or the
/// branch at its end.
struct NewtonFailed : std::runtime_error {
  History history;
  NewtonFailed(const std::string& what, History steps);
};

/// How Newton's method proceeds and when it stops.
template <class T>
struct NewtonRule {
  EventTolerance<T> events{};  ///< of the flow
  int most_steps = 30;
  bool scaled = false;     ///< demand relative accuracy of every site
  bool damped = false;     ///< halve a step until it lowers the residual
  double rank = 0;         ///< see solve_system,
  double scale = 0;        ///< which matters where all equations hold whatever the unknowns are
  double reuse_below = 0;  ///< once the residual is below it, the last derivative serves on
  /// A residual below which the method may stop, as soon as the residual no longer falls. An evaluation of many
  /// steps has some multiple of the error of one; relative to the local size, in the tail, a thousand times
  /// more. The flow from an unstable orbit multiplies the rounding of the start by the `norm` of its derivative.
  T converged_below(const T& norm) const {
    return std::max(T(scaled ? 65536 : 64) * events.tolerance,
                    T(16) * std::numeric_limits<T>::epsilon() * norm);
  }
};

/// Where the iteration ended: unknowns, the evaluation there, and all iterations.
template <class T>
struct Solution {
  Vector<T> x;
  Evaluation<T> evaluation;
  History history;
};

/**
## The method

Most of the time goes into the derivative. Once the residual has fallen below `reuse_below`, the last one is good
enough for all digits; so is one of the same orbit in another precision. The method stops when the residual is small and
no longer falls by a factor of four, and keeps the better of the last two points. Anything else is a failure. */
/// The solution near the guess `x`. If a `derivative` is given it serves at all points, and no other is computed.
/// Throws NewtonFailed, with the history.
template <class T>
Solution<T> newton(const Equations<T>& equations, Vector<T> x, const NewtonRule<T>& rule = {},
                   const Matrix<T>* derivative = nullptr);

}  // namespace lattice
