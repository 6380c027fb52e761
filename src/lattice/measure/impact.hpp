#pragma once
/**
# Striking a chain

Several sections of the article strike the first bead of a resting chain and ask what
travels away: with a linear, hard or soft well, with precompression, with a defect, and
in the DpS limit. This file holds the question and the way it is watched; the answers
belong to the chapters. */

#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

#include "lattice/measure/observe.hpp"
#include "lattice/stepping/accuracy.hpp"

namespace lattice {

/// An impact on the first of `sites` beads; dimensionless, as Eqs. (9), (10) and (26).
struct Impact {
  double velocity = 1.87;
  double s = 0;
  double time = 600;
  std::size_t sites = 100;
  bool pendulum = false;
  double precompression = 0;
};

/**
The kind of well and contact is known only at run time, the inner loop wants it at
compile time. `with_chain` makes the choice once and hands the chain to `use`. */
template <class Use>
auto with_chain(const Impact& impact, Use use) {
  const auto with_contact = [&](auto contact) {
    if (impact.pendulum) return use(Chain<Pendulum, decltype(contact)>{impact.sites, {}, contact});
    return use(Chain<Quartic, decltype(contact)>{impact.sites, {impact.s}, contact});
  };
  if (impact.precompression > 0) return with_contact(CompressedHertz{impact.precompression});
  return with_contact(Hertz{});
}

/// The chain at rest but for its first bead, Eq. (26).
inline State<double> struck(std::size_t sites, double velocity) {
  State<double> state(sites);
  state.v[0] = velocity;
  return state;
}

/**
What one run shows of its front-most packet and of what stays behind. */
struct Outcome {
  Track track;
  State<double> end;
  std::vector<double> density;  ///< energy density at the end
  Run run;
  double reach = 0;  ///< largest displacement seen, to be compared with the well's rim
};

/**
Total of a density. */
inline double total(const std::vector<double>& e) {
  return std::accumulate(e.begin(), e.end(), 0.0);
}

/// Share of the first `sites` sites in a density: what an impact leaves at the boundary.
inline double boundary_share(const std::vector<double>& e, std::size_t sites = 5) {
  return std::accumulate(e.begin(), e.begin() + std::ptrdiff_t(std::min(sites, e.size())), 0.0) /
         total(e);
}

/**
Follows the front-most packet, which is looked at after every sample, until its centre passes
site `until` or the time is over. `watch(state, density)` sees every sample. The run stops at
whole multiples of `each` samples only, so that runs with denser samples end at the same time. */
template <class Stepper, class Watch>
Outcome follow(const Stepper& stepper, const Impact& impact, double until, const Pace& pace,
               Watch watch, std::size_t each = 1) {
  return with_chain(impact, [&](const auto& chain) {
    Outcome out;
    out.end = struck(impact.sites, impact.velocity);
    std::size_t k = 0;
    out.run = evolve(stepper, chain, out.end, pace, [&](const State<double>& now) {
      out.density = energy_density(chain, now);
      watch(now, std::as_const(out.density));
      if (k++ == 0) return true;
      for (double y : now.y) out.reach = std::max(out.reach, std::abs(y));
      const auto site = front_packet(out.density);
      if (site) out.track.add(now.t, out.density, *site);
      return (k - 1) % each != 0 || !site || out.track.centre.back() < until;
    });
    return out;
  });
}

/// As above, with samples `sample` apart or a little less.
template <class Stepper, class Watch>
Outcome follow(const Stepper& stepper, const Impact& impact, double until, double sample,
               Watch watch) {
  return follow(stepper, impact, until, pace_for(stepper, impact.time, sample), std::move(watch));
}

/**
Follows a packet at two resolutions that agree to `tolerance` (see accuracy.hpp), by default in
their end states. The finer one has steps half as long and twice the samples. Throws NotConverged.
*/
template <class Differ = EndState>
Refined<Outcome> follow_to(double tolerance, const Impact& impact, double until, double sample,
                           Differ differ = {}) {
  return converge(
      tolerance,
      [&](const ContactAware& stepper) {
        return follow(stepper, impact, until, dense_pace(stepper, impact.time, sample), Unwatched{},
                      std::size_t(1) << stepper.halvings);
      },
      differ);
}

}  // namespace lattice
