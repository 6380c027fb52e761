#pragma once
/**
# Travelling breathers

An exact travelling breather repeats itself one site further on after the *shift time* $T$, $y_n(t+T) = y_{n-1}(t)$. In
linear wells $(e^{-iT}-1)Z = 0$ for $Z = \sum_n(y_n+i\dot y_n)$ (sec5_travelling_breathers.cpp), so that it has
$T = 2\pi k$ (type I) or $Z = 0$ (type II). The equations of `travelling_reversible` without the first one
had a solution for every $T$ that we tried; these solutions form a *family*. With $Z(0) = iV$, $V = \sum\dot y_n$, the
equation that was left out reads $V\sin(T/2) = 0$ (sec5_travelling_families.cpp): along a family a single number, $V$,
shows where it passes through an exact orbit. */

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

#include "lattice/algebra/eigenvalues.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/numerics/estimate.hpp"
#include "lattice/numerics/progress.hpp"
#include "lattice/orbits/breather.hpp"
#include "lattice/orbits/floquet.hpp"

namespace lattice {

/**
An orbit that is also invariant under $y_n(t) \to -y_{-n}(-t)$ has odd positions and even velocities in $n$ at $t = 0$.
Together with $y_n(t+T) = y_{n-1}(t)$ this relates the times $T/2 \pm t$ and the sites $n$ and $1-n$:
$$y_n + y_{1-n} = 0,\qquad \dot y_n - \dot y_{1-n} = 0 \qquad\text{at } t = T/2,\ n = 1,\dots,L+1.$$
With the unknowns $y_1,\dots,y_L$, $\dot y_0,\dots,\dot y_L$ and $T$ there are as many equations as unknowns. If $T$ is
given there is one too many, and the first, that of the positions of 0 and 1, is left out. At $T = 2\pi k$ nothing is
lost by this: $Z$ is imaginary at the start, only turns, and is imaginary again at $T/2$, so that the equations for
positions add up to zero whatever the unknowns are. */
/// That symmetry, with $L$ = `half_length`; the site $L+1$ begins at rest.
Symmetry travelling_reversible(std::size_t half_length, bool free_period);

/**
The chain has the sites $-L \le n \le L+1$, with $L$ = `half_length`. Both tails of a breather fall
double-exponentially, and eight sites on either side are enough for double precision and the next wider
type. */
inline constexpr std::size_t usual_half_length = 8;

/// The problem of the member of a family with the given shift time: all equations but the first.
template <class T>
Shooting<T> travelling_problem(const T& shift_time, double s = 0,
                               std::size_t half_length = usual_half_length) {
  Shooting<T> problem;
  problem.chain.sites = 2 * half_length + 2;
  problem.chain.well = Quartic{s};
  problem.chain.contact = Hertz{.floor = 0};
  problem.symmetry = travelling_reversible(half_length, false);
  problem.omega = T(2) * pi<T>() / shift_time;
  return problem;
}

/// The problem of type I: a bead oscillates k times while the breather moves on by a site.
template <class T>
Shooting<T> type_one(std::size_t k, std::size_t half_length = usual_half_length) {
  return travelling_problem<T>(T(2) * pi<T>() * T(double(k)), 0, half_length);
}

/**
If all equations are imposed the shift time becomes an unknown, and what is found is exact. */
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

/**
Three numbers identify an orbit: its shift time, its central velocity $\dot y_0$, whose sign tells two
orbits of the same $T$ apart, and $V$. */
/// T.
template <class T>
T shift_time(const Orbit<T>& orbit) {
  return T(2) * pi<T>() / orbit.omega;
}
/// The velocity of site 0 at t = 0.
template <class T>
T central_velocity(const Orbit<T>& orbit) {
  return orbit.start.v[orbit.start.v.size() / 2 - 1];
}
/// V, relative to the amplitude.
template <class T>
T velocity_sum(const Orbit<T>& orbit) {
  T sum(0);
  for (const T& v : orbit.start.v) sum += v;
  return sum / orbit.amplitude;
}

/**
## The first orbit

Where does the first guess come from? If the end of a chain is struck, a packet leaves it (section 3.4)
that is almost what we look for. We cut it out at an instant when its largest site passes through zero
and the beads next to it are as nearly odd in position and even in velocity as they ever are. Ahead of
the packet nothing has moved before, so we keep its front half and mirror it; this leaves out the waves
behind it. */

/// By how much the neighbours of site `c` violate the symmetry, relative to their size.
double asymmetry(const State<double>& z, std::size_t c, std::size_t width = 3);

/// The unknowns of the front half of the packet around site `c`.
Vector<double> front_half(const State<double>& z, std::size_t c, std::size_t half_length);

/**
The zero of the largest site lies between two samples of the run; linear interpolation between them is good
enough for a guess. */
/// The state at the part `w` of the way from one state to another.
State<double> between(const State<double>& a, const State<double>& b, double w);

/**
Of all such instants while the packet moves from one given site to another, the most symmetrical is
taken. */
/// Unknowns cut from the packet of an impact at `velocity` while its centre lies between the sites `from`
/// and `to`; `sign` is that of the central velocity. Throws std::runtime_error if no packet passes.
Vector<double> cut_packet(double velocity, double from, double to, int sign,
                          std::size_t half_length = usual_half_length);

/**
## From one orbit to the next

From one orbit of type I we reach others. Small orbits are those of the DpS equation (dps_travelling.hpp),
$y \propto 1/T^2$. In units of $1/k^2$ the members of type I change little with $1/k$, and a straight line
through the last two predicts the next one. The tail is only scaled: it falls by many orders of magnitude
and does not follow a straight line. */
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

  /// The orbit that was reached last.
  const Orbit<double>& orbit() const { return orbit_; }
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

  /**
  At large k the derivative at the last orbit also serves the next one, which saves most of the time. If
  two k differ by an odd number, the phase at $T/2$ differs by half a turn, and the derivative changes
  its sign. */
 private:
  void remember(std::size_t k) {
    before_ = last_, last_ = orbit_.x * double(k * k);
    h_before_ = h_, h_ = 1 / double(k), k_ = k;
  }
  /**
  So a step predicts, scales and corrects. */
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

/**
An orbit that has been found only once has no error bar. So it is found again, from another guess and with
other steps. */
/// The energy of an orbit of type I, with the difference from that of the same orbit found from a guess
/// that is slightly off, at eight times the tolerance.
Estimate energy_of_type_one(std::size_t k, const Orbit<double>& orbit);

/**
## Along a family

Now the shift time is changed in small steps. If $V$ changes its sign between two members, the family has
passed through an orbit of type II, which the secant method finds and the full equations confirm. */

/// The member with shift time `to`, extrapolated from two neighbours `a` and `b`, which may be the same.
/// Throws NewtonFailed.
Orbit<double> next_member(const Orbit<double>& a, const Orbit<double>& b, double to,
                          std::size_t half_length, const NewtonRule<double>& rule);

/// The members from `start` to the shift time `to`, at most `step` apart. Throws NewtonFailed.
std::vector<Orbit<double>> follow_family(const Orbit<double>& start, double to, double step,
                                         const NewtonRule<double>& rule = {});

/**
The secant method looks for the zero of $V$ along the family; the last solution takes all equations and the
shift time as an unknown. */
/// The orbit of type II between two members with V of opposite signs.
/// Throws NewtonFailed.
Orbit<double> type_two(Orbit<double> a, Orbit<double> b, const NewtonRule<double>& rule = {});

/**
## In a resting chain

To see an orbit travel we put it into a longer chain at rest, from site `place` on; beyond its own sites
all is zero. */
/// The state of `sites` beads that holds the orbit.
template <class T>
State<T> embed(const State<T>& orbit, std::size_t sites, std::size_t place) {
  State<T> state(sites);
  std::copy(orbit.y.begin(), orbit.y.end(), state.y.begin() + std::ptrdiff_t(place));
  std::copy(orbit.v.begin(), orbit.v.end(), state.v.begin() + std::ptrdiff_t(place));
  return state;
}

/**
Following it over many sites takes no chain that holds them all: a frame goes along, beads that have been
passed are dropped, and beads at rest come in ahead. */
/// Moves the frame that a state holds on by `sites`.
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

/**
The eigenvalues of this map are the multipliers. Stability depends on the largest, the phase on those
next to $+1$. */
/// All multipliers, the largest first.
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
