#pragma once
/**
# Periodic orbits of a chain by shooting

A breather returns after one period $T_b = 2\pi/\omega_b$,
$$y_n(T_b) = y_n(0),\qquad \dot y_n(T_b) = \dot y_n(0).$$
Taken literally these are two equations per site, with an almost singular matrix: they remain true if the
orbit is shifted in time, and nearly true if it is shifted along the chain. The symmetries of the orbit
(symmetry.hpp) remove both directions and leave less to compute.

A chain, a symmetry and a frequency make a problem in the sense of newton.hpp. The flow is that of
landing.hpp, with its exact derivative (tangent.hpp). */

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "lattice/landing/landing.hpp"
#include "lattice/landing/tangent.hpp"
#include "lattice/model/chain.hpp"
#include "lattice/orbits/newton.hpp"
#include "lattice/orbits/symmetry.hpp"

namespace lattice {

/// The number pi in any precision.
template <class T>
T circle_ratio() {
  using std::acos;
  return acos(T(-1));
}

/// A number well above the smallest one of the type, which stands for a size that has vanished.
template <class T>
T vanishing() {
  if constexpr (std::is_floating_point_v<T>)
    return T(1024) * std::numeric_limits<T>::min();
  else
    return T(1e-300);
}

/**
The derivative of a flight is wanted for some directions only. Its tangent has one column for each
direction in a basis. */
template <class T>
Tangent<T> tangent_of(const Basis& basis, std::size_t sites) {
  Tangent<T> tangent(sites, basis.size());
  std::fill(tangent.entries.begin(), tangent.entries.end(), T(0));
  for (std::size_t k = 0; k < basis.size(); ++k)
    for (const Term& term : basis[k]) tangent(term.index, k) = T(term.sign);
  return tangent;
}

/**
In a symmetry the entries of a state are numbered from 0 to $2N-1$, first positions, then velocities.
`entry` finds them. */
template <class T>
const T& entry(const State<T>& state, std::size_t i) {
  const std::size_t n = state.y.size();
  return i < n ? state.y[i] : state.v[i - n];
}
template <class T>
T& entry(State<T>& state, std::size_t i) {
  const std::size_t n = state.y.size();
  return i < n ? state.y[i] : state.v[i - n];
}

/**
## The problem

A `Shooting` is the problem of finding a periodic orbit of `chain` with `symmetry`. The contacts of a
localized orbit should have `floor = 0` (contact.hpp), because the tail is part of it. If the period is
free it is the last unknown, and `omega` is not used. */
template <class T, class Onsite, class Contact>
struct Shooting {
  using Scalar = T;
  Chain<Onsite, Contact> chain;
  Symmetry symmetry;
  T omega{};

  T period() const { return T(2) * circle_ratio<T>() / omega; }
  T period(const Vector<T>& x) const { return symmetry.free_period ? x[x.size() - 1] : period(); }
  std::string name() const;
  State<T> unfold(const Vector<T>& x) const;
  Vector<T> fold(const State<T>& state) const;
  Sizes<T> sizes(const Vector<T>& x, bool graded) const;
  Shot<T> shoot(const Vector<T>& x, const Landing<T>& rule, bool with_jacobian = true) const;
  /// By how much a flight from `start` to `end`, however it was computed, misses the equations.
  Vector<T> residuals(const State<T>& start, const State<T>& end) const;
};

/**
If Newton's method fails, its message names the orbit that was looked for. */
template <class T, class Onsite, class Contact>
std::string Shooting<T, Onsite, Contact>::name() const {
  char text[96];
  if (symmetry.free_period)
    std::snprintf(text, sizeof text, "%s orbit", symmetry.name.c_str());
  else
    std::snprintf(text, sizeof text, "%s orbit at omega_b = %.6g", symmetry.name.c_str(),
                  double(omega));
  return text;
}

/**
The lists of the symmetry translate unknowns into a state and back. */
/// The state at t = 0 that belongs to the unknowns.
template <class T, class Onsite, class Contact>
State<T> Shooting<T, Onsite, Contact>::unfold(const Vector<T>& x) const {
  State<T> state(chain.sites);
  for (std::size_t k = 0; k < symmetry.unknowns.size(); ++k)
    for (const Term& term : symmetry.unknowns[k])
      entry(state, term.index) += T(term.sign) * x[Eigen::Index(k)];
  return state;
}

/// The unknowns of a state; its time is taken for the period if that is free.
template <class T, class Onsite, class Contact>
Vector<T> Shooting<T, Onsite, Contact>::fold(const State<T>& state) const {
  const std::size_t m = symmetry.unknowns.size();
  Vector<T> x(Eigen::Index(m + (symmetry.free_period ? 1 : 0)));
  for (std::size_t k = 0; k < m; ++k) {
    const Term& term = symmetry.unknowns[k].front();
    x[Eigen::Index(k)] = T(term.sign) * entry(state, term.index);
  }
  if (symmetry.free_period) x[Eigen::Index(m)] = state.t;
  return x;
}

/**
## Sizes

Newton's method wants to know how large each unknown is. The local size of an orbit is the larger of
position and velocity at the start. A guess may be zero in the tail, where the breather is not; there
the law $|y_{n+1}|\sim|y_n|^{3/2}$ of the tail, divided by 16 to be on the safe side, supplies a least
size, from the largest site outwards. */
template <class T>
std::vector<T> local_sizes(const State<T>& state) {
  using std::sqrt;
  const std::size_t n = state.y.size();
  std::vector<T> size(n);
  std::size_t top = 0;
  for (std::size_t i = 0; i < n; ++i) {
    size[i] = std::max(magnitude(state.y[i]), magnitude(state.v[i]));
    if (size[i] > size[top]) top = i;
  }
  const auto tail = [&](std::size_t i, std::size_t inner) {
    const T law = (size[inner] < T(1) ? sqrt(size[inner]) : T(1)) * size[inner] / T(16);
    size[i] = std::max({size[i], law, vanishing<T>()});
  };
  for (std::size_t i = top + 1; i < n; ++i) tail(i, i - 1);
  for (std::size_t i = top; i-- > 0;) tail(i, i + 1);
  return size;
}

/**
Unknowns and equations have the size of the site that they name first; a free period has the size one.
Unless `graded`, and for orbits that do not decay in space, the amplitude of the orbit serves for all. */
template <class T, class Onsite, class Contact>
Sizes<T> Shooting<T, Onsite, Contact>::sizes(const Vector<T>& x, bool graded) const {
  const State<T> start = unfold(x);
  const std::size_t n = chain.sites;
  const std::vector<T> local =
      graded && symmetry.decays ? local_sizes(start) : std::vector<T>(n, largest(start));
  Sizes<T> out;
  out.unknown = Vector<T>::Ones(x.size());
  out.equation.resize(Eigen::Index(symmetry.equations.size()));
  for (std::size_t k = 0; k < symmetry.unknowns.size(); ++k)
    out.unknown[Eigen::Index(k)] = local[symmetry.unknowns[k].front().index % n];
  for (std::size_t i = 0; i < symmetry.equations.size(); ++i)
    out.equation[Eigen::Index(i)] = local[symmetry.equations[i].end.front().index % n];
  return out;
}

/**
## A shot

First the residuals, for which the two ends of a flight are enough. */
template <class T, class Onsite, class Contact>
Vector<T> Shooting<T, Onsite, Contact>::residuals(const State<T>& start,
                                                  const State<T>& end) const {
  Vector<T> miss = Vector<T>::Zero(Eigen::Index(symmetry.equations.size()));
  for (std::size_t i = 0; i < symmetry.equations.size(); ++i) {
    T& sum = miss[Eigen::Index(i)];
    for (const Term& term : symmetry.equations[i].end) sum += T(term.sign) * entry(end, term.index);
    for (const Term& term : symmetry.equations[i].start)
      sum += T(term.sign) * entry(start, term.index);
  }
  return miss;
}

/**
Residuals are combinations of entries of the state, so the rows of their Jacobian are the same
combinations of rows of the tangent. */
template <class T>
void add_slopes_of(const Symmetry& symmetry, const Tangent<T>& begin, const Tangent<T>& end,
                   Matrix<T>& jacobian) {
  for (std::size_t i = 0; i < symmetry.equations.size(); ++i)
    for (std::size_t k = 0; k < symmetry.unknowns.size(); ++k) {
      T& sum = jacobian(Eigen::Index(i), Eigen::Index(k));
      for (const Term& term : symmetry.equations[i].end) sum += T(term.sign) * end(term.index, k);
      for (const Term& term : symmetry.equations[i].start)
        sum += T(term.sign) * begin(term.index, k);
    }
}

/**
A shot carries one column of the tangent for each unknown and no others. A change of the period by
$\delta T$ moves the end of the flight along the orbit: by its rate of change there times $\delta T$ over
the number of parts. */
template <class T, class Onsite, class Contact>
Shot<T> Shooting<T, Onsite, Contact>::shoot(const Vector<T>& x, const Landing<T>& rule,
                                            bool with_jacobian) const {
  const State<T> start = unfold(x);
  State<T> z = start;
  const Tangent<T> first =
      with_jacobian ? tangent_of<T>(symmetry.unknowns, chain.sites) : Tangent<T>(0, 0);
  Tangent<T> tangent = first;
  Shot<T> shot;
  shot.flow =
      flow(chain, z, period(x) / T(symmetry.parts), rule, with_jacobian ? &tangent : nullptr);
  State<T> rate(chain.sites);
  rate.y = z.v;
  rate.v = accelerations(chain, z.y);
  shot.miss = residuals(start, z);
  shot.miss_period = residuals(State<T>(chain.sites), rate) / T(symmetry.parts);
  if (!with_jacobian) return shot;
  shot.jacobian = Matrix<T>::Zero(shot.miss.size(), x.size());
  add_slopes_of(symmetry, first, tangent, shot.jacobian);
  if (symmetry.free_period) shot.jacobian.col(x.size() - 1) = shot.miss_period;
  return shot;
}

/**
## The orbit

An orbit is what programs want to know of a solution. Orbits of neighbouring frequencies form a branch,
along which the unknowns change by `x_omega` per unit of frequency; with forces and velocities this gives
the derivative of the energy. The area is $\mathcal A = \oint\sum_n\mu_n\dot y_n^2\,dt$ over the whole
period. */
template <class T>
struct Orbit {
  Vector<T> x;        ///< unknowns at t = 0, see Shooting::unfold
  Vector<T> x_omega;  ///< their derivative along the branch; empty where the period is an unknown
  State<T> start;     ///< the chain at t = 0
  T omega{}, energy{}, area{};
  T energy_omega{};         ///< derivative of the energy along the branch
  T amplitude{};            ///< largest modulus of positions and velocities at t = 0
  Matrix<double> jacobian;  ///< of the equations, for `polish`
  History history;
  std::size_t switchings = 0;  ///< in the part of a period that was computed
  T error{};                   ///< of the flow, by its own estimate, relative to the amplitude
  double residual() const { return history.back().residual; }
  std::size_t iterations() const { return history.size() - 1; }
  /// The last step, relative to the amplitude.
  double variation() const {
    return history.back().step > 0 ? history.back().step : history[iterations() - 1].step;
  }
  T period() const { return T(2) * circle_ratio<T>() / omega; }
};

/**
Everything but the two derivatives is read off the last shot; the area of the period is that of the
computed part times the number of parts. */
template <class T, class Onsite, class Contact>
Orbit<T> describe(const Shooting<T, Onsite, Contact>& problem, const Solution<T>& found) {
  Orbit<T> orbit;
  orbit.x = found.x;
  orbit.start = problem.unfold(found.x);
  orbit.omega = T(2) * circle_ratio<T>() / problem.period(found.x);
  if (!problem.symmetry.free_period) orbit.omega = problem.omega;
  orbit.energy = energy(problem.chain, orbit.start);
  orbit.area = T(problem.symmetry.parts) * found.shot.flow.area;
  orbit.amplitude = largest(orbit.start);
  orbit.history = found.history;
  orbit.switchings = found.shot.flow.switchings;
  orbit.error = found.shot.flow.error;
  return orbit;
}

/**
Along the branch the energy changes by minus the forces times the change of the positions, and by the
momenta times the change of the velocities. */
template <class T, class Onsite, class Contact>
void add_slopes(const Shooting<T, Onsite, Contact>& problem, const Vector<T>& x_omega,
                Orbit<T>& orbit) {
  orbit.x_omega = x_omega;
  const std::vector<T> a = accelerations(problem.chain, orbit.start.y);
  const State<T> rate = problem.unfold(x_omega);
  orbit.energy_omega = T(0);
  for (std::size_t n = 0; n < a.size(); ++n)
    orbit.energy_omega +=
        T(problem.chain.mass_of(n)) * (orbit.start.v[n] * rate.v[n] - a[n] * rate.y[n]);
}

/**
Most programs call only what follows: a problem, a guess, and Newton's method does the rest. The change
along the branch comes almost for free, from the same matrix. */
/// The orbit near the guess `x`, which has as many entries as the problem has unknowns (`fold` makes them
/// from a state). Throws NoConvergence.
template <class T, class Onsite, class Contact>
Orbit<T> newton(const Shooting<T, Onsite, Contact>& problem, const Vector<T>& x,
                const NewtonRule<T>& rule = {}) {
  const Solution<T> found = solve(problem, x, rule);
  Orbit<T> orbit = describe(problem, found);
  orbit.jacobian = found.shot.jacobian.template cast<double>();
  if (problem.symmetry.free_period) return orbit;
  const T longer = -problem.period() / problem.omega;  // derivative of the period
  add_slopes<T>(problem,
                -solve_scaled<T>(found.shot.jacobian, longer * found.shot.miss_period,
                                 problem.sizes(found.x, true), rule.rank),
                orbit);
  return orbit;
}

/**
## The same orbit in another precision

Digits are confirmed by computing an orbit again in a wider type. If double precision has found it, the
wider type needs no derivative of its own: with the old one each step gains as many digits as the
derivative has, about twelve, and the columns of the tangent, which take most of the time, are not
computed. If this does not converge, Newton's method takes over. Throws NoConvergence if that fails. */
template <class T, class Onsite, class Contact, class From>
Orbit<T> polish(const Shooting<T, Onsite, Contact>& problem, const Orbit<From>& from,
                const NewtonRule<T>& rule = {}) {
  const Vector<T> guess = from.x.template cast<T>();
  Solution<T> found;
  try {
    found = iterate(problem, guess, rule, false, [&](const Shot<T>& shot, const Vector<T>& at) {
      const Sizes<T> size = problem.sizes(at, true);
      return solve_scaled<T>(from.jacobian.template cast<T>(), shot.miss, size, rule.rank);
    });
  } catch (const NoConvergence&) {
    return newton(problem, guess, rule);
  }
  Orbit<T> orbit = describe(problem, found);
  orbit.jacobian = from.jacobian;
  if (from.x_omega.size() > 0) add_slopes<T>(problem, from.x_omega.template cast<T>(), orbit);
  return orbit;
}

}  // namespace lattice
