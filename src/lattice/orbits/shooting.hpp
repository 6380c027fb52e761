#pragma once
/**
# Periodic orbits of a chain by shooting

A breather returns after one period $T_b = 2\pi/\omega_b$,
$$y_n(T_b) = y_n(0),\qquad \dot y_n(T_b) = \dot y_n(0).$$
Taken literally these are two equations per site, with an almost singular matrix: they remain true if the
orbit is shifted in time, and nearly true if it is shifted along the chain. The symmetries of the orbit
(symmetry.hpp) remove both directions. A chain, a symmetry and a frequency give the equations for newton.hpp, with the
flow of event_driven.hpp and its exact derivative (tangent.hpp). */

#include <cmath>
#include <cstddef>
#include <string>

#include "lattice/events/tangent.hpp"
#include "lattice/model/chain.hpp"
#include "lattice/orbits/newton.hpp"
#include "lattice/orbits/symmetry.hpp"

namespace lattice {

/// The number pi in any precision.
template <class T>
T pi() {
  using std::acos;
  return acos(T(-1));
}

/// The problem of finding a periodic orbit of `chain` with `symmetry`. The contacts of a localized orbit should have
/// `negligible = 0` (contact.hpp), because the tail is part of it.
template <class T>
struct Shooting {
  Chain chain;
  Symmetry symmetry;
  T omega{};  ///< frequency, not used if the period is free

  /// 2 pi / omega.
  T period() const { return T(2) * pi<T>() / omega; }
  /// The last of the unknowns `x` if the period is free, otherwise the same.
  T period(const Vector<T>& x) const { return symmetry.free_period ? x[x.size() - 1] : period(); }
  std::string name() const;  ///< what messages call the orbit
  /// The state of the whole chain at t = 0 from the unknowns.
  State<T> expand(const Vector<T>& x) const;
  /// The unknowns of a state; a free period is taken from its time.
  Vector<T> reduce(const State<T>& state) const;
  /// The sizes to which residuals and steps are relative (newton.hpp).
  Sizes<T> sizes(const Vector<T>& x, bool scaled) const;
  /// Integrates over the part of a period that the symmetry leaves; residuals of the equations, with the
  /// derivative, one row an equation, if it is wanted.
  Evaluation<T> evaluate(const Vector<T>& x, const EventTolerance<T>& rule,
                         bool with_jacobian = true) const;
  /// The equations for Newton's method, which does not go to rest; they hold a copy of the problem.
  Equations<T> equations() const;
  /// The residuals from the states at both ends of the integration, however it was made.
  Vector<T> residuals(const State<T>& start, const State<T>& end) const;
  /// Their derivative from the tangents at both ends, one column an unknown; that of a free period is zero.
  Matrix<T> slopes(const Tangent<T>& start, const Tangent<T>& end) const;
};

/// How far the beads get from a state, in an oscillation of frequency `omega`: the largest velocity divided by it, or
/// acceleration divided by its square. It vanishes at every equilibrium, shifted or compressed.
template <class T>
T reach(const Chain& chain, const State<T>& state, const std::type_identity_t<T>& omega);

/// What programs want to know of a solution. Orbits of neighbouring frequencies form a branch, along which the unknowns
/// change by `x_omega` per unit of frequency. The action integral is $\mathcal A = \oint\sum_n\mu_n\dot y_n^2\,dt$ over the
/// period.
template <class T>
struct Orbit {
  Vector<T> x;        ///< unknowns at t = 0, see Shooting::expand
  Vector<T> x_omega;  ///< their derivative along the branch; empty where the period is an unknown
  State<T> start;     ///< the chain at t = 0
  T omega{}, energy{}, action_integral{};
  T energy_omega{};         ///< derivative of the energy along the branch
  T amplitude{};            ///< largest modulus of positions and velocities at t = 0
  Matrix<double> jacobian;  ///< of the equations, for another `newton`
  History history;
  T error{};  ///< of the flow, by its own estimate, relative to the amplitude
  /// The last residual, relative to the amplitude.
  double residual() const { return history.back().residual; }
  /// Newton steps that were made.
  std::size_t iterations() const { return history.size() - 1; }
  /// The last step, relative to the amplitude.
  double variation() const {
    return history.back().step > 0 ? history.back().step : history[iterations() - 1].step;
  }
  T period() const { return T(2) * pi<T>() / omega; }
};

/// The orbit near the guess `x`, which has as many entries as the problem has unknowns (`reduce` makes them
/// from a state). Throws NewtonFailed.
template <class T>
Orbit<T> newton(const Shooting<T>& problem, const Vector<T>& x, const NewtonRule<T>& rule = {});

/// The orbit near another one, of this or of a coarser precision, whose derivative serves: each step gains about twelve
/// digits, and the columns of the tangent, which take most of the time, are not computed. If that does not converge the
/// method starts again with its own. Throws NewtonFailed if that fails.
template <class T, class From>
Orbit<T> newton(const Shooting<T>& problem, const Orbit<From>& from,
                const NewtonRule<T>& rule = {});

}  // namespace lattice
