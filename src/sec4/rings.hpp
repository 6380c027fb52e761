#pragma once
/**
# What becomes of a modulated phonon on a ring

An instability magnifies differences, so each question is asked of two runs side by side, whose steps differ by a factor
of two, and only as long as both give the same state. */

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "lattice/integrators/integrate.hpp"
#include "lattice/numerics/estimate.hpp"
#include "sec4/packets.hpp"

namespace lattice {

/**
The number of sites that share the energy of the *ring* does not measure the packet: it counts the background too. So we
take the width of the highest hump at half its height, of the density averaged over five neighbours, because within half
a wavelength the carrier makes it oscillate. */
/// That width, in sites; all of them if the density does not fall to half of its height.
double packet_width(const std::vector<double>& density);

/// What is seen of a ring at one instant.
struct RingSample {
  double t, peak_over_mean, participation;
  double second;  ///< energy of the second richest window of 21 sites over that of the richest
  bool gathered;  ///< five times the mean density at a site, and half of the sites share the energy
  double width = 0;  ///< of the packet at half height
};
RingSample ring_sample(const Chain& ring, const State<double>& state);

/// A ring after 60 units of time, some ten oscillations, during which the packet's centre was followed.
struct WatchedRing {
  State<double> end;
  std::vector<double> density{};  ///< of the energy at the end
  std::vector<double> t{}, centre{};
  double drift = 0;  ///< of the energy, relative
  Snapshot shown{};  ///< of the end
};
WatchedRing watch_packet(const Method& method, const Chain& ring, State<double> state);

/// What has become of the wave, from two runs: largest density over the mean, share of the sites that share the
/// energy, speed of the centre with the error of its fit, and width of the packet.
struct Formed {
  Estimate peak_over_mean, share_of_sites, speed, width;
};
Formed formed(const WatchedRing& coarse, const WatchedRing& fine);

/**
Two runs are looked at every 50 units of time, and stop when their relative distance has reached a tenth: later
statements would be merely statistical. If they have not parted by `longest`, `agree` is how long they were watched, and
exact. */
/// Two runs side by side, the finer one second.
struct RingPair {
  std::vector<std::array<RingSample, 2>> samples{};
  Estimate agree{};                     ///< how long the runs agree
  double gathered = std::nan("");       ///< when the energy has gathered in both,
  std::array<WatchedRing, 2> packet{};  ///< and what they look like a little later

  /// `gathered`, which is known to within one interval between two looks.
  Estimate gathering() const;
  Formed formed() const;  ///< from both packets
  /// The least width of the packet, up to half as long again as it took the energy to gather.
  Estimate width() const;
  /// The largest density over the mean.
  Estimate highest() const;
  /// Whether there is a packet of five times the mean density, on a quarter of the ring, that moves to the right.
  bool travels() const;
};
/// Goes on until the runs part, until `longest`, or until `patience` times the time that it takes the energy to
/// gather.
RingPair side_by_side(const Chain& ring, const State<double>& start, double longest,
                      const std::array<double, 2>& steps,
                      double patience = std::numeric_limits<double>::infinity());

/**
A pulse splits when the second window holds half of the first or more, in both runs, after the pulse has gone round the
ring once as one. This could be a pulse that spreads; so later the energy is to be gathered and shared in the same
way. */
struct PulseSplits {
  Estimate one_pulse_for;        ///< the longest time for which it was one pulse before
  Estimate splits_at, apart_at;  ///< nan if it does not
};
/// With the time that a pulse needs to go round the ring.
PulseSplits pulse_splits(const RingPair& pair, double round);

}  // namespace lattice
