#pragma once
/**
# Striking a DpS chain

The impact of measure/impact.hpp in the limit of small amplitude: the density is $|A_n|^2$ and the
time is the slow one. */

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "lattice/dps/evolve.hpp"
#include "lattice/measure/observe.hpp"

namespace lattice {

/// The track of the packet, the field at the end, and how far the norm drifts on the way.
struct DpsOutcome {
  Track track;
  Field end;
  double norm_drift = 0;
};

/// Follows the packet that leaves the struck field `start`; `watch(tau, field)` sees every sample.
template <class Watch>
DpsOutcome follow_dps(const Dps& dps, const Field& start, double duration, std::size_t samples,
                      const Tolerance& tolerance, Watch watch) {
  DpsOutcome out{{}, start, 0};
  out.norm_drift =
      evolve_dps(dps, out.end, duration, samples, tolerance, [&](double tau, const Field& field) {
        watch(tau, field);
        const auto d = density(field);
        const auto site = front_packet(d);
        if (tau > 0 && site) out.track.add(tau, d, *site);
      });
  return out;
}

/**
Largest |A_n| of a DpS packet while its centre moves over the last site of its track. */
inline double packet_amplitude(const Track& track) {
  const double end = track.centre.back();
  return std::sqrt(track.largest_peak(end - 1, end));
}

/**
The same impact twice: a hundred times the tolerance with `samples` samples, then `tolerance`
with twice as many, because amplitudes and speeds are read from the samples. */
struct DpsPair {
  DpsOutcome coarse, fine;
};

template <class Watch>
DpsPair follow_dps_to(double tolerance, const Dps& dps, const Field& start, double duration,
                      std::size_t samples, Watch watch) {
  return {follow_dps(dps, start, duration, samples, 100 * tolerance, Unwatched{}),
          follow_dps(dps, start, duration, 2 * samples, tolerance, std::move(watch))};
}

}  // namespace lattice
