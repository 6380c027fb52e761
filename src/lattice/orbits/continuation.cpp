#include "lattice/orbits/continuation.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <utility>
#include <vector>

#include "lattice/events/overlap.hpp"
#include "lattice/numerics/progress.hpp"

namespace lattice {

// A family needs few steps, and a step few corrections if it is not too long
static constexpr int most_steps = 400, most_corrections = 6;
static constexpr double tolerance = 1e-9;  // relative residual of the points on the curve

// At the first point the border prescribes the parameter
Branch::Branch(Shooting<double> problem, Along<double> which, const Orbit<double>& start,
               int direction, NewtonRule<double> rule, Stride stride)
    : problem_(std::move(problem)),
      along_(std::move(which)),
      rule_(rule),
      stride_(stride),
      length_(stride.first) {
  const double l = along_.coordinate(along_.get(problem_));
  unit_ = problem_.sizes(start.x, false).unknown / along_.scale(l);
  z_.resize(start.x.size() + 1);
  z_ << start.x.cwiseQuotient(unit_) / along_.scale(l), l;
  Vector<double> border = Vector<double>::Zero(z_.size());
  border[z_.size() - 1] = 1;
  tangent_ = along(bordered(z_, evaluate_at(z_), border));
  tangent_ *= direction / tangent_.norm();
  before_ = z_;
}

Vector<double> Branch::along(const Matrix<double>& all) const {
  Vector<double> right = Vector<double>::Zero(all.rows());
  right[all.rows() - 1] = 1;
  return solve_system<double>(all, right, rule_.rank);
}

Evaluation<double> Branch::evaluate_at(const Vector<double>& z) const {
  return along_.at(problem_, along_.parameter(ell(z))).evaluate(unknowns(z), rule_.events);
}

// Along the frequency the last coordinate enters the equations also through the scale of the unknowns
Vector<double> Branch::parameter_derivative(const Vector<double>& z,
                                            const Evaluation<double>& here) const {
  const double value = along_.parameter(ell(z));
  if (along_.is_frequency()) {
    const double longer = -along_.at(problem_, value).period() / value;
    return (value - 1) * longer * here.residual_period +
           here.jacobian * (along_.power * unknowns(z));
  }
  const double change = along_.change;
  const auto at = [&](double s) {
    return along_.at(problem_, s).evaluate(unknowns(z), rule_.events, false).residual;
  };
  return (at(value + change) - at(value - change)) / (2 * change);
}

/// The derivatives of the equations with respect to all coordinates, with each equation in units of the orbit's
/// amplitude, and below them the border: the direction in which a correction must not go.
Matrix<double> Branch::bordered(const Vector<double>& z, const Evaluation<double>& here,
                                const Vector<double>& border) const {
  const Eigen::Index m = z.size() - 1, rows = here.residual.size();
  const double scale = along_.scale(ell(z));
  const Vector<double> size = amplitude(z);
  Matrix<double> all(rows + 1, m + 1);
  all.topLeftCorner(rows, m) = here.jacobian;
  for (Eigen::Index k = 0; k < m; ++k) all.col(k).head(rows) *= scale * unit_[k];
  all.topRightCorner(rows, 1) = parameter_derivative(z, here);
  for (Eigen::Index i = 0; i < rows; ++i) all.row(i) /= size[i];
  all.row(rows) = border.transpose();
  return all;
}

/// Moves a predicted point onto the curve; whether it was reached. The tangent there comes from the last matrix; if
/// that was singular its length is zero or not a finite number, and the point is refused.
bool Branch::correct(Vector<double>& z, const Vector<double>& tangent,
                     Vector<double>& next_tangent) {
  history_.clear();
  for (used_ = 0; used_ <= most_corrections; ++used_) {
    const Evaluation<double> here = evaluate_at(z);
    Vector<double> right = Vector<double>::Zero(here.residual.size() + 1);
    right.head(here.residual.size()) = here.residual.cwiseQuotient(amplitude(z));
    const double residual = sup(right);
    history_.push_back({residual, 0});
    if (!(residual < 1)) return false;
    const Matrix<double> all = bordered(z, here, tangent);
    if (residual <= tolerance) {
      next_tangent = along(all);
      const double norm = next_tangent.norm();
      next_tangent /= norm;
      return norm > 0 && norm < std::numeric_limits<double>::infinity();
    }
    z -= solve_system<double>(all, right, rule_.rank);
  }
  return false;
}

// A step that converges quickly lets the next one be longer. One that fails, or after which the tangent has
// turned too sharply (by a cosine below 0.9, about 26 degrees), is repeated with half the length
void Branch::advance() {
  for (;; length_ /= 2) {
    if (length_ < stride_.least)
      throw NewtonFailed("continuation stops at the parameter " + std::to_string(parameter()),
                         history_);
    Vector<double> z = z_ + length_ * tangent_, next;
    if (!correct(z, tangent_, next)) continue;
    if (next.dot(tangent_) < 0.9 && length_ > 2 * stride_.least) continue;
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
double Branch::fold(double finer) {
  double slope_before = slope();
  Vector<double> tangent_before = tangent_;
  for (int k = 0; slope() * slope_before > 0; ++k) {
    if (k == most_steps) throw NoBranch("no fold within the allowed number of steps");
    slope_before = slope();
    tangent_before = tangent_;
    advance();
  }
  if (finer > 1) {
    Branch again = *this;
    again.z_ = before_, again.tangent_ = tangent_before;
    again.stride_.most /= finer, again.length_ /= finer;
    return again.fold(1);
  }
  const Arc<double> arc{ell(before_), slope_before, ell(z_), slope(), (z_ - before_).norm()};
  const double place =
      Arc<double>::last(1, [&](double s) { return arc.slope(s) * slope_before > 0; });
  return along_.parameter(arc.value(place));
}

// Step beyond the target, interpolate the unknowns between the last two points, and let Newton's method finish there
Orbit<double> Branch::orbit_at(double target) {
  const double goal = along_.coordinate(target), start = ell(z_);
  const double side = slope() > 0 ? 1 : -1;
  Progress progress(number_label("branch to " + along_.name + " =", target), 1);
  for (int k = 0; side * ell(z_) < side * goal; ++k) {
    advance();
    progress.reach((ell(z_) - start) / (goal - start));
    if (k == most_steps || (side * slope() < 0 && side * ell(z_) < side * goal))
      throw NoBranch("the branch does not reach " + std::to_string(target) +
                     ": it folds back near " + std::to_string(parameter()) +
                     ", so this family has no such breather");
  }
  const double width = ell(z_) - ell(before_);
  const double part = width != 0 ? (goal - ell(before_)) / width : 0;
  Vector<double> z = before_ + part * (z_ - before_);
  z[z.size() - 1] = goal;
  return newton(along_.at(problem_, target), unknowns(z), rule_);
}

Estimate fold_of(const Branch& branch) {
  return with_error(Branch(branch).fold(16), Branch(branch).fold(32));
}

/// The chain at `part` of the way from `a` to `b`, from 0 to 1. Masses, stiffnesses, the anharmonicity of quartic wells,
/// the exponent and the root of the compression change linearly; all else is that of `b`.
static Chain between(const Chain& a, const Chain& b, double part) {
  const auto mixed = [&](double from, double to) { return (1 - part) * from + part * to; };
  for (const Chain* chain : {&a, &b}) assert_fits(*chain, b.sites);
  Chain out = b;
  if (part == 1) return out;
  // What differs from bead to bead
  std::vector<double> mass(b.sites), eta(b.sites + 1);
  for (std::size_t i = 0; i < b.sites; ++i) mass[i] = mixed(a.mass_of(i), b.mass_of(i));
  for (std::size_t i = 0; i <= b.sites; ++i) eta[i] = mixed(a.eta_of(i), b.eta_of(i));
  if (a.variation || b.variation) vary(out, mass, eta);
  // What all wells and contacts have
  if (const auto* from = a.well.get_if<Quartic>(), *to = b.well.get_if<Quartic>();
      from && to && from->s != to->s)
    out.well = Quartic{mixed(from->s, to->s)};
  if (b.contact.is<OwnContact>()) return out;
  const double root = mixed(std::sqrt(a.contact.opening()), std::sqrt(b.contact.opening()));
  out.contact =
      without_cutoff(PowerContact{mixed(a.contact.exponent(), b.contact.exponent()), root * root});
  return out;
}

// Along the path the guess lies on the line through the last two orbits
Orbit<double> continue_to(Shooting<double> problem, const Orbit<double>& from,
                          const Chain& target) {
  if (target.sites != problem.chain.sites)
    throw std::invalid_argument("continuation between two chains needs chains of equal length");
  NewtonRule<double> rule;
  rule.damped = true, rule.most_steps = 12, rule.reuse_below = 1e-9;
  const Chain start = problem.chain;
  Orbit<double> here = from;
  Vector<double> slope = Vector<double>::Zero(from.x.size());
  for (double part = 0, step = 1.0 / 8; part < 1;) {
    const double next = std::min(1.0, part + step);
    problem.chain = between(start, target, next);
    const Vector<double> guess = here.x + (next - part) * slope;
    History history;
    try {
      const Orbit<double> there = newton(problem, guess, rule);
      history = there.history;
      if (sup<double>(there.x - guess) < 0.1 * here.amplitude) {
        slope = (there.x - here.x) / (next - part);
        here = there, part = next, step *= 2;
        continue;
      }
    } catch (const NewtonFailed& error) {
      history = error.history;
    }
    // It failed or went too far
    step /= 2;
    if (step > 1.0 / 4096) continue;
    char text[160];
    std::snprintf(text, sizeof text,
                  ": continuation to this chain stops at the fraction %.3g, with contacts of "
                  "exponent %.4g compressed by %.4g",
                  part, problem.chain.contact.exponent(), problem.chain.contact.opening());
    throw NewtonFailed(problem.name() + text, history);
  }
  return here;
}

}  // namespace lattice
