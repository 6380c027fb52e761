#pragma once
/**
# Kicking a breather

Section 3.3 sets a static breather in motion by a kick: at an instant at which all beads are at rest they
are given velocities in the direction of the breather's discrete gradient,
$$\dot y_n(0) = c\,g_n,\qquad g_n = \frac{y_{n+1}(0)-y_{n-1}(0)}{\bigl(\sum_m|y_{m+1}(0)-y_{m-1}(0)|^2\bigr)^{1/2}}.$$
The norm of $g$ is one, so that the kick adds the kinetic energy $c^2/2$. (The article prints the formula
without the square root; with that one neither the energy $c^2/2$ nor the speeds that it quotes come out.)
This file kicks the breather and follows it as it drifts along; depinning.hpp tells whether it gets
free. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "lattice/diagnostics/path.hpp"
#include "lattice/integrators/integrate.hpp"

namespace lattice {

/// The direction of a kick: y_(n+1) - y_(n-1), with beads at rest beyond both ends, over its norm.
/// Throws std::invalid_argument for a profile without a gradient.
std::vector<double> kick_direction(const std::vector<double>& y);

/// The state after a kick of size `c` (a velocity; the kinetic energy grows by c^2/2 if it was zero).
State<double> kicked(State<double> state, double c);

/**
## Following a breather that drifts

The centre $X$ of Eq. (24) swings with every oscillation, because Eq. (23) assigns the energy of a contact
to the bead on its left. What drifts is its mean. We take 89 samples at intervals of $T_b(\sqrt5-1)/10$,
together eleven periods: since this is $T_b/5$ times the golden ratio 0.618, and 89 a Fibonacci number,
they are spread evenly over the phases of the oscillation. It also keeps the steps from falling on the
same phases in every period, where their errors would add up instead of cancelling. */
inline constexpr std::size_t samples_of_a_mean = 89;

/// Time between two samples of a breather with this period.
double sample_of_mean(double period);

/// Sites from the middle of the chain to the energy centre, Eq. (24), about the largest density.
double breather_place(const std::vector<double>& e);

/// The path of a kicked breather: the means of X, in sites from the middle of the chain, at the middles of their
/// intervals, and the report of the run.
struct KickedPath : Path {
  double share = 1;  ///< the least share of the energy near the largest density, of all samples
  State<double> end{};
  Run run{};

  /// Sites moved from the first mean to mean `k`.
  double moved(std::size_t k) const { return centre[k] - centre[0]; }
  /// Sites moved from the first mean to the last; zero without means.
  double travelled() const { return centre.empty() ? 0 : moved(centre.size() - 1); }
  /// The largest distance from the first mean, in either direction.
  double farthest() const;
  /// `distance` over the time that it takes from mean `start` on, interpolated between two means. Throws
  /// std::runtime_error if the path does not lead so far.
  double mean_speed(double distance, std::size_t start = 0) const;
  /// The energy of a kick, c^2/2, over the energy that the integration gained or lost; `energy` is the
  /// breather's. Below a hundred or so the run says nothing about the kick.
  double drift_margin(double c, double energy) const;
};

/// When the breather is `distance` sites from its start, from two schemes or steps. Throws as `mean_speed` does.
Estimate when_at(double distance, const TwoRuns<KickedPath>& paths);

/**
The samples of eleven periods are added up to one mean of $X$. */
struct MeanPlace {
  KickedPath path{};        ///< the means so far
  double sample, sum = 0;   ///< time between two samples; of the places since the last mean
  std::size_t samples = 0;  ///< seen in all

  /// Whether `now` completes a mean.
  bool add(const State<double>& now, const std::vector<double>& e) {
    sum += breather_place(e);
    const std::size_t peak = std::size_t(std::max_element(e.begin(), e.end()) - e.begin());
    path.share = std::min(path.share, window_sum(e, peak) / window_sum(e, 0, e.size()));
    if (++samples % samples_of_a_mean != 0) return false;
    path.add(now.t - sample * 0.5 * double(samples_of_a_mean - 1), sum / double(samples_of_a_mean));
    sum = 0;
    return true;
  }
};

/// Sees every mean: the path so far, the state and its energy density. It may return false to end the run.
using KickLook = Observer<KickedPath, State<double>, std::vector<double>>;

/// Follows a kicked breather for about `duration`, a whole number of means, with samples `sample` apart, usually
/// `sample_of_mean`.
KickedPath follow_kicked(const Method& method, const Chain& chain, const State<double>& start,
                         double sample, double duration, const KickLook& look = {});

}  // namespace lattice
