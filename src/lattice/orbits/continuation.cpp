#include "lattice/orbits/continuation.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "lattice/events/overlap.hpp"
#include "lattice/numerics/progress.hpp"

namespace lattice {

/**
At the first point the border prescribes the parameter: the tangent is the direction in which the equations
remain true while $\ell$ grows. */
template <class T>
Branch<T>::Branch(Shooting<T> problem, Along<T> which, const Orbit<T>& start, int direction,
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
  tangent_ = along(bordered(z_, evaluate_at(z_), border));
  tangent_ *= T(direction) / tangent_.norm();
  before_ = z_;
}

/**
An evaluation at a point of the curve is one of the problem with that parameter. */
template <class T>
Evaluation<T> Branch<T>::evaluate_at(const Vector<T>& z) const {
  return along_.at(problem_, along_.parameter(ell(z))).evaluate(unknowns(z), rule_.events);
}

/**
The last coordinate enters the equations through the problem and, along the frequency, also through the
scale of the unknowns, $(\omega_b-1)^2 = e^{2\ell}$ between spheres. */
template <class T>
Vector<T> Branch<T>::parameter_derivative(const Vector<T>& z, const Evaluation<T>& here) const {
  const T value = along_.parameter(ell(z));
  if (along_.is_frequency()) {
    const T longer = -along_.at(problem_, value).period() / value;
    return (value - T(1)) * longer * here.residual_period +
           here.jacobian * (T(along_.power) * unknowns(z));
  }
  const T change(along_.change);
  const auto at = [&](const T& s) {
    return along_.at(problem_, s).evaluate(unknowns(z), rule_.events, false).residual;
  };
  return (at(value + change) - at(value - change)) / (T(2) * change);
}

/**
The matrix of the corrector holds the derivatives of the equations with respect to all coordinates, with
each equation in units of the orbit's amplitude, and below them the border: the direction in which a
correction must not go. */
template <class T>
Matrix<T> Branch<T>::bordered(const Vector<T>& z, const Evaluation<T>& here,
                              const Vector<T>& border) const {
  const Eigen::Index m = z.size() - 1, rows = here.residual.size();
  const T scale = along_.scale(ell(z));
  const Vector<T> size = amplitude(z);
  Matrix<T> all(rows + 1, m + 1);
  all.topLeftCorner(rows, m) = here.jacobian;
  for (Eigen::Index k = 0; k < m; ++k) all.col(k).head(rows) *= scale * unit_[k];
  all.topRightCorner(rows, 1) = parameter_derivative(z, here);
  for (Eigen::Index i = 0; i < rows; ++i) all.row(i) /= size[i];
  all.row(rows) = border.transpose();
  return all;
}

/**
The corrector is Newton's method on the equations and the condition that the correction be perpendicular
to the tangent. The tangent at the new point comes from the last matrix; if that was singular its length is
zero or not a finite number, and the point is refused. Returns whether the point was reached. */
template <class T>
bool Branch<T>::correct(Vector<T>& z, const Vector<T>& tangent, Vector<T>& next_tangent) {
  history_.clear();
  for (used_ = 0; used_ <= stride_.corrections; ++used_) {
    const Evaluation<T> here = evaluate_at(z);
    Vector<T> right = Vector<T>::Zero(here.residual.size() + 1);
    right.head(here.residual.size()) = here.residual.cwiseQuotient(amplitude(z));
    const T residual = sup(right);
    history_.push_back({double(residual), 0});
    if (!(residual < T(1))) return false;
    const Matrix<T> all = bordered(z, here, tangent);
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
template <class T>
void Branch<T>::advance() {
  for (;; length_ /= 2) {
    if (length_ < stride_.least)
      throw NewtonFailed(
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
values and slopes of $\ell$ at both ends of the step across the fold (`Arc` of overlap.hpp). A step that suffices to
follow the branch is long for a cubic, so a copy of the branch makes it once more, with steps `finer` times shorter. */
template <class T>
T Branch<T>::fold(double finer, int most_steps) {
  T slope_before = slope();
  Vector<T> tangent_before = tangent_;
  for (int k = 0; slope() * slope_before > T(0); ++k) {
    if (k == most_steps) throw NoBranch("no fold within the steps allowed");
    slope_before = slope();
    tangent_before = tangent_;
    advance();
  }
  if (finer > 1) {
    Branch again = *this;
    again.z_ = before_, again.tangent_ = tangent_before;
    again.stride_.most /= finer, again.length_ /= finer;
    return again.fold(1, most_steps);
  }
  const Arc<T> arc{ell(before_), slope_before, ell(z_), slope(), (z_ - before_).norm()};
  const T place = Arc<T>::last(T(1), [&](T s) { return arc.slope(s) * slope_before > T(0); });
  return along_.parameter(arc.value(place));
}

/**
To reach a given parameter we step beyond it, interpolate the unknowns between the last two points, and
let Newton's method finish at the target itself. */
template <class T>
Orbit<T> Branch<T>::orbit_at(T target, int most_steps) {
  const T goal = along_.coordinate(target), start = ell(z_);
  const T side = slope() > T(0) ? T(1) : T(-1);
  Progress progress(number_label("branch to " + along_.name + " =", double(target)), 1);
  for (int k = 0; side * ell(z_) < side * goal; ++k) {
    advance();
    progress.reach(double((ell(z_) - start) / (goal - start)));
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

Estimate fold_of(const Branch<double>& branch) {
  return compare(Branch(branch).fold(16), Branch(branch).fold(32));
}

template class Branch<double>;
template class Branch<long double>;

}  // namespace lattice
