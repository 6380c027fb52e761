#pragma once
/**
# Packets among phonons

Under precompression the largest single density need not belong to a packet. The packet is where the sites within 20 of
one another hold the most energy, and how it fares is read from a few numbers at each instant. */

#include <cmath>
#include <cstddef>
#include <vector>

#include "lattice/model/chain.hpp"

namespace lattice {

/// Sites on either side of a packet's centre that belong to it, and of those to which its envelope is fitted.
inline constexpr std::size_t compressed_half_width = 20, envelope_half_width = 10;

/// The site around which all sites within `half_width` together hold the most energy.
std::size_t richest(const std::vector<double>& e, std::size_t half_width);

/// Time, energy centre, shares of packet and of the first five sites, participation number of the chain, and of the
/// packet alone, at one instant.
struct PacketSample {
  double t, centre, share, boundary, participation, packet_sites;
};
/// From the energy density `e` at time `t`.
PacketSample packet_sample(double t, const std::vector<double>& e);

/**
A breather keeps its energy. The front of a linear wave train spreads like $t^{1/3}$, and its share falls like
$t^{-1/3}$. A surface mode keeps its share of the first five sites, while a train thins out there like $1/t$ or
faster. */
struct Traits {
  /// Exponents of both shares over the last three quarters of the samples, mean speed of the centre there, and its
  /// least advance in any 100 units of time over the mean one.
  double share_exponent, boundary_exponent, speed, steadiness;
};
/// Of samples one unit of time apart that last more than 140.
Traits traits(const std::vector<PacketSample>& samples);

/**
If the motion is nearly harmonic with frequency $\omega$, velocity and acceleration are a quarter of a period apart, and
$a_n = (v_n^2 + (\ddot y_n/\omega)^2)^{1/2}$ with $\omega^2 = \sum \ddot y_n^2 / \sum v_n^2$ is the amplitude of the
velocity at site $n$, free of the carrier. The frequency is that of the packet, and not of the waves behind it. */
struct Envelope {
  double omega = 0;                 ///< of the carrier
  std::vector<double> amplitude{};  ///< of the velocity, one entry per site
};
/// Frequency of the carrier in `range` and amplitudes of all sites.
Envelope envelope(const Chain& chain, const State<double>& state, Window range);

/// The envelope of a soliton, Eq. (38); sites are counted from one, `residual` is the root mean square misfit over
/// the height.
struct Sech {
  double height = 0, centre = 0, width = 0, residual = 0;
  /// Its value at site n.
  double at(double n) const { return height / std::cosh((n - centre) / width); }
};
/// The sech that fits the values `a` in `range` best, by the Gauss-Newton method from their maximum and this `width`.
/// A step that does not lessen the misfit is halved; if no part of it does, we have arrived.
Sech fit_sech(const std::vector<double>& a, Window range, double width);

/**
The 21 sites of the fit lie about the top of the envelope. The centre of energy is near it once the packet has formed.
While it forms, at $t = 291$, the centre lies six sites behind, because waves on one side of the packet hold energy too;
a sech fitted about it would come out too wide by forty per cent and miss by more. So where the top is not in the inner
half of the window about the centre, the window moves there. */
struct Snapshot {
  State<double> state;
  double centre;      ///< of the window of the fit, in sites from one
  Envelope envelope;  ///< of the whole chain
  Sech sech;          ///< fitted about the top of the envelope
};
/// The snapshot of `state`, its sech fitted around the packet.
Snapshot snapshot(const Chain& chain, const State<double>& state);
/// Root mean square of the envelope between 40 and 80 sites behind (`side` = -1) or ahead (+1) of the packet, over
/// the sech's height: nothing is left of the sech there.
double tail_amplitude(const Snapshot& shot, int side);

}  // namespace lattice
