#pragma once
#include "lattice/orbits/shooting.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <type_traits>
#include <vector>

namespace lattice {

/// The tangent at the start: one column for each direction of the basis.
template <class T>
Tangent<T> tangent_of(const Basis& basis, std::size_t sites) {
  Tangent<T> tangent(sites, basis.size());
  std::fill(tangent.entries.begin(), tangent.entries.end(), T(0));
  for (std::size_t k = 0; k < basis.size(); ++k)
    for (const Term& term : basis[k]) tangent(term.index, k) = T(term.sign);
  return tangent;
}

template <class T>
std::string Shooting<T>::name() const {
  char text[96];
  if (symmetry.free_period)
    std::snprintf(text, sizeof text, "%s orbit", symmetry.name.c_str());
  else
    std::snprintf(text, sizeof text, "%s orbit at omega_b = %.6g", symmetry.name.c_str(),
                  double(omega));
  return text;
}

/// Entry `i` of a state, from 0 to $2N-1$, first positions, then velocities.
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

// From unknowns to a state and back
template <class T>
State<T> Shooting<T>::expand(const Vector<T>& x) const {
  State<T> state(chain.sites);
  for (std::size_t k = 0; k < symmetry.unknowns.size(); ++k)
    for (const Term& term : symmetry.unknowns[k])
      entry(state, term.index) += T(term.sign) * x[Eigen::Index(k)];
  return state;
}

template <class T>
Vector<T> Shooting<T>::reduce(const State<T>& state) const {
  const std::size_t m = symmetry.unknowns.size();
  Vector<T> x(Eigen::Index(m + (symmetry.free_period ? 1 : 0)));
  for (std::size_t k = 0; k < m; ++k) {
    const Term& term = symmetry.unknowns[k].front();
    x[Eigen::Index(k)] = T(term.sign) * entry(state, term.index);
  }
  if (symmetry.free_period) x[Eigen::Index(m)] = state.t;
  return x;
}

/// The local size of an orbit is the larger of position and velocity at the start. Where a guess is zero and the
/// breather is not, the law $|y_{n+1}|\sim|y_n|^\alpha$ of the tail, divided by 16, supplies a least size.
template <class T>
std::vector<T> local_sizes(const State<T>& state, double alpha) {
  using std::pow, std::sqrt;
  const std::size_t n = state.y.size();
  std::vector<T> size(n);
  std::size_t top = 0;
  for (std::size_t i = 0; i < n; ++i) {
    size[i] = std::max(magnitude(state.y[i]), magnitude(state.v[i]));
    if (size[i] > size[top]) top = i;
  }
  // A number well above the smallest one of the type stands for a size that has vanished
  T least(1e-300);
  if constexpr (std::is_floating_point_v<T>) least = T(1024) * std::numeric_limits<T>::min();
  const auto tail = [&](std::size_t i, std::size_t inner) {
    const T part = alpha == 1.5 ? sqrt(size[inner]) : pow(size[inner], T(alpha - 1));
    const T law = (size[inner] < T(1) ? part : T(1)) * size[inner] / T(16);
    size[i] = std::max({size[i], law, least});
  };
  for (std::size_t i = top + 1; i < n; ++i) tail(i, i - 1);
  for (std::size_t i = top; i-- > 0;) tail(i, i + 1);
  return size;
}

/// Unknowns and equations have the size of the site that they name first; a free period has the size one.
/// Unless `scaled`, for orbits that do not decay in space and between compressed beads, whose linear tail no law tells
/// beforehand, the amplitude of the orbit serves for all.
template <class T>
Sizes<T> Shooting<T>::sizes(const Vector<T>& x, bool scaled) const {
  const State<T> start = expand(x);
  const std::size_t n = chain.sites;
  const bool falls = symmetry.decays && !(chain.contact.stiffness(0.0) > 0);
  const std::vector<T> local = scaled && falls ? local_sizes(start, chain.contact.exponent())
                                               : std::vector<T>(n, largest(start));
  Sizes<T> out;
  out.unknown = Vector<T>::Ones(x.size());
  out.equation.resize(Eigen::Index(symmetry.equations.size()));
  for (std::size_t k = 0; k < symmetry.unknowns.size(); ++k)
    out.unknown[Eigen::Index(k)] = local[symmetry.unknowns[k].front().index % n];
  for (std::size_t i = 0; i < symmetry.equations.size(); ++i)
    out.equation[Eigen::Index(i)] = local[symmetry.equations[i].end.front().index % n];
  return out;
}

template <class T>
Vector<T> Shooting<T>::residuals(const State<T>& start, const State<T>& end) const {
  Vector<T> out = Vector<T>::Zero(Eigen::Index(symmetry.equations.size()));
  for (std::size_t i = 0; i < symmetry.equations.size(); ++i) {
    T& sum = out[Eigen::Index(i)];
    for (const Term& term : symmetry.equations[i].end) sum += T(term.sign) * entry(end, term.index);
    for (const Term& term : symmetry.equations[i].start)
      sum += T(term.sign) * entry(start, term.index);
  }
  return out;
}

// Residuals are combinations of entries of the state, and the rows of their Jacobian the same ones of the tangent
template <class T>
Matrix<T> Shooting<T>::slopes(const Tangent<T>& start, const Tangent<T>& end) const {
  const std::size_t rows = symmetry.equations.size(), columns = symmetry.unknowns.size();
  Matrix<T> out =
      Matrix<T>::Zero(Eigen::Index(rows), Eigen::Index(columns + (symmetry.free_period ? 1 : 0)));
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t k = 0; k < columns; ++k) {
      T& sum = out(Eigen::Index(i), Eigen::Index(k));
      for (const Term& term : symmetry.equations[i].end) sum += T(term.sign) * end(term.index, k);
      for (const Term& term : symmetry.equations[i].start)
        sum += T(term.sign) * start(term.index, k);
    }
  return out;
}

// A change of the period moves the end of the integration along the orbit, by its rate of change there over `parts`
template <class T>
Evaluation<T> Shooting<T>::evaluate(const Vector<T>& x, const EventTolerance<T>& rule,
                                    bool with_jacobian) const {
  const State<T> start = expand(x);
  State<T> z = start;
  const Tangent<T> first =
      with_jacobian ? tangent_of<T>(symmetry.unknowns, chain.sites) : Tangent<T>(0, 0);
  Tangent<T> tangent = first;
  Evaluation<T> out;
  out.flow =
      try_flow(chain, z, period(x) / T(symmetry.parts), rule, with_jacobian ? &tangent : nullptr);
  State<T> rate(chain.sites);
  rate.y = z.v;
  rate.v = accelerations(chain, z.y);
  out.residual = residuals(start, z);
  out.residual_period = residuals(State<T>(chain.sites), rate) / T(symmetry.parts);
  if (!with_jacobian) return out;
  out.jacobian = slopes(first, tangent);
  if (symmetry.free_period) out.jacobian.col(x.size() - 1) = out.residual_period;
  return out;
}

template <class T>
Equations<T> Shooting<T>::equations() const {
  const State<T> rest(chain.sites);
  return {name(),
          [*this](const Vector<T>& x, const EventTolerance<T>& rule, bool derivative) {
            return evaluate(x, rule, derivative);
          },
          [*this](const Vector<T>& x, bool scaled) { return sizes(x, scaled); },
          [*this, rest](const Vector<T>& x) { return largest_difference(expand(x), rest); },
          [*this](const Vector<T>& x) {
            return lattice::reach(chain, expand(x), T(2) * pi<T>() / period(x));
          }};
}

// An equilibrium has no accelerations, wherever it is
template <class T>
T reach(const Chain& chain, const State<T>& state, const std::type_identity_t<T>& omega) {
  const std::vector<T> a = accelerations(chain, state.y);
  T most(0);
  for (std::size_t n = 0; n < a.size(); ++n)
    most = std::max({most, magnitude<T>(state.v[n] / omega), magnitude<T>(a[n] / (omega * omega))});
  return most;
}

/// All but the two derivatives; the action integral of the period is that of the computed part times the number of parts.
template <class T>
Orbit<T> describe(const Shooting<T>& problem, const Solution<T>& found) {
  Orbit<T> orbit;
  orbit.x = found.x;
  orbit.start = problem.expand(found.x);
  orbit.omega = T(2) * pi<T>() / problem.period(found.x);
  if (!problem.symmetry.free_period) orbit.omega = problem.omega;
  orbit.energy = energy(problem.chain, orbit.start);
  orbit.action_integral = T(problem.symmetry.parts) * found.evaluation.flow.action_integral;
  orbit.amplitude = largest(orbit.start);
  orbit.history = found.history;
  orbit.error = found.evaluation.flow.error;
  return orbit;
}

/// Along the branch the energy changes by minus the forces times the change of the positions, and by the
/// momenta times the change of the velocities.
template <class T>
void add_slopes(const Shooting<T>& problem, const Vector<T>& x_omega, Orbit<T>& orbit) {
  orbit.x_omega = x_omega;
  const std::vector<T> a = accelerations(problem.chain, orbit.start.y);
  const State<T> rate = problem.expand(x_omega);
  orbit.energy_omega = T(0);
  for (std::size_t n = 0; n < a.size(); ++n)
    orbit.energy_omega +=
        T(problem.chain.mass_of(n)) * (orbit.start.v[n] * rate.v[n] - a[n] * rate.y[n]);
}

// Solve for the orbit, then differentiate along the branch: a change of frequency changes the
// period, and one more solution with the same Jacobian says how the start must follow
template <class T>
Orbit<T> newton(const Shooting<T>& problem, const Vector<T>& x, const NewtonRule<T>& rule) {
  const Solution<T> found = newton(problem.equations(), x, rule);
  Orbit<T> orbit = describe(problem, found);
  orbit.jacobian = found.evaluation.jacobian.template cast<double>();
  if (problem.symmetry.free_period) return orbit;
  const T longer = -problem.period() / problem.omega;  // derivative of the period
  add_slopes<T>(
      problem,
      -solve_scaled<T>(found.evaluation.jacobian, longer * found.evaluation.residual_period,
                       problem.sizes(found.x, true), rule.rank, rule.scale),
      orbit);
  return orbit;
}

// More digits with the Jacobian of the coarser type; only the residual is computed in the finer one
template <class T, class From>
Orbit<T> newton(const Shooting<T>& problem, const Orbit<From>& from, const NewtonRule<T>& rule) {
  const Vector<T> guess = from.x.template cast<T>();
  const Matrix<T> derivative = from.jacobian.template cast<T>();
  Solution<T> found;
  try {
    found = newton(problem.equations(), guess, rule, &derivative);
  } catch (const NewtonFailed&) {
    return newton(problem, guess, rule);
  }
  Orbit<T> orbit = describe(problem, found);
  orbit.jacobian = from.jacobian;
  if (from.x_omega.size() > 0) add_slopes<T>(problem, from.x_omega.template cast<T>(), orbit);
  return orbit;
}

}  // namespace lattice

/// The functions of this file in a number type.
#define LATTICE_SHOOTING(T)                                                                \
  template struct Shooting<T>;                                                             \
  template T reach<T>(const Chain&, const State<T>&, const T&);                            \
  template Orbit<T> newton<T>(const Shooting<T>&, const Vector<T>&, const NewtonRule<T>&); \
  template Orbit<T> newton<T, double>(const Shooting<T>&, const Orbit<double>&,            \
                                      const NewtonRule<T>&);
