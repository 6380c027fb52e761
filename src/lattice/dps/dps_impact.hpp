#pragma once
/**
# Striking a DpS chain

This is an impact (impact/impact.hpp) in the limit of small amplitude, Eq. (25):
$A_1(0) = -i$ and all others zero. The packet is followed in the density $|A_n|^2$ and the slow time. */

#include <cstddef>
#include <vector>

#include "lattice/diagnostics/path.hpp"
#include "lattice/dps/evolve.hpp"

namespace lattice {

/// The path of the packet, the field at the end, and how far the norm drifts on the way.
struct DpsOutcome {
  Path path;  ///< its energy is the norm in the window
  Field end;
  double norm_drift = 0;  ///< relative
  double far_end = 0;     ///< largest |A_n| of the last site that a sample saw
};

/// Follows the packet that leaves the struck field `start`; `watch` sees every sample. Throws
/// std::runtime_error if GSL cannot go on.
DpsOutcome follow_dps(const Dps& dps, const Field& start, double duration, std::size_t samples,
                      const Tolerance& tolerance, const DpsObserver& watch = {});

/// The largest maximum in time of |A_n|, which oscillates from site to site, while the centre moves over the last site of
/// its path, or over the last two if none falls on the last. Its error is what the samples leave; both are nan where
/// there is none at all.
Estimate packet_amplitude(const Path& path);

}  // namespace lattice
