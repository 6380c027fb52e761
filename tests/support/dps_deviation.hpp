#pragma once
// How far the DpS approximation is from the chain, by another route than that of the chapter: the chain is carried from
// look to look by the event-driven flow, and the DpS equation by the library.

#include <algorithm>
#include <cmath>

#include "lattice/dps/evolve.hpp"
#include "lattice/events/event_driven.hpp"
#include "lattice/numerics/estimate.hpp"

/// The largest deviation of any bead up to the slow time one, from looks that are 0.2 and 0.1 apart.
inline lattice::Estimate dps_deviation(const lattice::Field& start, double eps,
                                       const lattice::Well& well = {},
                                       double rate = 1 / (2 * lattice::tau_0())) {
  const auto largest = [&](int looks, double tolerance) {
    const lattice::Chain chain{start.size(), well};
    const lattice::Dps dps{.sites = start.size(), .rate = rate};
    lattice::State<double> state = lattice::dps_state(start, eps, 0);
    lattice::Field field = start;
    double most = 0;
    for (int k = 1; k <= looks; ++k) {
      flow(chain, state, 1 / std::sqrt(eps) / looks);
      evolve_dps(dps, field, 1.0 / looks, 1, tolerance);
      const auto y = lattice::dps_state(field, eps, k / std::sqrt(eps) / looks).y;
      for (std::size_t n = 0; n < y.size(); ++n) most = std::max(most, std::abs(y[n] - state.y[n]));
    }
    return most;
  };
  const int looks = int(std::ceil(5 / std::sqrt(eps)));
  return lattice::with_error(largest(looks, 1e-9), largest(2 * looks, 1e-11));
}
