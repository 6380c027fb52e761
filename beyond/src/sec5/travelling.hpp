#pragma once
/**
# Travelling breathers

Orbits with $y_n(t+T) = y_{n-1}(t)$, their families, and the packet from which the first of them is found. The equations
and the sum $V = \sum\dot y_n$, whose zeros along a family mark exact orbits, are explained in
sec5_travelling_breathers.cpp. */

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

#include "lattice/algebra/dense.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/numerics/estimate.hpp"
#include "lattice/numerics/progress.hpp"
#include "lattice/orbits/breather.hpp"
#include "lattice/orbits/continuation.hpp"
#include "lattice/orbits/floquet.hpp"

namespace lattice {

/// Odd positions and even velocities about the site 0 at t = 0 and about the next contact at T/2, with $L$ =
/// `half_length`; the site $L+1$ begins at rest. If T is given, the first equation, of $y_0+y_1$, is left out.
Symmetry travelling_reversible(std::size_t half_length, bool free_period);

/// The chain has the sites -L to L+1. Both tails fall double-exponentially, and eight sites on either side are enough for
/// double and extended precision.
inline constexpr std::size_t usual_half_length = 8;

/// The problem of the member of a family with the given shift time: all equations but the first.
template <class T>
Shooting<T> travelling_problem(const T& shift_time, double s = 0,
                               std::size_t half_length = usual_half_length) {
  Shooting<T> problem;
  problem.chain.sites = 2 * half_length + 2;
  problem.chain.well = Quartic{s};
  problem.chain.contact = Hertz{.negligible = 0};
  problem.symmetry = travelling_reversible(half_length, false);
  problem.omega = T(2) * pi<T>() / shift_time;
  return problem;
}

/// The problem of type I: a bead oscillates k times while the breather moves on by a site.
template <class T>
Shooting<T> type_one(std::size_t k, std::size_t half_length = usual_half_length) {
  return travelling_problem<T>(T(2) * pi<T>() * T(double(k)), 0, half_length);
}

/// The same with all equations and the shift time as an unknown: what is found is exact.
template <class T>
Shooting<T> with_free_time(Shooting<T> problem) {
  problem.symmetry = travelling_reversible(problem.chain.sites / 2 - 1, true);
  return problem;
}

/// The unknowns of the problem with a free time, from those of a family's member.
template <class T>
Vector<T> with_time(const Vector<T>& x, const T& shift_time) {
  Vector<T> all(x.size() + 1);
  all << x, shift_time;
  return all;
}

/// T.
template <class T>
T shift_time(const Orbit<T>& orbit) {
  return T(2) * pi<T>() / orbit.omega;
}
/// V, relative to the amplitude.
template <class T>
T velocity_sum(const Orbit<T>& orbit) {
  T sum(0);
  for (const T& v : orbit.start.v) sum += v;
  return sum / orbit.amplitude;
}

/// The state at the part `w` of the way from one state to another.
State<double> between(const State<double>& a, const State<double>& b, double w);

/// Unknowns cut from the packet of an impact at `velocity` while its centre lies between the sites `from` and `to`, at the
/// instant when its largest site passes through zero and the beads next to it are most nearly odd in position and even in
/// velocity. The front half is mirrored, which leaves out the waves behind. `sign` is that of the central velocity. Throws
/// std::runtime_error if no packet passes.
Vector<double> cut_packet(double velocity, double from, double to, int sign,
                          std::size_t half_length = usual_half_length);

/**
From one orbit of type I we reach others. In units of $1/k^2$, which is how small orbits scale, they change little with
$1/k$, and a straight line through the last two predicts the next one. The far tail is only scaled. */
class TypeOneOrbits {
 public:
  /// The orbits with this sign of the central velocity.
  explicit TypeOneOrbits(int sign, std::size_t half_length = usual_half_length,
                         NewtonRule<double> rule = {})
      : half_length_(half_length), rule_(rule) {
    const Shooting<double> problem = type_one<double>(first, half_length);
    orbit_ = newton(problem, cut_packet(first_velocity, 15, 30, sign, half_length), rule);
    remember(first);
  }

  static constexpr std::size_t first = 5;  ///< k of the first orbit
  /// The impact after which the packet moves by one site in about `first` oscillations.
  static constexpr double first_velocity = 0.0174;

  /// Goes up or down to k, in steps short enough for Newton's method. Throws NewtonFailed.
  const Orbit<double>& orbit_at(std::size_t k) {
    Progress progress("orbits up to k = " + std::to_string(k), 1);
    for (const double from = double(k_); k_ != k;) {
      const std::size_t up = std::min(k, k_ + 1 + k_ / 4);
      step(k > k_ ? up : k_ - 1);
      progress.reach((double(k_) - from) / (double(k) - from));
    }
    return orbit_;
  }

 private:
  void remember(std::size_t k) {
    before_ = last_, last_ = orbit_.x * double(k * k);
    h_before_ = h_, h_ = 1 / double(k), k_ = k;
  }
  /// Predicts, scales and corrects. At large k the derivative at the last orbit serves, too; if two k differ by an odd
  /// number, the phase at T/2 differs by half a turn, and the derivative changes its sign.
  void step(std::size_t k) {
    const double h = 1 / double(k);
    Vector<double> x = last_;
    if (before_.size() > 0) {
      const double top = sup(last_), w = (h - h_) / (h_ - h_before_);
      for (Eigen::Index i = 0; i < x.size(); ++i)
        if (std::abs(x[i]) > 1e-4 * top) x[i] += w * (x[i] - before_[i]);
    }
    Orbit<double> guess = orbit_;
    guess.x = x / double(k * k);
    if ((k + k_) % 2) guess.jacobian = -guess.jacobian;
    const Shooting<double> problem = type_one<double>(k, half_length_);
    orbit_ = k > 2 * first ? newton(problem, guess, rule_) : newton(problem, guess.x, rule_);
    remember(k);
  }

  std::size_t half_length_, k_ = 0;
  NewtonRule<double> rule_;
  Orbit<double> orbit_;
  Vector<double> last_{}, before_{};
  double h_ = 0, h_before_ = 0;
};

/// The energy of an orbit of type I, with the difference from that of the same orbit found from a guess
/// that is slightly off, at eight times the tolerance.
Estimate energy_of_type_one(std::size_t k, const Orbit<double>& orbit);

/// The member with shift time `to`, extrapolated from two neighbours `a` and `b`, which may be the same.
/// Throws NewtonFailed.
Orbit<double> next_member(const Orbit<double>& a, const Orbit<double>& b, double to,
                          std::size_t half_length, const NewtonRule<double>& rule);

/// The members from `start` to the shift time `to`, at most `step` apart. Throws NewtonFailed.
std::vector<Orbit<double>> follow_family(const Orbit<double>& start, double to, double step,
                                         const NewtonRule<double>& rule = {});

/// The orbit of type II between two members with V of opposite signs, by the secant method and then with T as an unknown.
/// Throws NewtonFailed.
Orbit<double> type_two(Orbit<double> a, Orbit<double> b, const NewtonRule<double>& rule = {});

/// The branch of an orbit of type I at s = 0 into hard (direction 1) or soft (-1) wells, with T as an unknown, by arclength
/// in steps up to `longest`. Newton's method fails where beads of the tail only just touch. Throws NewtonFailed.
Branch branch_in_s(const Orbit<double>& start, int direction, double longest = 0.25);

/// The state of `sites` beads at rest that holds the orbit from site `place` on.
template <class T>
State<T> embed(const State<T>& orbit, std::size_t sites, std::size_t place) {
  State<T> state(sites);
  std::copy(orbit.y.begin(), orbit.y.end(), state.y.begin() + std::ptrdiff_t(place));
  std::copy(orbit.v.begin(), orbit.v.end(), state.v.begin() + std::ptrdiff_t(place));
  return state;
}

/// Moves the frame that a state holds on by `sites`: beads that have been passed are dropped, beads at rest come in ahead.
inline void move_on(State<double>& state, std::size_t sites) {
  for (auto* q : {&state.y, &state.v}) {
    std::rotate(q->begin(), q->begin() + std::ptrdiff_t(sites), q->end());
    std::fill(q->end() - std::ptrdiff_t(sites), q->end(), 0.0);
  }
}

/**
## Stability

The stability of a travelling orbit is that of the flow over $T$, read one site further on: it maps a small
change of the orbit to another one. Changes that the breather leaves behind are gone for good, so most
multipliers lie inside the unit circle. Near $+1$ there remain two pairs: that of the shift in time with
the change of the speed, which is defective (floquet.hpp), and that of the internal phase. The sum of
$(\lambda-1)^2/\lambda$ over the four is $8\kappa$, to which the first pair contributes nothing: with
$\kappa > 0$ a change of the phase grows, with $\kappa < 0$ it is pinned. */

/// The derivative of the flow over one shift, read one site further; nothing enters from ahead.
template <class T>
Matrix<T> shifted_map(const Chain& chain, const State<T>& start,
                      const std::type_identity_t<T>& time, const EventTolerance<T>& rule = {}) {
  const Matrix<T> map = monodromy(chain, start, time, rule);
  const Eigen::Index n = Eigen::Index(chain.sites);
  Matrix<T> shifted = Matrix<T>::Zero(2 * n, 2 * n);
  shifted.topRows(n - 1) = map.middleRows(1, n - 1);
  shifted.middleRows(n, n - 1) = map.bottomRows(n - 1);
  return shifted;
}

/// All multipliers, its eigenvalues, the largest first.
template <class T>
std::vector<std::complex<T>> multipliers_of(const Matrix<T>& map) {
  std::vector<std::complex<T>> all = eigenvalues_of(map);
  std::stable_sort(all.begin(), all.end(),
                   [](auto a, auto b) { return std::norm(a) > std::norm(b); });
  return all;
}

/// kappa of the phase, from the four multipliers next to +1.
template <class T>
T phase_kappa(std::vector<std::complex<T>> all) {
  const T one(1);
  std::stable_sort(all.begin(), all.end(),
                   [&](auto a, auto b) { return std::norm(a - one) < std::norm(b - one); });
  std::complex<T> sum(0);
  for (std::size_t i = 0; i < 4; ++i) sum += (all[i] - one) * (all[i] - one) / all[i];
  return sum.real() / T(8);
}

}  // namespace lattice
