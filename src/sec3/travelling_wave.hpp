#pragma once
/**
# Exact periodic travelling waves of small amplitude

`sec31_dps_limit` has their equation, with $G_k$ as the harmonics of its bracket. Odd waves $u = \sum_k b_k\sin
k\varphi$ follow by iteration: $b_k = \epsilon^{\alpha-1}G_k/(1-k^2\omega^2)$ is the next one for $k\ge2$. At $k = 1$
it fixes $b_1$ at *equal frequency*, since $G_1$ grows like $b_1^\alpha$, and $\omega$ at *equal amplitude*, $b_1=2$. */

#include <cstddef>

#include "lattice/numerics/estimate.hpp"

namespace lattice {

/// Largest distances of the exact wave from the plane wave of the DpS equation, from 24 and 48 harmonics: at equal
/// frequency the same at all times, at equal amplitude the larger one of t = 0 and t = eps^(1-alpha).
struct WaveDistances {
  Estimate largest, at_equal_amplitude;
};

/// For a wavelength of 2, 3, 4, 6 or 8 `sites`. Throws std::invalid_argument unless they divide the samples.
WaveDistances wave_distances(std::size_t sites, double eps, double alpha);

}  // namespace lattice
