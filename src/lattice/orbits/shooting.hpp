#pragma once
/**
# Periodic orbits by shooting

A breather returns after one period $T_b = 2\pi/\omega_b$. Taken literally this gives twice as
many equations as sites, and a matrix that is almost singular: a shift in time leaves the
equations true, and a shift along the chain nearly so. The symmetries of the orbit remove
both directions and leave less to compute.

A breather that is even in time starts from rest, so the positions are the only unknowns.

- Bond-centred: $y_{1-n} = -y_n$ holds for all times once it holds at the start. Half of the
  positions are unknown, and the orbit is even about $T_b/2$ if
  $$\dot y_n(T_b/2) = 0,\qquad n \ge 1.$$
- Site-centred: the orbit is invariant under $y_n(t) \to -y_{-n}(t+T_b/2)$. Combined with evenness
  this relates the times $T_b/4 \pm t$, and with the reflection $P : n \to -n$ it is enough that
  $$(1+P)\,y(T_b/4) = 0,\qquad (1-P)\,\dot y(T_b/4) = 0,$$
  as many equations as sites, after a quarter of a period. */

#include <Eigen/Dense>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "lattice/landing/landing.hpp"
#include "lattice/landing/tangent.hpp"
#include "lattice/model/chain.hpp"
#include "lattice/model/sites.hpp"

namespace lattice {

template <class T>
using Vector = Eigen::Matrix<T, Eigen::Dynamic, 1>;
template <class T>
using Matrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;

/// The ratio of a circle's circumference to its diameter in any precision.
template <class T>
T circle_ratio() {
  using std::acos;
  return acos(T(-1));
}

/// A number far above the smallest one of the type, used where a size has vanished.
template <class T>
T vanishing() {
  if constexpr (std::is_floating_point_v<T>)
    return T(1024) * std::numeric_limits<T>::min();
  else
    return T(1e-300);
}

/// The largest modulus in a vector; infinite where anything is not a number.
template <class T>
T sup(const Vector<T>& x) {
  T most(0);
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    if (!(magnitude(x[i]) < std::numeric_limits<T>::infinity()))
      return std::numeric_limits<T>::infinity();
    most = std::max(most, magnitude(x[i]));
  }
  return most;
}

/**
What is looked for: a breather of frequency `omega` in a chain. The chain has an odd number of
sites for a site-centred breather and an even one for a bond-centred one; a contact there
should have no floor. */
template <class T, class Onsite, class Contact>
struct Shooting {
  Chain<Onsite, Contact> chain;
  Centre centre = Centre::bond;
  T omega{};

  std::size_t unknowns() const { return centre == Centre::bond ? chain.sites / 2 : chain.sites; }
  T period() const { return T(2) * circle_ratio<T>() / omega; }
  /// The part of a period that has to be computed.
  int parts() const { return centre == Centre::bond ? 2 : 4; }

  /// The resting chain with the given unknowns: the right half, or all positions.
  State<T> unfold(const Vector<T>& x) const {
    const std::size_t m = unknowns(), shift = chain.sites - m;
    State<T> state(chain.sites);
    for (std::size_t k = 0; k < m; ++k) {
      state.y[shift + k] = x[Eigen::Index(k)];
      if (centre == Centre::bond) state.y[shift - 1 - k] = -x[Eigen::Index(k)];
    }
    return state;
  }
  /// The unknowns of a resting chain.
  Vector<T> fold(const std::vector<T>& y) const {
    const std::size_t m = unknowns(), shift = chain.sites - m;
    Vector<T> x(static_cast<Eigen::Index>(m));
    for (std::size_t k = 0; k < m; ++k) x[Eigen::Index(k)] = y[shift + k];
    return x;
  }
};

/**
A shot is one integration: by how much the symmetry is missed, how this depends on the
unknowns and, exactly, on the frequency, and what the integrator says about itself. */
template <class T>
struct Shot {
  Vector<T> miss, miss_omega;
  Matrix<T> jacobian;
  Flow<T> flow;
};

/**
Both sets of equations are sums $z_i \pm z_j$ of two entries of the final state: for a bond-centred
breather an entry with itself, otherwise with its mirror image. `Pair` names them, `site_rule` and
`bond_rule` are the only places that know the two symmetries. */
struct Pair {
  std::size_t first, second;
  double sign;
};

inline std::vector<Pair> equations_of(Centre centre, std::size_t sites) {
  std::vector<Pair> pairs;
  const std::size_t n = sites, half = n / 2;
  if (centre == Centre::bond)
    for (std::size_t i = half; i < n; ++i) pairs.push_back({n + i, n + i, 0});
  else
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t mirror = n - 1 - i;
      pairs.push_back(i >= half ? Pair{i, mirror, 1} : Pair{n + i, n + mirror, -1});
    }
  return pairs;
}

/**
The columns of the tangent are the unknowns and nothing else. The final time is $c\pi/\omega_b$, so that
a change of frequency moves the end of the orbit along itself by $-\tau/\omega_b$ times the velocity. */
template <class T, class Onsite, class Contact>
Shot<T> shoot(const Shooting<T, Onsite, Contact>& problem, const Vector<T>& x,
              const Landing<T>& rule, bool with_jacobian = true) {
  const std::size_t n = problem.chain.sites, m = problem.unknowns(), shift = n - m;
  State<T> z = problem.unfold(x);
  Tangent<T> tangent(n, m);
  if (shift > 0) {
    std::fill(tangent.entries.begin(), tangent.entries.end(), T(0));
    for (std::size_t k = 0; k < m; ++k) {
      tangent(shift + k, k) = T(1);
      tangent(shift - 1 - k, k) = T(-1);
    }
  }
  const T duration = problem.period() / T(problem.parts());
  Shot<T> shot;
  shot.flow = flow(problem.chain, z, duration, rule, with_jacobian ? &tangent : nullptr);
  std::vector<T> end = z.y, rate = z.v;
  const std::vector<T> a = accelerations(problem.chain, z.y);
  end.insert(end.end(), z.v.begin(), z.v.end());
  rate.insert(rate.end(), a.begin(), a.end());

  const Eigen::Index size = static_cast<Eigen::Index>(m);
  shot.miss.resize(size);
  shot.miss_omega.resize(size);
  if (with_jacobian) shot.jacobian.resize(size, size);
  Eigen::Index row = 0;
  for (const auto& [first, second, sign] : equations_of(problem.centre, n)) {
    shot.miss[row] = end[first] + T(sign) * end[second];
    shot.miss_omega[row] = -duration / problem.omega * (rate[first] + T(sign) * rate[second]);
    for (std::size_t k = 0; with_jacobian && k < m; ++k)
      shot.jacobian(row, Eigen::Index(k)) = tangent(first, k) + T(sign) * tangent(second, k);
    ++row;
  }
  return shot;
}

/**
The tail falls double-exponentially, and an equation of the tail is smaller than one of the
centre by as many orders of magnitude as the positions are. We measure each unknown and
each equation in units of the local size of the breather; then elimination keeps every
position to the same relative accuracy. Where a guess is zero, the law $|y_{n+1}|\sim|y_n|^{3/2}$
of the tail supplies a size. */
template <class T, class Onsite, class Contact>
Vector<T> local_sizes(const Shooting<T, Onsite, Contact>& problem, const Vector<T>& x) {
  using std::sqrt;
  const State<T> state = problem.unfold(x);
  const std::size_t n = problem.chain.sites;
  std::vector<T> size(n);
  for (std::size_t right = n / 2; right < n; ++right) {
    const std::size_t left = n - 1 - right;
    T most = std::max(magnitude(state.y[left]), magnitude(state.y[right]));
    if (right > n / 2) {
      const T inner = size[right - 1];
      most = std::max(most, (inner < T(1) ? sqrt(inner) : T(1)) * inner / T(16));
    }
    size[left] = size[right] = std::max(most, vanishing<T>());
  }
  return problem.fold(size);
}

template <class T>
Vector<T> solve_graded(const Matrix<T>& jacobian, const Vector<T>& right, const Vector<T>& size) {
  Matrix<T> scaled = jacobian;
  Vector<T> scaled_right = right;
  for (Eigen::Index i = 0; i < size.size(); ++i) {
    for (Eigen::Index k = 0; k < size.size(); ++k) scaled(i, k) *= size[k] / size[i];
    scaled_right[i] /= size[i];
  }
  Vector<T> step = scaled.partialPivLu().solve(scaled_right);
  for (Eigen::Index i = 0; i < size.size(); ++i) step[i] *= size[i];
  return step;
}

/**
## Newton's method, with its history

Residual and step are relative to the largest position. With `graded` they are relative to the
local size instead, so that convergence is demanded of the tail as of the centre. */
struct Iteration {
  double residual, step;
};
using History = std::vector<Iteration>;

inline std::string to_text(const History& history) {
  std::string text;
  for (const Iteration& i : history) {
    char buffer[48];
    std::snprintf(buffer, sizeof buffer, "%s%.1e", text.empty() ? "" : ", ", i.residual);
    text += buffer;
  }
  return text;
}

/// Newton's method failed; the message contains the residuals of all iterations.
struct NoConvergence : std::runtime_error {
  History history;
  NoConvergence(const std::string& what, History steps)
      : std::runtime_error(what + "; relative residuals " + to_text(steps)),
        history(std::move(steps)) {}
};

template <class T>
struct NewtonRule {
  Landing<T> landing{};
  int most = 30;        ///< iterations
  bool graded = false;  ///< demand relative accuracy of every site
  /// A residual below which Newton may stop, as soon as it no longer falls.
  T enough() const { return T(graded ? 65536 : 64) * landing.tolerance; }
};

/// A converged periodic orbit.
template <class T>
struct Orbit {
  Vector<T> x;        ///< unknowns at t = 0, see Shooting::unfold
  Vector<T> x_omega;  ///< their derivative along the branch
  State<T> start;     ///< the chain at t = 0
  T omega{}, energy{}, area{};
  T energy_omega{};  ///< derivative of the energy along the branch
  T amplitude{};     ///< largest modulus of the positions at t = 0
  History history;
  std::size_t switchings = 0;  ///< in the part of a period that was computed
  double residual() const { return history.back().residual; }
  std::size_t iterations() const { return history.size() - 1; }
};

/**
What follows from the last shot. The energy at rest is a sum of potentials, so that the forces
give its derivative; the area of the whole period is that of its part, repeated. */
template <class T, class Onsite, class Contact>
Orbit<T> complete(const Shooting<T, Onsite, Contact>& problem, const Vector<T>& x,
                  const Shot<T>& shot, const Vector<T>& size, History history) {
  Orbit<T> orbit;
  orbit.x = x;
  orbit.x_omega = -solve_graded<T>(shot.jacobian, shot.miss_omega, size);
  orbit.start = problem.unfold(x);
  orbit.omega = problem.omega;
  orbit.energy = energy(problem.chain, orbit.start);
  orbit.area = T(problem.parts()) * shot.flow.area;
  const std::vector<T> force = accelerations(problem.chain, orbit.start.y);
  const State<T> rate = problem.unfold(orbit.x_omega);
  for (std::size_t n = 0; n < force.size(); ++n)
    orbit.energy_omega -= T(problem.chain.mass_of(n)) * force[n] * rate.y[n];
  orbit.amplitude = sup(x);
  orbit.history = std::move(history);
  orbit.switchings = shot.flow.switchings;
  return orbit;
}

/**
We stop where the residual, already small, no longer falls by a factor of four, and keep the
better of the last two. Anything else is a failure. */
template <class T, class Onsite, class Contact>
Orbit<T> newton(const Shooting<T, Onsite, Contact>& problem, Vector<T> x,
                const NewtonRule<T>& rule = {}) {
  History history;
  Vector<T> best_x = x;
  Shot<T> best;
  T last = std::numeric_limits<T>::infinity();
  const auto fail = [&](const std::string& why) -> NoConvergence {
    char text[96];
    std::snprintf(text, sizeof text, "%s-centred breather at omega_b = %.6g: ",
                  problem.centre == Centre::bond ? "bond" : "site", double(problem.omega));
    return NoConvergence(text + why, history);
  };
  for (int i = 0; i <= rule.most; ++i) {
    Shot<T> shot = shoot(problem, x, rule.landing);
    const Vector<T> size = local_sizes(problem, x);
    const Vector<T> unit = rule.graded ? size : Vector<T>::Constant(x.size(), sup(x));
    const T residual = sup<T>(shot.miss.cwiseQuotient(unit));
    history.push_back({double(residual), 0});
    if (!(residual < T(rule.graded ? 1e300 : 1e3))) throw fail("Newton runs away");
    const bool small = last <= rule.enough(), better = residual < last;
    if (better) {
      best = std::move(shot);
      best_x = x;
    }
    if (small && !(residual < last / T(4))) {
      if (!better) history.pop_back();
      return complete(problem, best_x, best, local_sizes(problem, best_x), std::move(history));
    }
    last = residual;
    if (!better) best = std::move(shot);
    const Vector<T> step = solve_graded<T>(best.jacobian, best.miss, size);
    history.back().step = double(sup<T>(step.cwiseQuotient(unit)));
    x -= step;
  }
  throw fail("Newton does not converge");
}

}  // namespace lattice
