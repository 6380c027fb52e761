#pragma once
/**
# Striking an array of cantilevers

In section 3.6 the first cantilever of a resting array is struck, Eq. (28), and a packet runs away from it. The run is
that of the dimensionless chain (cantilever.hpp, impact.hpp); this file translates to and from SI units and watches the
packet pass a given cantilever. */

#include <cstddef>
#include <vector>

#include "lattice/cantilever/cantilever.hpp"
#include "lattice/diagnostics/pulse.hpp"
#include "lattice/impact/impact.hpp"

namespace lattice {

/// One run of a struck array, whose hundredth beam or another one may carry beads of another radius.
struct ArrayRun {
  double ratio = 1;   ///< radius of the defect's beads divided by that of the others
  double until = 75;  ///< end of the run, ms
  double sample = 1;  ///< largest time between two samples, in units of tau_c
};

/// An array and the impact on its first cantilever, Eq. (28).
struct StruckArray {
  CantileverArray array{};
  double velocity = 1;  ///< m/s
  Scales scales = array.scales();

  /// The velocity of the impact in units of the chain.
  double struck_velocity() const { return scales.velocity(velocity); }
  /// Its energy in the same units.
  double energy() const { return struck_velocity() * struck_velocity() / 2; }

  /// The impact on the dimensionless chain.
  Impact impact(const ArrayRun& run) const {
    return {struck_velocity(), cantilever_chain(array, run.ratio), scales.time(run.until),
            run.sample};
  }
};

/// The motion of one cantilever and the push of the contact to its right, in units of xi and tau_c.
struct Watched {
  std::vector<double> t, force, v, y;
};

/// The largest push, velocity and deflection of a watched cantilever, the internal period, and the time of the strongest
/// push, its arrival.
struct Pulse {
  double arrival, force, velocity, deflection, period;  ///< s, N, m/s, m, s
};

/// The pulse at a watched cantilever; throws std::runtime_error if the packet did not pass it.
Pulse pulse_of(const Watched& w, const Scales& s);

/// How the packet moves, and every sample of one cantilever.
struct WatchedRun : ImpactRun {
  Watched at{};
};

/// The run of the homogeneous array up to `until` ms, a sample each `step` (in units of tau_c), watched at site `n`.
WatchedRun pass(const StruckArray& struck, std::size_t n, double until, double step);

/// Sites per second: `n` over the time at which the packet is strongest at site `n`, where the run was watched.
double mean_speed(const WatchedRun& run, const StruckArray& struck, std::size_t n);

/// How long, in ms, the packet's force at the watched contact is above `threshold` times its maximum.
double duration_above(const WatchedRun& run, const StruckArray& struck, double threshold);

/// The strongest push, in newtons, of each contact within each of `bins` equal times until `end` (in ms), entry
/// `bin * contacts + n`: a map of snapshots would miss most of the short pushes.
std::vector<double> strongest_forces(const StruckArray& struck, double ratio, double end,
                                     std::size_t bins);

}  // namespace lattice
