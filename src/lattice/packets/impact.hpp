#pragma once
/**
# Striking a chain

Several sections of the article strike the first bead of a resting chain, Eq. (26),
$$y_n(0) = 0,\qquad \dot y_1(0) = v_0,\qquad \dot y_n(0) = 0 \text{ for } n \ge 2,$$
and ask what travels away: with harmonic, hard or soft wells, with precompression, with a defect, and in
the limit of small amplitude. This file makes the run and watches it; the answers belong to the
programs. */

#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

#include "lattice/model/chain.hpp"
#include "lattice/packets/observe.hpp"
#include "lattice/stepping/accuracy.hpp"

namespace lattice {

/// An impact with `velocity` on the first bead of `chain`, followed for `time`; dimensionless, as in
/// Eqs. (9), (10) and (26). By default that of the article's section 3.4, with v_0 = 1.87.
struct Impact {
  double velocity = 1.87;
  Chain chain{100};
  double time = 600;
};

/// The chain at rest but for its first bead, Eq. (26).
State<double> struck(std::size_t sites, double velocity);

/**
A far end that the motion reaches sends it back, and what comes back is no property of the impact. How long
must a chain be? Packets in wells move by less than a site per unit of time, unless the impact is so strong
that the wells hardly matter. What then travels are the pulses of a chain without wells, and their speed
grows with the power 1/5 of the impact velocity. If the contacts are compressed sound comes first, with at
most the root of their stiffness at rest. */
/// `chain` at a length that an impact of `velocity` does not cross within `time`.
Chain endless(Chain chain, double velocity, double time);

/**
A run shows its front-most packet and what stays behind. */
struct Outcome {
  Track track;
  State<double> end;
  std::vector<double> density;  ///< energy density at the end
  Run run;
  double reach = 0;  ///< largest displacement seen, to be compared with the well's rim
};

/**
Shares of the energy refer to its total, the sum of the density. */
double total(const std::vector<double>& e);

/// Share of the first `sites` sites in a density: what an impact leaves at the boundary.
double boundary_share(const std::vector<double>& e, std::size_t sites = 5);

/**
`follow` makes the run. It tracks the front-most packet from sample to sample until its centre passes site
`until` or the time is over. `watch(state, density)` sees every sample. The run stops at whole multiples of
`each` samples only, so that runs with denser samples end at the same time. */
template <class Stepper, class Watch>
Outcome follow(const Stepper& stepper, const Impact& impact, double until, const TimeGrid& grid,
               Watch watch, std::size_t each = 1) {
  const Chain& chain = impact.chain;
  Outcome out;
  out.end = struck(chain.sites, impact.velocity);
  std::size_t k = 0;
  out.run = evolve(stepper, chain, out.end, grid, [&](const State<double>& now) {
    out.density = energy_density(chain, now);
    watch(now, std::as_const(out.density));
    if (k++ == 0) return true;
    for (double y : now.y) out.reach = std::max(out.reach, std::abs(y));
    const auto site = front_packet(out.density);
    if (site) out.track.add(now.t, out.density, *site);
    return (k - 1) % each != 0 || !site || out.track.centre.back() < until;
  });
  return out;
}

/// As above, with samples `sample` apart or a little less.
template <class Stepper, class Watch>
Outcome follow(const Stepper& stepper, const Impact& impact, double until, double sample,
               Watch watch) {
  return follow(stepper, impact, until, time_grid_for(stepper, impact.time, sample),
                std::move(watch));
}

/**
For the error of a speed the packet is followed at two resolutions that agree to `tolerance`
(accuracy.hpp), by default in their end states. The finer one has half the step and twice the samples.
Throws RefinementFailed. */
template <class Differ = EndState>
Refined<Outcome> follow_to(double tolerance, const Impact& impact, double until, double sample,
                           Differ differ = {}) {
  return converge(
      tolerance,
      [&](const ContactAware& stepper) {
        return follow(stepper, impact, until, dense_time_grid(stepper, impact.time, sample),
                      Unwatched{}, std::size_t(1) << stepper.halvings);
      },
      differ);
}

}  // namespace lattice
