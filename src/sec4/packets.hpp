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
#include "report/program.hpp"

namespace lattice {
using report::undefined;

/// Sites on either side of a packet's centre that belong to it, and of those to which its envelope is fitted.
inline constexpr std::size_t compressed_half_width = 20, envelope_half_width = 10;

/// Time, energy centre, fractions of the energy in the packet and on the first five sites, participation of the packet.
struct PacketSample {
  double t, centre, share, boundary, sites = 0;
};
PacketSample packet_sample(double t, const std::vector<double>& e);

/// The mean number of its sites over the samples in the `time` until `t`.
double mean_sites(const std::vector<PacketSample>& samples, double t, double time);

/// Exponents of these fractions in time over the samples after the part `from` of the run, mean speed of the centre, and
/// its least advance in any 100 units of time over the mean one. The samples are one unit of time apart, 140 at least.
struct Traits {
  double share_exponent, boundary_exponent, speed, steadiness;
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

/// The envelope of a soliton, Eq. (38), sites from one; `residual` is the root mean square misfit over the height.
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
  std::vector<double> density;  ///< of the energy
  double centre;                ///< of the window of the fit, in sites from one
  Envelope envelope;            ///< of the whole chain
  Sech sech;                    ///< fitted about the top of the envelope

  /// The larger one of the sech's width and the distance of its top from the centre of the window.
  double reach() const { return std::max(std::abs(sech.centre - centre), sech.width); }
};
Snapshot snapshot(const Chain& chain, const State<double>& state);
/// Root mean square of the envelope from 40 to 80 sites behind (`side` = -1) or ahead (+1) of the packet, over the height.
double tail_amplitude(const Snapshot& shot, int side);
/// The highest wave more than 30 sites behind the packet, over the sech's height.
double train_amplitude(const Snapshot& shot);

/// Width in sites of the highest hump on a ring at half its height, of the density averaged over five neighbours, because
/// the carrier makes it oscillate; all sites if the density does not fall so far. (Participation counts the background.)
double packet_width(const std::vector<double>& density);

/// The height of the second hump on a ring over that of the highest, of the same average: from the second to the first it
/// must fall, both ways round the ring, below half of the second. Zero if there is none.
double second_hump(const std::vector<double>& density);

/// The energy is localized if a site has five times the mean density and fewer than half of the sites share it.
bool is_localized(const std::vector<double>& density);

/// What is seen of a ring at one instant: width of the packet, second hump, whether the energy is localized.
struct RingSample {
  double t, width, second;
  bool localized;
};
RingSample ring_sample(const Chain& ring, const State<double>& state);

inline constexpr double watched_time = 60;  ///< some ten oscillations
/// A ring after this time, during which the packet's centre was followed.
struct WatchedRing {
  Snapshot end;
  std::vector<double> t{}, centre{};
};
WatchedRing watch_packet(const Method& method, const Chain& ring, State<double> state);

/// The packet of two such runs: largest density over the mean, fraction of the sites that share the energy, speed of the
/// centre with the error of its fit, width.
struct Packet {
  Estimate peak_over_mean = undefined, share_of_sites = undefined, speed = undefined,
           width = undefined;
};
Packet packet_of(const TwoRuns<WatchedRing>& runs);

/// A splitting that keeps the largest stretch of a contact after any of its steps.
struct WatchedSplitting {
  Splitting method;
  double* largest_stretch;
  double step = method.step;

  double advance(const Chain& chain, State<double>& state, Window& window, double h,
                 std::size_t count) const;
};

/// Two runs with two steps side by side, the finer one second, sampled every 50 units of time.
struct RingPair {
  std::vector<std::array<RingSample, 2>> samples{};
  Estimate agree{};                ///< how long they agree; exact if they have not parted
  Estimate stretch{};              ///< the largest stretch of a contact until then, after any step
  Estimate localized = undefined;  ///< when the energy has localized in both,
  TwoRuns<WatchedRing> later{};    ///< and both a little later

  /// The packet then, if the energy has localized.
  Packet packet() const { return localized.value > 0 ? packet_of(later) : Packet{}; }
  /// Its least width, up to 1.5 times that time; nan if the energy has not localized.
  Estimate width() const;
};
/// By `step` and half of it, until `longest` or `multiple` times the time of localization. An
/// instability magnifies differences: the runs stop before that when their relative distance has reached a tenth.
RingPair side_by_side(const Chain& ring, const State<double>& start, double step, double longest,
                      double multiple);

/// What becomes of a localized pulse: for how long there is no second one of half its height, and, up to twice the time of
/// localization, the largest height of a second one over the first, and the largest that it keeps while a phonon goes
/// `round` the ring. All nan if it never is.
struct PulseSplits {
  Estimate one_pulse_for = undefined, second = undefined, kept = undefined;
};
PulseSplits pulse_splits(const RingPair& pair, double round);

}  // namespace lattice
