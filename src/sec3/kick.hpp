#pragma once
/**
# Kicking a breather

When all beads of a breather are at rest they are given the velocities $c\,g_n$, with $g_n$ the discrete gradient
$y_{n+1}-y_{n-1}$ divided by its norm, so that the kick adds the energy $c^2/2$. Chapter (`sec33_mobility`), commands,
live page and tests all kick and follow breathers by the functions of this file. */

#include <algorithm>
#include <cstddef>
#include <vector>

#include "lattice/diagnostics/path.hpp"
#include "lattice/integrators/integrate.hpp"

namespace lattice {

/// The direction g of a kick; beads beyond both ends are at rest. Throws std::invalid_argument for a chain at rest.
std::vector<double> kick_direction(const std::vector<double>& y);

/// The state after a kick of size `c` (a velocity) along `g`, by default the discrete gradient.
State<double> kicked(State<double> state, double c, const std::vector<double>& g);
State<double> kicked(const State<double>& state, double c);

/**
The centre $X$ of Eq. (24) swings with every oscillation, so it is averaged over 89 samples at intervals of
$T_b(\sqrt5-1)/10$, together eleven periods. This is $T_b/5$ times the golden ratio 0.618, and 89 a Fibonacci number:
the samples are spread evenly over the phases, and the errors of steps do not add up. */
inline constexpr std::size_t samples_of_a_mean = 89;

/// Time between two samples of a breather with this period.
double sample_of_mean(double period);

/// Sites from the middle of the chain to the energy centre, Eq. (24), about the largest density.
double breather_place(const std::vector<double>& e);

/// The means of X, in sites from the middle of the chain, at the middles of their intervals.
struct KickedPath : Path {
  double share = 1;   ///< the least fraction of the energy within five sites of the largest density
  double energy = 0;  ///< of the chain at the end of the run
  Run run{};

  /// Sites moved from the first mean to mean `k`, and to the last; zero without means.
  double moved(std::size_t k) const { return samples[k].centre - samples[0].centre; }
  double travelled() const { return empty() ? 0 : moved(size() - 1); }
  /// The largest distance from the first mean, in either direction.
  double farthest() const;
  /// `distance` over the time that it takes from mean `start` on, interpolated between two means. Throws
  /// std::runtime_error if the path does not lead so far.
  double mean_speed(double distance, std::size_t start = 0) const;
  /// When the distance from the first mean is this, and the speed there, over a fifth of a site.
  double time_at(double distance) const { return samples[0].t + distance / mean_speed(distance); }
  double speed_at(double distance) const;
  /// The energy of a kick, c^2/2, over the energy that the integration gained or lost; `energy` is the breather's.
  double drift_margin(double c, double energy) const;
};

/// Free: this far from the start, well beyond the next maximum of the potential at 0.5. Pinned: turned back by this
/// much before. Both in sites; the means of X are known to 1e-6.
inline constexpr double free_beyond = 0.6, turned_back = 0.02;
enum class Mobility { undecided, free, pinned };
Mobility mobility_of(const KickedPath& path);

/// Sees every mean: the path so far, the state and its energy density. It may return false to end the run.
using KickLook = Observer<KickedPath, State<double>, std::vector<double>>;

/// Follows a kicked breather for about `duration`, a whole number of means.
KickedPath follow_kicked(const Method& method, const Chain& chain, const State<double>& start,
                         double sample, double duration, const KickLook& look = {});

}  // namespace lattice
