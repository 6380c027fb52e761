#pragma once
/**
# Kicking a breather

A breather at rest is pushed along the chain by a kick of the velocities in the direction of its
discrete gradient,
$$\dot y_n(0) = c\,g_n,\qquad g_n = \frac{y_{n+1}(0)-y_{n-1}(0)}{\bigl(\sum_m|y_{m+1}(0)-y_{m-1}(0)|^2\bigr)^{1/2}} .$$
The norm of $g$ is one, so that the kick brings the kinetic energy $c^2/2$. (The article prints the
formula without the square root, and with it neither the energy nor the speeds that it quotes.) This
file kicks, follows the breather as it creeps, and says what linear theory expects. */

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

#include "lattice/landing/landing.hpp"
#include "lattice/measure/observe.hpp"
#include "lattice/model/sites.hpp"
#include "lattice/stepping/integrate.hpp"

namespace lattice {

/// The direction of a kick: y_(n+1) - y_(n-1), with beads at rest beyond both ends, over its norm.
/// Throws std::invalid_argument for a profile without a gradient.
inline std::vector<double> kick_direction(const std::vector<double>& y) {
  std::vector<double> g(y.size());
  double squares = 0;
  for (std::size_t n = 0; n < y.size(); ++n) {
    g[n] = (n + 1 < y.size() ? y[n + 1] : 0) - (n > 0 ? y[n - 1] : 0);
    squares += g[n] * g[n];
  }
  if (!(squares > 0)) throw std::invalid_argument("a chain at rest has no direction for a kick");
  for (double& x : g) x /= std::sqrt(squares);
  return g;
}

/// The state after a kick of size `c` (a velocity; the kinetic energy grows by c^2/2 if it was zero).
inline State<double> kicked(State<double> state, double c) {
  const std::vector<double> g = kick_direction(state.y);
  for (std::size_t n = 0; n < g.size(); ++n) state.v[n] += c * g[n];
  return state;
}

/**
## Following a breather that creeps

The centre $X$ of Eq. (24) swings with every oscillation, because Eq. (23) gives the energy of a
contact to the bead on its left. What creeps is its mean. We take 89 samples at intervals of
$T_b(\sqrt5-1)/10$, together eleven periods: the golden ratio spreads them evenly over the phases of
the oscillation. It also keeps the steps from falling on the same phases in every period, where the
errors of a step would add up instead of cancelling. */
inline constexpr std::size_t samples_of_a_mean = 89;

inline double creep_sample(double period) {
  return period * (std::sqrt(5.0) - 1) / 10;
}

/// Sites from the middle of the chain to the energy centre, Eq. (24), about the largest density.
inline double breather_place(const std::vector<double>& e) {
  const std::size_t peak = std::size_t(std::max_element(e.begin(), e.end()) - e.begin());
  return energy_centre(e, peak) - 0.5 * double(e.size() + 1);
}

/// The means of X at the middles of their intervals, and what the run says.
struct Creep {
  std::vector<double> t{}, X{};
  double share = 1;  ///< the least share of the energy near the largest density
  State<double> end{};
  Run run{};

  /// Sites moved from the first mean to mean `k`.
  double moved(std::size_t k) const { return X[k] - X[0]; }
  double travelled() const { return X.empty() ? 0 : moved(X.size() - 1); }
  /// Slope of X between two times, with the error of the fit; throws std::invalid_argument if fewer
  /// than three means lie there.
  Estimate speed(double from, double to) const {
    std::vector<double> ts, xs;
    for (std::size_t k = 0; k < t.size(); ++k)
      if (t[k] >= from && t[k] <= to) ts.push_back(t[k]), xs.push_back(X[k]);
    return fit_line(ts, xs).estimate();
  }
};

/**
`watch(creep, state, density)` sees every mean and may end the run by returning false. Samples are
`sample` apart, in general `creep_sample`. */
template <class Stepper, class Onsite, class Contact, class Watch>
Creep creep(const Stepper& stepper, const Chain<Onsite, Contact>& chain, const State<double>& start,
            double sample, double duration, Watch watch) {
  Creep out;
  out.end = start;
  const std::size_t means = std::size_t(duration / (sample * double(samples_of_a_mean)) + 0.5);
  Pace pace{sample * double(samples_of_a_mean * means), samples_of_a_mean * means};
  pace.steps =
      std::max<std::size_t>(1, std::size_t(std::ceil(sample / stepper.step * (1 - 1e-12))));
  double sum = 0;
  std::size_t k = 0;
  out.run = evolve(stepper, chain, out.end, pace, [&](const State<double>& now) {
    if (now.t == start.t) return true;
    const std::vector<double> e = energy_density(chain, now);
    sum += breather_place(e);
    if (++k % samples_of_a_mean != 0) return true;
    const std::size_t peak = std::size_t(std::max_element(e.begin(), e.end()) - e.begin());
    out.share = std::min(out.share, window_sum(e, peak) / window_sum(e, 0, e.size()));
    out.t.push_back(now.t - sample * 0.5 * double(samples_of_a_mean - 1));
    out.X.push_back(sum / double(samples_of_a_mean));
    sum = 0;
    return watch(std::as_const(out), now, e);
  });
  return out;
}

/**
## Free or pinned

A breather that starts in a trough of its landscape has a hill on either side, half a site away. It is
free as soon as it stands well beyond the hill, and pinned once it has turned round before. */
enum class Course { undecided, free, pinned };

inline Course fate_of(const Creep& path) {
  double far = 0;
  for (std::size_t k = 0; k < path.X.size(); ++k) far = std::max(far, std::abs(path.moved(k)));
  if (far > 0.6) return Course::free;
  return std::abs(path.travelled()) < far - 0.02 ? Course::pinned : Course::undecided;
}

/**
## What linear theory expects

Close to a breather that starts at rest the map of one period has a slow plane: a shift $x$ of the
positions and a push $z$ of the velocities with
$$A x = \cos\theta\,x,\quad
 A^Tz = \cos\theta\,z,\quad z^TBz = b\,z^Tx,$$
where $A$ and $B$ are the changes of the final positions with the initial positions and velocities. Over
many periods this is an oscillator (or its unstable twin) of squared frequency
$\Omega^2 = 2(1-\cos\theta)/T^2$. Its *kinetic* energy after a kick $c\,g$ is
$$K = \varphi\,\frac{c^2}2,\qquad \varphi = \frac{b\,(x\cdot g)^2}{T\,(x\cdot z)} .$$
All but the small share $\varphi$ of the kick goes into the oscillation, that is, into the action. */
struct Pinning {
  double frequency2 = 0;  ///< Omega^2; negative for an unstable breather
  double share = 0;       ///< phi
};

/// An eigenvector with an eigenvalue near `value`, by inverse iteration from `guess`.
inline Eigen::VectorXd eigenvector_near(const Eigen::MatrixXd& m, double value,
                                        Eigen::VectorXd guess) {
  const Eigen::PartialPivLU<Eigen::MatrixXd> shifted(
      m - (value + 1e-5) * Eigen::MatrixXd::Identity(m.rows(), m.cols()));
  for (int k = 0; k < 20; ++k) guess = shifted.solve(guess).normalized();
  return guess;
}

/**
The plane shares its multiplier, nearly one, with the phase of the oscillation, and symmetry separates
the two: around a bond shifts are even under $n \to 1-n$ and the phase is odd; around a site half a
period followed by $y_n \to -y_{-n}$ maps the phase to itself and reverses a shift. `basis` holds the
directions that are left. */
struct PeriodMap {
  Eigen::MatrixXd A, B, basis;
};

template <class Onsite, class Contact>
PeriodMap period_map(const Chain<Onsite, Contact>& chain, Centre centre, State<double> state,
                     double period, const Landing<double>& rule) {
  const auto n = Eigen::Index(chain.sites);
  const bool site = centre == Centre::site;
  Tangent<double> tangent(chain.sites, 2 * chain.sites);
  flow(chain, state, site ? period / 2 : period, rule, &tangent);
  PeriodMap map{Eigen::MatrixXd(n, n), Eigen::MatrixXd(n, n), Eigen::MatrixXd::Identity(n, n)};
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index k = 0; k < n; ++k) {
      const auto row = std::size_t(site ? n - 1 - i : i);
      map.A(i, k) = (site ? -1 : 1) * tangent(row, std::size_t(k));
      map.B(i, k) = (site ? -1 : 1) * tangent(row, std::size_t(k + n));
    }
  if (site) return map;
  map.basis = Eigen::MatrixXd::Zero(n, n / 2);
  for (Eigen::Index i = 0; i < n / 2; ++i)
    map.basis(i, i) = map.basis(n - 1 - i, i) = std::sqrt(0.5);
  return map;
}

/**
Of the half map we take the square, which doubles its angle. */
template <class Onsite, class Contact>
Pinning pinning_of(const Chain<Onsite, Contact>& chain, Centre centre, const State<double>& start,
                   double period, const Landing<double>& rule = {}) {
  const PeriodMap map = period_map(chain, centre, start, period, rule);
  const Eigen::MatrixXd A = map.basis.transpose() * map.A * map.basis;
  const Eigen::MatrixXd B = map.basis.transpose() * map.B * map.basis;
  const std::vector<double> direction = kick_direction(start.y);
  const Eigen::VectorXd g =
      map.basis.transpose() *
      Eigen::Map<const Eigen::VectorXd>(direction.data(), Eigen::Index(direction.size()));
  const double near = centre == Centre::site ? -1 : 1;
  const Eigen::VectorXd x = eigenvector_near(A, near, g);
  const Eigen::VectorXd z = eigenvector_near(A.transpose(), near, g);
  const double cosine = z.dot(A * x) / z.dot(x), b = z.dot(B * z) / z.dot(x), part = x.dot(g);
  const double share = b * part * part / (period * x.dot(z));
  const double miss = 2 * (1 - std::abs(cosine)) / (period * period);
  if (centre == Centre::bond) return {miss, share};
  return {2 * (1 + std::abs(cosine)) * miss, 2 * cosine * share};
}

/**
The landscape is compared at equal action. With a hill of height `barrier` between trough and trough the
breather is freed by a kick whose share is that hill. Masses may be negative, as they are here: then the
trough is the *higher* of the two energies, and both signs turn round together. */
inline double freeing_kick(double barrier, const Pinning& pinning) {
  return std::sqrt(2 * std::abs(barrier / pinning.share));
}

}  // namespace lattice
