#pragma once
/**
# Following a branch

Breathers come in families, and a family is a curve in the space of the unknowns and one parameter: the
frequency, the anharmonicity, or any other number on which the problem depends. If we prescribed the
parameter and solved for the rest, we should be lost where the curve turns back in it (a *fold*). So we
follow the curve by its arclength: a step along the tangent, then Newton's method on the equations
together with the condition that the correction be perpendicular to the tangent. The parameter is an
unknown like the others, and a fold is nothing special. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

#include "lattice/orbits/shooting.hpp"

namespace lattice {

/**
The families of the article begin at $\omega_b = 1$ with breathers of vanishing amplitude. Their positions
are proportional to $\epsilon = (2\tau_0(\omega_b-1))^2$, Eq. (20), and nearly constant in units of it.
Along the frequency we therefore follow $\xi$ and $\ell$, with
$$y = (\omega_b-1)^2\,\xi,\qquad \omega_b = 1 + e^{\ell};$$
in these coordinates the small-amplitude limit (the DpS equation, dps.hpp) is a straight line. Any other
parameter is itself the coordinate $\ell$. The derivative with respect to the frequency is exact; with
respect to another parameter it is a central difference, whose error affects only how fast the corrector
converges and how long the steps are. */
template <class Problem>
struct Along {
  using T = typename Problem::Scalar;
  std::string name;
  std::function<T(const Problem&)> get;
  std::function<void(Problem&, const T&)> set;
  double change = 0;  ///< of the central difference; 0 for the frequency

  bool is_frequency() const { return change == 0; }
  T scale(T ell) const {
    using std::exp;
    return is_frequency() ? exp(T(2) * ell) : T(1);
  }
  T parameter(T ell) const {
    using std::exp;
    return is_frequency() ? T(1) + exp(ell) : ell;
  }
  T coordinate(T parameter) const {
    using std::log;
    return is_frequency() ? log(parameter - T(1)) : parameter;
  }
  Problem at(Problem problem, const T& value) const {
    set(problem, value);
    return problem;
  }
};

/**
Two parameters serve most programs; any other can be written in the same way. */
/// Along the frequency omega_b.
template <class Problem>
Along<Problem> along_omega() {
  using T = typename Problem::Scalar;
  return {"omega_b", [](const Problem& p) { return p.omega; },
          [](Problem& p, const T& omega) { p.omega = omega; }, 0};
}

/// Along the anharmonicity s of a quartic well.
template <class Problem>
Along<Problem> along_s() {
  using T = typename Problem::Scalar;
  return {"s", [](const Problem& p) { return T(p.chain.onsite.s); },
          [](Problem& p, const T& s) { p.chain.onsite.s = double(s); }, 1.0 / 1024};
}

/// How long the steps are, as lengths in the space of (xi, ell), where xi is scaled to a maximum of one,
/// and how accurate the points are. Six corrections are enough if a step is not too long.
struct Stride {
  double first = 0.1, least = 1e-4, most = 0.4;
  double tolerance = 1e-9;  ///< relative residual of the points on the curve
  int corrections = 6;
};

/**
A family need not have a member at every value of the parameter. */
/// Thrown if the branch ends or turns back before the parameter that was asked for.
struct NoBranch : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/**
A `Branch` stands at a point of the curve and can take a step. The vector `z` holds $\xi$ and, as its last
entry, $\ell$. */
template <class Problem>
class Branch {
  using T = typename Problem::Scalar;

 public:
  /// Begins at a converged orbit and moves towards larger parameters if `direction` > 0.
  Branch(Problem problem, Along<Problem> which, const Orbit<T>& start, int direction,
         NewtonRule<T> rule = {}, Stride stride = {});

  T parameter() const { return along_.parameter(ell(z_)); }
  /// How the parameter changes along the curve; its sign changes at a fold.
  T slope() const { return tangent_[tangent_.size() - 1]; }
  /// Takes one step; throws NoConvergence if even the shortest one fails.
  void advance();
  /// Follows the branch through its next fold and returns the extreme parameter; throws NoBranch if
  /// there is none within `most_steps`.
  T fold(int most_steps = 400);
  /// Follows the branch up to `target` and converges there to the accuracy of `rule`; throws NoBranch
  /// if the branch turns back before.
  Orbit<T> reach(T target, int most_steps = 400);
  /// The problem and the unknowns at the point where the branch stands.
  Problem problem() const { return along_.at(problem_, parameter()); }
  Vector<T> unknowns() const { return unknowns(z_); }

  /**
  Inside, $\xi$ is scaled to a maximum of one at the first point. The corrector solves with a matrix that
  has one more row than there are equations, its border; the same matrix gives the tangent. */
 private:
  static T ell(const Vector<T>& z) { return z[z.size() - 1]; }
  Vector<T> unknowns(const Vector<T>& z) const {
    return along_.scale(ell(z)) * unit_.cwiseProduct(z.head(z.size() - 1));
  }
  /// The size of each equation at a point of the curve.
  Vector<T> amplitude(const Vector<T>& z) const {
    return problem_.sizes(unknowns(z), false).equation;
  }
  /// The direction in which the equations stay true, by the last row of a bordered matrix.
  Vector<T> along(const Matrix<T>& all) const {
    Vector<T> right = Vector<T>::Zero(all.rows());
    right[all.rows() - 1] = T(1);
    return solve_system<T>(all, right, rule_.rank);
  }
  /**
  At a point of the curve we need the shot, its derivative with respect to the parameter and the bordered
  matrix; `correct` moves a predicted point onto the curve. */
  Shot<T> shot_at(const Vector<T>& z) const;
  Matrix<T> bordered(const Vector<T>& z, const Shot<T>& shot, const Vector<T>& border) const;
  Vector<T> parameter_derivative(const Vector<T>& z, const Shot<T>& shot) const;
  bool correct(Vector<T>& z, const Vector<T>& tangent, Vector<T>& next_tangent);

  Problem problem_;
  Along<Problem> along_;
  NewtonRule<T> rule_;
  Stride stride_;
  double length_;
  Vector<T> unit_, z_, tangent_, before_;
  History history_;
  int used_ = 0;
};

/**
At the first point the border prescribes the parameter: the tangent is the direction in which the equations
remain true while $\ell$ grows. */
template <class Problem>
Branch<Problem>::Branch(Problem problem, Along<Problem> which, const Orbit<T>& start, int direction,
                        NewtonRule<T> rule, Stride stride)
    : problem_(std::move(problem)),
      along_(std::move(which)),
      rule_(rule),
      stride_(stride),
      length_(stride.first) {
  const T l = along_.coordinate(along_.get(problem_));
  unit_ = problem_.sizes(start.x, false).unknown / along_.scale(l);
  z_.resize(start.x.size() + 1);
  z_ << start.x.cwiseQuotient(unit_) / along_.scale(l), l;
  Vector<T> border = Vector<T>::Zero(z_.size());
  border[z_.size() - 1] = T(1);
  tangent_ = along(bordered(z_, shot_at(z_), border));
  tangent_ *= T(direction) / tangent_.norm();
  before_ = z_;
}

/**
A shot at a point of the curve is one of the problem with that parameter. */
template <class Problem>
Shot<typename Problem::Scalar> Branch<Problem>::shot_at(const Vector<T>& z) const {
  return along_.at(problem_, along_.parameter(ell(z))).shoot(unknowns(z), rule_.landing);
}

/**
The last coordinate enters the equations through the problem and, along the frequency, also through the
scale $(\omega_b-1)^2 = e^{2\ell}$ of the unknowns. */
template <class Problem>
Vector<typename Problem::Scalar> Branch<Problem>::parameter_derivative(const Vector<T>& z,
                                                                       const Shot<T>& shot) const {
  const T value = along_.parameter(ell(z));
  if (along_.is_frequency()) {
    const T longer = -along_.at(problem_, value).period() / value;
    return (value - T(1)) * longer * shot.miss_period + shot.jacobian * (T(2) * unknowns(z));
  }
  const T change(along_.change);
  const auto at = [&](const T& s) {
    return along_.at(problem_, s).shoot(unknowns(z), rule_.landing, false).miss;
  };
  return (at(value + change) - at(value - change)) / (T(2) * change);
}

/**
The matrix of the corrector holds the derivatives of the equations with respect to all coordinates, with
each equation in units of the orbit's amplitude, and below them the border: the direction in which a
correction must not go. */
template <class Problem>
Matrix<typename Problem::Scalar> Branch<Problem>::bordered(const Vector<T>& z, const Shot<T>& shot,
                                                           const Vector<T>& border) const {
  const Eigen::Index m = z.size() - 1, rows = shot.miss.size();
  const T scale = along_.scale(ell(z));
  const Vector<T> size = amplitude(z);
  Matrix<T> all(rows + 1, m + 1);
  all.topLeftCorner(rows, m) = shot.jacobian;
  for (Eigen::Index k = 0; k < m; ++k) all.col(k).head(rows) *= scale * unit_[k];
  all.topRightCorner(rows, 1) = parameter_derivative(z, shot);
  for (Eigen::Index i = 0; i < rows; ++i) all.row(i) /= size[i];
  all.row(rows) = border.transpose();
  return all;
}

/**
The corrector is Newton's method on the equations and the condition that the correction be perpendicular
to the tangent. The tangent at the new point comes from the last matrix; if that was singular its length is
zero or not a finite number, and the point is refused. Returns whether the point was reached. */
template <class Problem>
bool Branch<Problem>::correct(Vector<T>& z, const Vector<T>& tangent, Vector<T>& next_tangent) {
  history_.clear();
  for (used_ = 0; used_ <= stride_.corrections; ++used_) {
    const Shot<T> shot = shot_at(z);
    Vector<T> right = Vector<T>::Zero(shot.miss.size() + 1);
    right.head(shot.miss.size()) = shot.miss.cwiseQuotient(amplitude(z));
    const T residual = sup(right);
    history_.push_back({double(residual), 0});
    if (!(residual < T(1))) return false;
    const Matrix<T> all = bordered(z, shot, tangent);
    if (residual <= T(stride_.tolerance)) {
      next_tangent = along(all);
      const T norm = next_tangent.norm();
      next_tangent /= norm;
      return norm > T(0) && norm < std::numeric_limits<T>::infinity();
    }
    z -= solve_system<T>(all, right, rule_.rank);
  }
  return false;
}

/**
A step that converges quickly lets the next one be longer. One that fails, or after which the tangent has
turned too sharply (by a cosine below 0.9, about 26 degrees), is repeated with half the length. */
template <class Problem>
void Branch<Problem>::advance() {
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
At a fold $\ell$ has an extremum as a function of the arclength. We find it on the cubic that has the
values and slopes of $\ell$ at both ends of the step across the fold (`Arc` of overlap.hpp). */
template <class Problem>
typename Problem::Scalar Branch<Problem>::fold(int most_steps) {
  T slope_before = slope();
  for (int k = 0; slope() * slope_before > T(0); ++k) {
    if (k == most_steps) throw NoBranch("no fold within the steps allowed");
    slope_before = slope();
    advance();
  }
  const Arc<T> arc{ell(before_), slope_before, ell(z_), slope(), (z_ - before_).norm()};
  const T place = Arc<T>::last(T(1), [&](T s) { return arc.slope(s) * slope_before > T(0); });
  return along_.parameter(arc.value(place));
}

/**
To reach a given parameter we step beyond it, interpolate the unknowns between the last two points, and
let Newton's method finish at the target itself. */
template <class Problem>
Orbit<typename Problem::Scalar> Branch<Problem>::reach(T target, int most_steps) {
  const T goal = along_.coordinate(target);
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
  return newton(along_.at(problem_, target), unknowns(z), rule_);
}

}  // namespace lattice
