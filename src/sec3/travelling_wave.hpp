#pragma once
/**
# Exact periodic travelling waves of small amplitude

`sec31_dps_limit` has their equation. Here it is solved for odd waves $u = \sum_k b_k\sin k\varphi$ of a whole number of
sites, by iteration. The forces of the present wave have the harmonics $\epsilon^{\alpha-1}G_k$, and
$b_k = \epsilon^{\alpha-1}G_k/(1-k^2\omega^2)$ is the next wave for $k\ge2$. At $k = 1$ the same equation has a small
denominator. At *equal frequency* it fixes $b_1$, since $G_1$ grows like $b_1^\alpha$; at *equal amplitude*, $b_1 = 2$,
it fixes $\omega$, and the exact wave runs ahead of the plane wave. */

#include <cstddef>

#include "lattice/numerics/estimate.hpp"

namespace lattice {

/// Distances of the exact wave from the plane wave of the DpS equation, from 24 and 48 harmonics.
struct WaveDistances {
  Estimate largest;  ///< over the phases, at equal frequency, hence at all times
  Estimate
      at_equal_amplitude;  ///< the largest at t = 0 and t = eps^(1-alpha), the later one prevails
};

/// For a wavelength of 2, 3 or 4 `sites` and contacts of the exponent `alpha`. Throws std::runtime_error without
/// convergence.
WaveDistances wave_distances(std::size_t sites, double eps, double alpha);

}  // namespace lattice
