#pragma once
/**
# Following a branch

Breathers come in families, and a family is a curve in the space of the unknowns and one parameter: the
frequency, the anharmonicity, or any other number on which the problem depends. If we prescribed the
parameter and solved for the rest, we should be lost where the curve turns back in it (a *fold*). So we
follow the curve by its arclength: a step along the tangent, then Newton's method on the equations
together with the condition that the correction be perpendicular to the tangent. The parameter is an
unknown like the others, and a fold is nothing special. */

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

#include "lattice/numerics/estimate.hpp"
#include "lattice/orbits/shooting.hpp"

namespace lattice {

/**
The families of the article begin at $\omega_b = 1$ with breathers of vanishing amplitude. Their positions
are proportional to $\epsilon = (2\tau_0(\omega_b-1))^2$, Eq. (20), and nearly constant in units of it.
Along the frequency we therefore follow $\xi$ and $\ell$, with
$$y = (\omega_b-1)^2\,\xi,\qquad \omega_b = 1 + e^{\ell};$$
in these coordinates the small-amplitude limit (the DpS equation, dps.hpp) is a straight line. With another
exponent $\alpha$ of the contact force the power is $1/(\alpha-1)$ in place of 2. Any other parameter is itself
the coordinate $\ell$. The derivative with respect to the frequency is exact; with respect to another parameter
it is a central difference, whose error affects only how fast the corrector converges and how long the steps
are. */
template <class T>
struct Along {
  std::string name;                                 ///< for messages
  std::function<T(const Shooting<T>&)> get;         ///< reads it from a problem,
  std::function<void(Shooting<T>&, const T&)> set;  ///< and writes it there
  double change = 0;  ///< of the central difference; 0 for the frequency
  double power = 2;   ///< of omega_b - 1 in the unit of the unknowns

  /// Whether the parameter is the frequency, for which the coordinates are those of the limit.
  bool is_frequency() const { return change == 0; }
  /// By what the unknowns are multiplied at `ell`: this power of omega_b - 1, else one.
  T scale(T ell) const {
    using std::exp;
    return is_frequency() ? exp(T(power) * ell) : T(1);
  }
  /// The parameter at `ell`.
  T parameter(T ell) const {
    using std::exp;
    return is_frequency() ? T(1) + exp(ell) : ell;
  }
  /// ell for this parameter; a frequency must be above one.
  T coordinate(T parameter) const {
    using std::log;
    return is_frequency() ? log(parameter - T(1)) : parameter;
  }
  /// The problem at another value of the parameter.
  Shooting<T> at(Shooting<T> problem, const T& value) const {
    set(problem, value);
    return problem;
  }
};

/**
Two parameters serve most programs; any other can be written in the same way. */
/// Along the frequency omega_b, for contacts of exponent `alpha`.
template <class T>
Along<T> along_omega(double alpha = 1.5) {
  return {"omega_b", [](const Shooting<T>& p) { return p.omega; },
          [](Shooting<T>& p, const T& omega) { p.omega = omega; }, 0, 1 / (alpha - 1)};
}

/// Along the anharmonicity s of a quartic well.
template <class T>
Along<T> along_s() {
  return {"s", [](const Shooting<T>& p) { return T(p.chain.well.template as<Quartic>().s); },
          [](Shooting<T>& p, const T& s) { p.chain.well = Quartic{double(s)}; }, 1.0 / 1024};
}

/// How long the steps are and how accurate the points. Six corrections are enough if a step is not too long.
struct Stride {
  /// Lengths in the space of (xi, ell), where xi is scaled to a maximum of one.
  double first = 0.1, least = 1e-4, most = 0.4;
  double tolerance = 1e-9;  ///< relative residual of the points on the curve
  int corrections = 6;      ///< at most, for one step
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
template <class T>
class Branch {
 public:
  /// Begins at a converged orbit and moves towards larger parameters if `direction` > 0.
  Branch(Shooting<T> problem, Along<T> which, const Orbit<T>& start, int direction,
         NewtonRule<T> rule = {}, Stride stride = {});

  /// The parameter at the point where the branch stands.
  T parameter() const { return along_.parameter(ell(z_)); }
  /// How the parameter changes along the curve; its sign changes at a fold.
  T slope() const { return tangent_[tangent_.size() - 1]; }
  /// Takes one step; throws NewtonFailed if even the shortest one fails.
  void advance();
  /// Follows the branch through its next fold and returns the extreme parameter, from steps that are `finer` times
  /// shorter than those of the branch; throws NoBranch if there is none within `most_steps`.
  T fold(double finer = 16, int most_steps = 400);
  /// Follows the branch up to `target` and converges there to the accuracy of `rule`; throws NoBranch
  /// if the branch turns back before.
  Orbit<T> orbit_at(T target, int most_steps = 400);
  /// The problem with the parameter of that point.
  Shooting<T> problem() const { return along_.at(problem_, parameter()); }
  /// The unknowns there.
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
  At a point of the curve we need an evaluation, its derivative with respect to the parameter and the bordered
  matrix; `correct` moves a predicted point onto the curve. */
  Evaluation<T> evaluate_at(const Vector<T>& z) const;
  Matrix<T> bordered(const Vector<T>& z, const Evaluation<T>& here, const Vector<T>& border) const;
  Vector<T> parameter_derivative(const Vector<T>& z, const Evaluation<T>& here) const;
  bool correct(Vector<T>& z, const Vector<T>& tangent, Vector<T>& next_tangent);

  Shooting<T> problem_;
  Along<T> along_;
  NewtonRule<T> rule_;
  Stride stride_;
  double length_;
  Vector<T> unit_, z_, tangent_, before_;
  History history_;
  int used_ = 0;
};

/// The parameter at the next fold, with the error that steps of two lengths tell. Throws NoBranch.
Estimate fold_of(const Branch<double>& branch);

}  // namespace lattice
