#pragma once
/**
# Following a branch

A family of breathers is a curve in the space of the unknowns and one parameter: the frequency, the anharmonicity, or
any other number on which the problem depends. If the parameter were prescribed, we should be lost where the curve turns
back in it (a *fold*). So we follow the curve by its arclength: a step along the tangent, then Newton's method on the
equations together with the condition that the correction be perpendicular to the tangent. The parameter is an
unknown like the others. */

#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>

#include "lattice/numerics/estimate.hpp"
#include "lattice/orbits/shooting.hpp"

namespace lattice {

/**
The families of the article begin at $\omega_b = 1$ with breathers of vanishing amplitude, proportional to
$\epsilon = (2\tau_0(\omega_b-1))^2$, Eq. (20). Along the frequency we therefore follow $\xi$ and $\ell$, with
$$y = (\omega_b-1)^2\,\xi,\qquad \omega_b = 1 + e^{\ell};$$
in these coordinates the small-amplitude limit (the DpS equation) is a straight line. With another
exponent $\alpha$ of the contact force the power is $1/(\alpha-1)$ in place of 2. Any other parameter is itself
the coordinate $\ell$. The derivative with respect to the frequency is exact; with respect to another parameter
it is a central difference, whose error affects only how fast the corrector converges. */
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

/// Along the frequency omega_b, for contacts of exponent `alpha`.
template <class T>
Along<T> along_omega(double alpha = 1.5) {
  return {"omega_b", [](const Shooting<T>& p) { return p.omega; },
          [](Shooting<T>& p, const T& omega) { p.omega = omega; }, 0, 1 / (alpha - 1)};
}

/// Along the anharmonicity s of a quartic well.
template <class T>
Along<T> along_s() {
  return {"s", [](const Shooting<T>& p) { return T(std::get<Quartic>(p.chain.well.kind).s); },
          [](Shooting<T>& p, const T& s) { p.chain.well = Quartic{double(s)}; }, 1.0 / 1024};
}

/// Lengths of the steps in the space of (xi, ell), where xi is scaled to a maximum of one.
struct Stride {
  double first = 0.1, least = 1e-4, most = 0.4;
};

/// Thrown if the branch ends or turns back before the parameter that was asked for.
struct NoBranch : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Stands at a point of the curve and can take a step.
class Branch {
 public:
  /// Begins at a converged orbit and moves towards larger parameters if `direction` > 0.
  Branch(Shooting<double> problem, Along<double> which, const Orbit<double>& start, int direction,
         NewtonRule<double> rule = {}, Stride stride = {});

  /// The parameter at the point where the branch stands.
  double parameter() const { return along_.parameter(ell(z_)); }
  /// How the parameter changes along the curve; its sign changes at a fold.
  double slope() const { return tangent_[tangent_.size() - 1]; }
  /// Takes one step; throws NewtonFailed if even the shortest one fails.
  void advance();
  /// Follows the branch through its next fold and returns the extreme parameter, from steps that are `finer` times
  /// shorter than those of the branch; throws NoBranch if there is none within the steps allowed.
  double fold(double finer = 16);
  /// Follows the branch up to `target` and converges there to the accuracy of `rule`; throws NoBranch
  /// if the branch turns back before.
  Orbit<double> orbit_at(double target);
  /// The problem with the parameter of that point.
  Shooting<double> problem() const { return along_.at(problem_, parameter()); }
  /// The unknowns there.
  Vector<double> unknowns() const { return unknowns(z_); }

 private:
  static double ell(const Vector<double>& z) { return z[z.size() - 1]; }
  Vector<double> unknowns(const Vector<double>& z) const {
    return along_.scale(ell(z)) * unit_.cwiseProduct(z.head(z.size() - 1));
  }
  /// The size of each equation at a point of the curve.
  Vector<double> amplitude(const Vector<double>& z) const {
    return problem_.sizes(unknowns(z), false).equation;
  }
  /// The direction in which the equations stay true, by the last row of a bordered matrix.
  Vector<double> along(const Matrix<double>& all) const;
  Evaluation<double> evaluate_at(const Vector<double>& z) const;
  Matrix<double> bordered(const Vector<double>& z, const Evaluation<double>& here,
                          const Vector<double>& border) const;
  Vector<double> parameter_derivative(const Vector<double>& z,
                                      const Evaluation<double>& here) const;
  bool correct(Vector<double>& z, const Vector<double>& tangent, Vector<double>& next_tangent);

  Shooting<double> problem_;
  Along<double> along_;
  NewtonRule<double> rule_;
  Stride stride_;
  double length_;
  Vector<double> unit_;                  ///< of xi, whose maximum at the first point is one
  Vector<double> z_, tangent_, before_;  ///< xi and, as the last entry, ell
  History history_;
  int used_ = 0;
};

/// The parameter at the next fold, with the error that steps of two lengths tell. Throws NoBranch.
Estimate fold_of(const Branch& branch);

/**
## Other chains

The quasi-continuum profile knows exponents of contacts but neither compression nor masses: such breathers are reached
on a path from a chain whose breather is known, at one frequency. */
/// The orbit of `problem` followed to the chain `target` at fixed frequency. A step is halved if it fails or goes
/// farther than a tenth of the amplitude, which may lead to another family, and doubled otherwise. Throws NewtonFailed
/// where the branch folds back, with how far the path went; std::invalid_argument if the lengths differ.
Orbit<double> continue_to(Shooting<double> problem, const Orbit<double>& from, const Chain& target);

}  // namespace lattice
