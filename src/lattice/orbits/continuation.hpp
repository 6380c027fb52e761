#pragma once
/**
# Following a branch

Breathers come in families, and a family is a curve in the space of unknowns and one
parameter, the frequency or the anharmonicity. We follow the curve by its arclength: a step along
the tangent, then Newton on the equations together with the condition that the correction be
perpendicular to the tangent. Where the curve turns back in its parameter nothing special
happens, because the parameter is an unknown like the others.

Close to $\omega_b = 1$ the positions are proportional to $\epsilon = (2\tau_0(\omega_b-1))^2$ and all but
constant in these units. We therefore follow $\xi$ and $\ell$ in
$$y = (\omega_b-1)^2\,\xi,\qquad \omega_b = 1 + e^{\ell},$$
in which the branch of the DpS equation is a straight line, and scale $\xi$ to a maximum
of one at the first point. Along $s$ both are what they are. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

#include "lattice/orbits/shooting.hpp"

namespace lattice {

enum class Along { omega, s };

/**
A chart translates between the coordinates of the curve and the problem. Its derivative with
respect to $\ell$ is exact for the frequency; for the anharmonicity it is a central
difference, which decides only how fast the corrector converges. */
template <class T>
struct Chart {
  Along along = Along::omega;
  T unit = T(1);

  T scale(T ell) const {
    using std::exp;
    return along == Along::omega ? unit * exp(T(2) * ell) : unit;
  }
  T parameter(T ell) const {
    using std::exp;
    return along == Along::omega ? T(1) + exp(ell) : ell;
  }
  T coordinate(T parameter) const {
    using std::log;
    return along == Along::omega ? log(parameter - T(1)) : parameter;
  }
  template <class Problem>
  Problem at(Problem problem, T value) const {
    if (along == Along::omega)
      problem.omega = value;
    else
      problem.chain.onsite.s = double(value);
    return problem;
  }
};

/// How long the steps are, in the length of (xi, ell), and how accurate the curve.
struct Stride {
  double first = 0.1, least = 1e-4, most = 0.4;
  double tolerance = 1e-9;  ///< relative residual of the points on the curve
  int corrections = 6;
};

/// The branch ends or turns back before the parameter that was asked for.
struct NoBranch : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/**
A branch stands at a point of the curve and can take a step. The vector `z` holds $\xi$ and, as
its last entry, $\ell$. */
template <class T, class Problem>
class Branch {
 public:
  /// Begins at a converged orbit and moves towards larger parameters if `direction` > 0.
  Branch(Problem problem, Along along, const Orbit<T>& start, int direction,
         NewtonRule<T> rule = {}, Stride stride = {});

  T parameter() const { return chart_.parameter(ell(z_)); }
  /// How the parameter changes along the curve; its sign changes at a fold.
  T slope() const { return tangent_[tangent_.size() - 1]; }
  /// Moves one step on; throws NoConvergence where even the shortest one fails.
  void advance();
  /// Follows the branch through its next fold; returns the extreme parameter.
  T fold(int most_steps = 400);
  /// Follows the branch up to `target` and converges there to the accuracy of `rule`.
  Orbit<T> reach(T target, int most_steps = 400);

 private:
  static T ell(const Vector<T>& z) { return z[z.size() - 1]; }
  Vector<T> unknowns(const Vector<T>& z) const {
    return chart_.scale(ell(z)) * z.head(z.size() - 1);
  }
  Shot<T> shot_at(const Vector<T>& z) const;
  Matrix<T> bordered(const Vector<T>& z, const Shot<T>& shot, const Vector<T>& border) const;
  Vector<T> parameter_derivative(const Vector<T>& z, const Shot<T>& shot) const;
  bool correct(Vector<T>& z, const Vector<T>& tangent, Vector<T>& next_tangent);

  Problem problem_;
  Chart<T> chart_;
  NewtonRule<T> rule_;
  Stride stride_;
  double length_;
  Vector<T> z_, tangent_, before_;
  History history_;
  int used_ = 0;
};

template <class T, class Problem>
Branch<T, Problem>::Branch(Problem problem, Along along, const Orbit<T>& start, int direction,
                           NewtonRule<T> rule, Stride stride)
    : problem_(std::move(problem)), rule_(rule), stride_(stride), length_(stride.first) {
  chart_.along = along;
  const T parameter = along == Along::omega ? start.omega : T(problem_.chain.onsite.s);
  const T l = chart_.coordinate(parameter);
  chart_.unit = sup(start.x) / chart_.scale(l);
  z_.resize(start.x.size() + 1);
  z_ << start.x / chart_.scale(l), l;
  Vector<T> border = Vector<T>::Zero(z_.size()), right = border;
  border[z_.size() - 1] = right[z_.size() - 1] = T(1);
  tangent_ = bordered(z_, shot_at(z_), border).partialPivLu().solve(right);
  tangent_ *= T(direction) / tangent_.norm();
  before_ = z_;
}

template <class T, class Problem>
Shot<T> Branch<T, Problem>::shot_at(const Vector<T>& z) const {
  return shoot(chart_.at(problem_, chart_.parameter(ell(z))), unknowns(z), rule_.landing);
}

/// Derivative of the equations with respect to the last coordinate.
template <class T, class Problem>
Vector<T> Branch<T, Problem>::parameter_derivative(const Vector<T>& z, const Shot<T>& shot) const {
  const T value = chart_.parameter(ell(z));
  if (chart_.along == Along::omega)
    return (value - T(1)) * shot.miss_omega + shot.jacobian * (T(2) * unknowns(z));
  const T change(1.0 / 1024);
  const auto at = [&](T s) {
    return shoot(chart_.at(problem_, s), unknowns(z), rule_.landing, false).miss;
  };
  return (at(value + change) - at(value - change)) / (T(2) * change);
}

/// The equations' derivatives with respect to all coordinates, and below them the border.
template <class T, class Problem>
Matrix<T> Branch<T, Problem>::bordered(const Vector<T>& z, const Shot<T>& shot,
                                       const Vector<T>& border) const {
  const Eigen::Index m = z.size() - 1;
  const T scale = chart_.scale(ell(z));
  Matrix<T> all(m + 1, m + 1);
  all.topLeftCorner(m, m) = shot.jacobian;
  all.topRightCorner(m, 1) = parameter_derivative(z, shot) / scale;
  all.row(m) = border.transpose();
  return all;
}

/**
The corrector is Newton's method on $m$ equations and the condition that the correction is
perpendicular to the tangent. The tangent at the new point comes from the last matrix. */
template <class T, class Problem>
bool Branch<T, Problem>::correct(Vector<T>& z, const Vector<T>& tangent, Vector<T>& next_tangent) {
  const Eigen::Index m = z.size() - 1;
  history_.clear();
  for (used_ = 0; used_ <= stride_.corrections; ++used_) {
    const Shot<T> shot = shot_at(z);
    Vector<T> right = Vector<T>::Zero(m + 1);
    right.head(m) = shot.miss / chart_.scale(ell(z));
    const T residual = sup(right);
    history_.push_back({double(residual), 0});
    if (!(residual < T(1))) return false;
    const auto lu = bordered(z, shot, tangent).partialPivLu();
    if (residual <= T(stride_.tolerance)) {
      right.setZero();
      right[m] = T(1);
      next_tangent = lu.solve(right);
      next_tangent /= next_tangent.norm();
      return sup(next_tangent) <= T(2);
    }
    z -= lu.solve(right);
  }
  return false;
}

/**
A step that converges quickly makes the next one longer, one that fails or turns too
sharply is repeated with half the length. */
template <class T, class Problem>
void Branch<T, Problem>::advance() {
  for (;; length_ /= 2) {
    if (length_ < stride_.least)
      throw NoConvergence(
          "continuation stops at the parameter " + std::to_string(double(parameter())), history_);
    Vector<T> z = z_ + T(length_) * tangent_, next;
    if (!correct(z, tangent_, next)) continue;
    if (next.dot(tangent_) < T(0.9) && length_ > 2 * stride_.least) continue;
    before_ = z_;
    z_ = z;
    tangent_ = next;
    if (used_ <= 3) length_ = std::min(1.5 * length_, stride_.most);
    return;
  }
}

/**
Across a fold $\ell$ has an extremum as a function of the arclength. The cubic with the values and
slopes at both ends of the step that crossed it has it too. */
template <class T, class Problem>
T Branch<T, Problem>::fold(int most_steps) {
  T slope_before = slope();
  for (int k = 0; slope() * slope_before > T(0); ++k) {
    if (k == most_steps) throw NoBranch("no fold within the steps allowed");
    slope_before = slope();
    advance();
  }
  const Arc<T> arc{ell(before_), slope_before, ell(z_), slope(), (z_ - before_).norm()};
  const T place = Arc<T>::last(T(1), [&](T s) { return arc.slope(s) * slope_before > T(0); });
  return chart_.parameter(arc.value(place));
}

/**
Between the last two points the target's unknowns are interpolated, and Newton's method
finishes at the target itself. */
template <class T, class Problem>
Orbit<T> Branch<T, Problem>::reach(T target, int most_steps) {
  const T goal = chart_.coordinate(target);
  const T side = slope() > T(0) ? T(1) : T(-1);
  for (int k = 0; side * ell(z_) < side * goal; ++k) {
    advance();
    if (k == most_steps || (side * slope() < T(0) && side * ell(z_) < side * goal))
      throw NoBranch("the branch does not reach " + std::to_string(double(target)) +
                     ": it turns back near " + std::to_string(double(parameter())) +
                     ", and the family has no breather there");
  }
  const T width = ell(z_) - ell(before_);
  const T part = width != T(0) ? (goal - ell(before_)) / width : T(0);
  Vector<T> z = before_ + part * (z_ - before_);
  z[z.size() - 1] = goal;
  return newton(chart_.at(problem_, target), unknowns(z), rule_);
}

}  // namespace lattice
