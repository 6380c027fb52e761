#pragma once
/**
# Striking a chain

Several sections of the article strike the first bead of a resting chain, Eq. (26),
$$y_n(0) = 0,\qquad \dot y_1(0) = v_0,\qquad \dot y_n(0) = 0 \text{ for } n \ge 2,$$
and ask what travels away: with harmonic, hard or soft wells, with precompression, in an array with a
defect, and in the limit of small amplitude. All of them use the loop in time of this file. It watches the
energy and the front-most packet, and it sees to it that nothing comes back from the far end. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "lattice/diagnostics/observe.hpp"
#include "lattice/integrators/accuracy.hpp"
#include "lattice/model/chain.hpp"

namespace lattice {

/**
## How long is the chain?

A far end that the motion reaches sends it back, and what comes back is no property of the impact. In front
of everything else run either linear waves or, if the contacts are not compressed, strongly nonlinear
pulses. Beads with the stiffness $k$ of their wells and $K$ of their contacts have phonons between
$\sqrt k$ and $\sqrt{k+4K}$; the fastest of them travels at half the width of this band,
$$c = \tfrac12\bigl(\sqrt{k+4K}-\sqrt k\bigr)\ \text{sites per unit of time.}$$
In a chain without wells, $k = 0$, the strongest pulse of an impact has the overlap $x$ at most whose energy is
$x^{\alpha+1}/(\alpha+1) = \frac25 v_0^2$, which is $v_0^{4/5}$ for spheres, and
the speed of the sound for which $K = \frac45 v_0^2/x^2$, or $\frac45 v_0^{2/5}$. So we insert the larger of this and the
stiffness at rest, and give the chain 15 per cent more than this way and a hundred sites.

This is an estimate and not a bound. What counts is whether the
far end has remained at rest. A run therefore records the largest velocity of its last bead, and refuses to
give a result if that exceeds `far_end` times the impact's. Where the far end is part of the experiment
`far_end` is `may_move`. */
/// For `far_end`: the far end may move.
inline constexpr double may_move = std::numeric_limits<double>::infinity();

/// Thrown if the motion reaches the far end; the message says when and by how much.
struct FarEndReached : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What is struck, and how it is watched; dimensionless, as in Eqs. (9), (10) and (26). By default the
/// impact of the article's section 3.4.
struct Impact {
  double velocity = 1.87;
  Chain chain{100};
  double time = 600;
  double sample = 0.2;    ///< time between two looks, at most
  double far_end = 1e-9;  ///< the last bead's largest velocity allowed, over `velocity`
  bool denser = true;     ///< a refinement (accuracy.hpp) also takes more samples
  /// The site at which the run ends, once the packet's centre has passed it.
  std::optional<double> until{};
};

/// The same impact on a chain so long that nothing crosses it within the time of the run; its own length is ignored.
/// Throws std::invalid_argument for a chain with masses and stiffnesses, since how they go on is not known.
Impact endless(Impact impact);

/// The chain at rest but for its first bead, Eq. (26). Throws std::invalid_argument without sites.
State<double> struck(std::size_t sites, double velocity);

/**
## One run

What comes out is the state at the end, the front-most packet from sample to sample, and what tells whether
the run can be trusted. */
struct ImpactRun {
  State<double> end{};
  Track track{};
  std::vector<double> density{};  ///< energy density at the end
  Run run{};
  double reach = 0;    ///< largest displacement seen, to be compared with the well's rim
  double far_end = 0;  ///< largest velocity of the last bead
};

/**
A run stops when the far end moves. If its energy is not conserved, this says nothing about the far end, and the run
is broken. */
/// Whether the last bead has moved no more than `impact` allows.
bool is_quiet(const Impact& impact, const ImpactRun& run);
/// Throws FarEndReached if it has, or makes `run` one that is broken.
void assert_quiet(const Impact& impact, ImpactRun& run);

/**
Here is the loop. `go_on` carries a run from where it is to `time`; in between the chain or the method may
have been changed. `watch(state, density)` sees every sample and may return false to stop the run. Samples
become denser together with the steps of a refinement, so that the error of a maximum between two samples
shows in the difference of two runs. Then a run may only stop at instants that the coarser one samples as
well. */
template <class Stepper, class Watch = Unwatched>
void go_on(const Stepper& stepper, const Impact& impact, ImpactRun& run, double time,
           Watch watch = {}) {
  const Chain& chain = impact.chain;
  const int halvings = halvings_of(stepper);
  const TimeGrid plain = time_grid(time - run.end.t, impact.sample, stepper.step);
  const TimeGrid grid =
      impact.denser ? denser_samples(plain, halvings) : shorter_steps(plain, halvings);
  const std::size_t each = impact.denser ? std::size_t(1) << halvings : 1;
  std::size_t k = 0;
  const auto look = [&](const State<double>& now) {
    run.density = energy_density(chain, now);
    bool on = true;
    if constexpr (std::is_same_v<decltype(watch(now, run.density)), bool>)
      on = watch(now, std::as_const(run.density));
    else
      watch(now, std::as_const(run.density));
    if (k++ == 0) return on;
    for (double y : now.y) run.reach = std::max(run.reach, std::abs(y));
    run.far_end = std::max(run.far_end, std::abs(now.v.back()));
    const auto site = front_packet(run.density);
    if (site) run.track.add(now.t, run.density, *site);
    const bool passed = site && impact.until && run.track.centre.back() >= *impact.until;
    return on && is_quiet(impact, run) && ((k - 1) % each != 0 || !passed);
  };
  const Run part = evolve(stepper, chain, run.end, grid, look);
  run.run = joined(run.run, part);
  assert_quiet(impact, run);
}

/// The whole run from the impact on, of a chain that has a length.
template <class Stepper, class Watch = Unwatched>
ImpactRun strike(const Stepper& stepper, const Impact& impact, Watch watch = {}) {
  ImpactRun run{struck(impact.chain.sites, impact.velocity)};
  go_on(stepper, impact, run, impact.time, std::move(watch));
  return run;
}

/**
For errors the chain is struck twice, with resolutions that agree to `tolerance` (accuracy.hpp), by default
in their end states. */
/// Throws like `converged`, and FarEndReached.
template <class Differ = EndState>
Refined<ImpactRun> strike_to(double tolerance, const Impact& impact, Differ differ = {}) {
  Refinement<ImpactRun, Differ, decltype(&hopeless)> runs(tolerance, differ, hopeless);
  while (runs.wants_more()) runs.add(strike(runs.stepper(), impact));
  return converged(std::move(runs).last_two(), tolerance, differ.name);
}

/**
Shares of the energy refer to its total. */
/// The sum of a density.
double total(const std::vector<double>& e);

/// Share of the first `sites` sites in a density: what an impact leaves at the boundary.
double boundary_share(const std::vector<double>& e, std::size_t sites = 5);

/**
The foremost packet need not be the strongest. In hard wells a weak one runs ahead while most of the energy stays
behind, in a packet that slows down and turns. */
/// The site, from one, of the largest entry of a density behind the first `sites`; nothing where all are zero.
std::optional<std::size_t> strongest_site(const std::vector<double>& e, std::size_t sites = 5);

}  // namespace lattice
