#pragma once
/**
# When a kick frees a breather

A breather that creeps along the chain feels an energy landscape with the period of the chain: if it is
stable around a bond, there are troughs at the bonds and hills at the sites, otherwise the reverse. A kick
(kick.hpp) frees it from a trough if it carries it over the hill. This file tells a free breather from a
pinned one, says what linear theory expects, and finds the least kick that frees. */

#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "lattice/landing/landing.hpp"
#include "lattice/measure/kick.hpp"
#include "lattice/model/sites.hpp"
#include "lattice/numbers/dense.hpp"

namespace lattice {

/**
## Free or pinned

A breather that starts in a trough has a hill on either side, half a site away. It is free as soon as it is
well beyond the hill, at 0.6 sites, and pinned if it has turned round before that, by 0.02 sites. */
enum class Mobility { undecided, free, pinned };

/// What a path, as far as it is known, says about its breather.
inline Mobility mobility_of(const Creep& path) {
  const double far = path.farthest();
  if (far > 0.6) return Mobility::free;
  return std::abs(path.travelled()) < far - 0.02 ? Mobility::pinned : Mobility::undecided;
}

/**
## What linear theory expects

Close to a breather that starts at rest, the map of one period has a slow plane, spanned by a shift $x$ of
the positions and a push $z$ of the velocities with
$$A x = \cos\theta\,x,\quad
 A^Tz = \cos\theta\,z,\quad z^TBz = b\,z^Tx,$$
where $A$ and $B$ are the derivatives of the final positions with respect to the initial positions and
velocities. Over many periods this is an oscillator (or, if $\cos\theta > 1$, its unstable twin) of squared
frequency $\Omega^2 = 2(1-\cos\theta)/T^2$. Its *kinetic* energy after a kick $c\,g$ is
$$K = \varphi\,\frac{c^2}2,\qquad \varphi = \frac{b\,(x\cdot g)^2}{T\,(x\cdot z)}.$$
Only the small share $\varphi$ of the kick moves the breather along; the rest goes into its internal
oscillation and changes the action. */
struct Pinning {
  double frequency2 = 0;  ///< Omega^2; negative for an unstable breather
  double share = 0;       ///< phi
};

/// The eigenvector whose eigenvalue is nearest to `value`, by inverse iteration from `guess`. The shift
/// of 1e-5 keeps the matrix from being singular.
inline Vector<double> eigenvector_near(const Matrix<double>& m, double value,
                                       Vector<double> guess) {
  const Matrix<double> shifted = m - (value + 1e-5) * Matrix<double>::Identity(m.rows(), m.cols());
  for (int k = 0; k < 20; ++k) guess = solve_square(shifted, guess).normalized();
  return guess;
}

/**
The multipliers of this plane, nearly one, cannot be told from that of a shift in time, which is exactly
one (floquet.hpp), but symmetry separates the two. Around a bond a shift along the chain is even under
$n \to 1-n$ and a shift in time is odd. Around a site half a period followed by $y_n \to -y_{-n}$ leaves
a shift in time alone and reverses one along the chain. `basis` holds the directions that are left. */
struct PeriodMap {
  Matrix<double> A, B, basis;
};

/// A, B and the basis: of one period around a bond, of half a period and the reflection around a site.
template <class Onsite, class Contact>
PeriodMap period_map(const Chain<Onsite, Contact>& chain, Centre centre, State<double> state,
                     double period, const Landing<double>& rule) {
  const auto n = Eigen::Index(chain.sites);
  const bool site = centre == Centre::site;
  Tangent<double> tangent(chain.sites, 2 * chain.sites);
  flow(chain, state, site ? period / 2 : period, rule, &tangent);
  PeriodMap map{Matrix<double>(n, n), Matrix<double>(n, n), Matrix<double>::Identity(n, n)};
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index k = 0; k < n; ++k) {
      const auto row = std::size_t(site ? n - 1 - i : i);
      map.A(i, k) = (site ? -1 : 1) * tangent(row, std::size_t(k));
      map.B(i, k) = (site ? -1 : 1) * tangent(row, std::size_t(k + n));
    }
  if (site) return map;
  map.basis = Matrix<double>::Zero(n, n / 2);
  for (Eigen::Index i = 0; i < n / 2; ++i)
    map.basis(i, i) = map.basis(n - 1 - i, i) = std::sqrt(0.5);
  return map;
}

/**
`pinning_of` returns frequency and share for the breather at rest in `start`. Around a site the map of
half a period is squared, which doubles its angle. */
template <class Onsite, class Contact>
Pinning pinning_of(const Chain<Onsite, Contact>& chain, Centre centre, const State<double>& start,
                   double period, const Landing<double>& rule = {}) {
  const PeriodMap map = period_map(chain, centre, start, period, rule);
  const Matrix<double> A = map.basis.transpose() * map.A * map.basis;
  const Matrix<double> B = map.basis.transpose() * map.B * map.basis;
  const std::vector<double> direction = kick_direction(start.y);
  const Vector<double> g =
      map.basis.transpose() *
      Eigen::Map<const Vector<double>>(direction.data(), Eigen::Index(direction.size()));
  const double near = centre == Centre::site ? -1 : 1;
  const Vector<double> x = eigenvector_near(A, near, g);
  const Vector<double> z = eigenvector_near(A.transpose(), near, g);
  const double cosine = z.dot(A * x) / z.dot(x), b = z.dot(B * z) / z.dot(x), part = x.dot(g);
  const double share = b * part * part / (period * x.dot(z));
  const double miss = 2 * (1 - std::abs(cosine)) / (period * period);
  if (centre == Centre::bond) return {miss, share};
  return {2 * (1 + std::abs(cosine)) * miss, 2 * cosine * share};
}

/**
Now the threshold. In the slow motion the action is constant, so the height of the hill is the barrier at
equal area (breather.hpp), and the breather is freed by a kick whose share equals it. The effective mass
may be negative, as it is here: then the trough is the *higher* of the two energies, and the barrier and
the share change sign together. */
inline double freeing_kick(double barrier, const Pinning& pinning) {
  return std::sqrt(2 * std::abs(barrier / pinning.share));
}

/**
## From speeds to the threshold

Close to the threshold a breather stays near the top of the hill for long, and to bisect between free and
pinned would cost a long run for every digit. What changes smoothly is the speed $V$ with which a free
breather passes the top. Its kinetic energy there is the share of the kick less the barrier, so that
$V^2 \propto c^2 - c_c^2$, and two free breathers give $c_c$.

Near the top the path is $X \simeq (V/\Omega)\sinh\Omega t$ with $\Omega$ the rate of the hill. There it is
nearly a cubic whose least slope is $V$, and we fit one to all means within `reach` of the top. */
/// The speed on the hill at `hill` sites from the start. Throws std::invalid_argument if fewer than
/// eight means lie within `reach` of it.
inline double hill_speed(const Creep& path, double hill = 0.5, double reach = 0.05) {
  std::vector<std::size_t> near;
  for (std::size_t k = 0; k < path.X.size(); ++k)
    if (std::abs(std::abs(path.moved(k)) - hill) <= reach) near.push_back(k);
  if (near.size() < 8) throw std::invalid_argument("too few means of the path lie on the hill");
  const double first = path.t[near.front()], last = path.t[near.back()], half = (last - first) / 2;
  Matrix<double> power(Eigen::Index(near.size()), 4);
  Vector<double> place(power.rows());
  for (Eigen::Index i = 0; i < power.rows(); ++i) {
    const std::size_t k = near[std::size_t(i)];
    const double u = (path.t[k] - first) / half - 1;
    power.row(i) << 1, u, u * u, u * u * u;
    place[i] = std::abs(path.moved(k)) - hill;
  }
  const Vector<double> a = least_squares(power, place);
  return (a[3] > 0 ? a[1] - a[2] * a[2] / (3 * a[3]) : a[1]) / half;
}

/**
The straight line through the two values of $V^2$ against $c^2$ is followed to zero. */
/// The kick at which $V^2$ vanishes, from two kicks that free and their speeds on the hill. Throws
/// std::invalid_argument if the line has no zero at positive c.
inline double threshold_from(double c1, double v1, double c2, double v2) {
  const double square = (c1 * c1 * v2 * v2 - c2 * c2 * v1 * v1) / (v2 * v2 - v1 * v1);
  if (!(square > 0)) throw std::invalid_argument("these two speeds show no threshold");
  return std::sqrt(square);
}

/**
## A pendulum

How does the speed of a freed breather depend on its kick? If the landscape is a sine, the centre moves
like a pendulum, and its mean speed over a whole site is the arithmetic-geometric mean of the speeds on
the hill and in the trough: $V$ and $(V^2+\Omega^2/\pi^2)^{1/2}$ for a start on a hill, $V$ and
$(V^2-\Omega^2/\pi^2)^{1/2}$ from a trough. */
inline double arithmetic_geometric(double a, double b) {
  while (std::abs(a - b) > 1e-14 * a) {
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  return a;
}

/// Mean speed over a site of a pendulum that swings with `omega` in its trough and starts with speed
/// `start` there or, with `on_hill`, at the top; zero if it does not get over.
inline double pendulum_speed(double start, double omega, bool on_hill) {
  const double well = omega / std::numbers::pi, square = start * start - well * well;
  if (on_hill) return arithmetic_geometric(std::hypot(start, well), start);
  return square > 0 ? arithmetic_geometric(start, std::sqrt(square)) : 0;
}

}  // namespace lattice
