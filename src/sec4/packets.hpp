#pragma once
/**
# Packets among phonons

Under precompression the largest single density need not belong to a packet. The packet is where the sites within 20 of
one another hold the most energy. */

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lattice/integrators/integrate.hpp"
#include "lattice/numerics/estimate.hpp"

namespace lattice {

inline const Estimate none{std::nan(""), std::nan("")};  ///< no such quantity

/// Sites on either side of a packet's centre that belong to it, and of those to which its envelope is fitted.
inline constexpr std::size_t compressed_half_width = 20, envelope_half_width = 10;

/// The site around which all sites within `half_width` together hold the most energy.
std::size_t richest(const std::vector<double>& e, std::size_t half_width = compressed_half_width);

/// How many of the sites within `half_width` of it share their energy.
double packet_participation(const std::vector<double>& e, std::size_t half_width);

/// Time, energy centre, shares of packet and of the first five sites, participation number of the chain, from the energy
/// density `e` at one instant; and the share of a packet of half and of twice this width.
struct PacketSample {
  double t, centre, share, boundary, participation, narrow, wide;
};
PacketSample packet_sample(double t, const std::vector<double>& e);

/// Exponents of the shares in time over the samples after the part `from` of the run, mean speed of the centre there, and
/// its least advance in any 100 units of time over the mean one. The samples are one unit of time apart, 140 at least.
struct Traits {
  double share_exponent, boundary_exponent, speed, steadiness, narrow_exponent, wide_exponent;
};
Traits traits(const std::vector<PacketSample>& samples, double from = 0.25);

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
Sech fit_sech(const std::vector<double>& a, Window range, double width);

/**
The 21 sites of the fit lie about the top of the envelope. The centre of energy is near it once the packet has formed.
While it forms, at $t = 291$, the centre lies six sites behind, because waves behind the packet hold energy too. So where
the top is not in the inner half of the window about the centre, the window moves there. */
struct Snapshot {
  State<double> state;
  double centre;      ///< of the window of the fit, in sites from one
  Envelope envelope;  ///< of the whole chain
  Sech sech;          ///< fitted about the top of the envelope

  /// The larger one of the sech's width and the distance of its top from the centre of the window.
  double reach() const { return std::max(std::abs(sech.centre - centre), sech.width); }
};
Snapshot snapshot(const Chain& chain, const State<double>& state);
/// The same fitted to the sites within `half_width` of the same centre.
Sech sech_within(const Snapshot& shot, std::size_t half_width);
/// Root mean square of the envelope on the 21 sites of the fit.
double rms_of_fit(const Snapshot& shot);
/// Root mean square of the envelope from `near` to `far` sites behind (`side` = -1) or ahead (+1) of the packet, over
/// the sech's height: nothing is left of the sech there.
double tail_amplitude(const Snapshot& shot, int side, long near = 40, long far = 80);
/// The highest wave more than 30 sites behind the packet, over the sech's height.
double train_amplitude(const Snapshot& shot);

/// Width in sites of the highest hump on a ring at half its height, of the density averaged over five neighbours, because
/// the carrier makes it oscillate; all sites if the density does not fall so far. (Participation counts the background.)
double packet_width(const std::vector<double>& density);

/// The height of the second hump on a ring over that of the highest, of a quantity averaged over five neighbours: from the
/// second to the first it must fall, both ways round the ring, below half of the second. Zero if there is none.
double second_hump(const std::vector<double>& a);

/// What is seen of a ring at one instant.
struct RingSample {
  double t, peak_over_mean;
  double second;  ///< height of a second hump of the energy density over that of the first
  bool
      localized;  ///< five times the mean density at a site, and half of the sites share the energy
  double width = 0;  ///< of the packet at half height
  double second_window =
      0;  ///< energy of the second richest window of 21 sites over that of the richest
  double second_of_figure = 0;  ///< as `second`, of the envelope of the displacements
};
RingSample ring_sample(const Chain& ring, const State<double>& state);

inline constexpr double watched_time = 60;  ///< some ten oscillations
/// A ring after this time, during which the packet's centre was followed.
struct WatchedRing {
  State<double> end;
  std::vector<double> density{};  ///< of the energy at the end
  std::vector<double> t{}, centre{};
  Snapshot shown{};  ///< of the end
};
WatchedRing watch_packet(const Method& method, const Chain& ring, State<double> state);

/// The packet of two such runs: largest density over the mean, fraction of the sites that share the energy, speed of the
/// centre with the error of its fit, width, and height of the envelope over its root mean square.
struct Packet {
  Estimate peak_over_mean = none, share_of_sites = none, speed = none, width = none,
           envelope_over_rms = none;
};
Packet packet_of(const WatchedRing& coarse, const WatchedRing& fine);

/// Two runs with two steps side by side, the finer one second, sampled every 50 units of time.
struct RingPair {
  std::vector<std::array<RingSample, 2>> samples{};
  Estimate agree{};                     ///< how long they agree; exact if they have not parted
  Estimate localized = none;            ///< when the energy has localized in both,
  std::array<WatchedRing, 2> packet{};  ///< and their packets a little later

  /// The least width of the packet, up to 1.5 times this; nan if the energy has not localized.
  Estimate width() const;
};
/// By `step` and half of it, until `longest` or `patience` times the time of localization. An
/// instability magnifies differences: the runs stop before that when their relative distance has reached a tenth.
RingPair side_by_side(const Chain& ring, const State<double>& start, double step, double longest,
                      double patience);

/// What becomes of a localized pulse: for how long there is no second one of half its height, and, up to twice the time of
/// localization, the largest height of a second one over the first; the largest that it keeps while a phonon goes `round`
/// the ring; the same of the envelope of the displacements and of the energy in two windows, also of those only while the
/// energy is localized. All nan if it never is.
struct PulseSplits {
  Estimate one_pulse_for = none, second = none, kept = none, of_figure = none, in_windows = none,
           in_windows_localized = none;
};
PulseSplits pulse_splits(const RingPair& pair, double round);

}  // namespace lattice
