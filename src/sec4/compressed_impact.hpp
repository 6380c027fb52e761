#pragma once
/**
# An impact on a compressed chain

Section 4 strikes the first bead of a compressed chain. This sends out linear waves (phonons,
dispersion.hpp) and perhaps a packet that holds together. This file makes the run and tells the two
apart.

Near the struck end contacts may open for a while, so the event-corrected method (event_corrected.hpp) integrates
until a settling time. After the article's impacts the motion is smooth from then on, and a splitting (schemes.hpp)
has its full order six. The chain is as long as impact.hpp makes it: somewhat longer than the way of the fastest phonon, ahead of
which the motion falls off super-exponentially. */

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "lattice/impact/impact.hpp"
#include "lattice/numerics/estimate.hpp"
#include "sec4/envelope.hpp"

namespace lattice {

/// An impact on a chain with wells of anharmonicity `s`, compressed by `d` (zero: not), in the run of
/// length `time`; the chain is as long as needed.
Impact compressed_impact(double s, double time, double velocity = 1.87, double d = 0.5);

/**
The packet is where most of the energy is (`richest` in envelope.hpp). How it fares is read from a few
numbers at each instant: where it is, its share of the energy, the share of the first five sites, and the
number of sites that share the energy. Packets under precompression are broader than those without it, so
20 sites on either side belong to one; its envelope is fitted to ten. */
inline constexpr std::size_t compressed_half_width = 20, envelope_half_width = 10;

/// Time, energy centre, shares of packet and boundary, participation number of the chain, and of the packet
/// alone, at one instant.
struct PacketSample {
  double t, centre, share, boundary, participation, packet_sites;
};

/// From the energy density `e` at time `t`.
PacketSample packet_sample(double t, const std::vector<double>& e);

/**
Is it a soliton of the NLS equation, whose envelope is a sech (Eq. (38))? At a few times we keep the whole
state, with the amplitudes of the velocity and the sech that fits them around the packet's centre.

The 21 sites of the fit lie about the top of the envelope. The centre of energy is near it once the packet has formed.
While it forms, at $t = 291$, the centre lies six sites behind, because waves on one side of the packet hold energy
too; a window about it sees one flank of the packet and these waves, and the sech comes out too wide, by forty per
cent, and misses by more. So where the top is not in the inner half of the window about the centre, the window moves
there.

The front of a wave train has a crest too, and over 21 sites a broad enough sech fits anything smooth; so a good fit
says little unless the packet keeps its energy. */
struct Snapshot {
  State<double> state;
  double centre;      ///< of the window of the fit, in sites from one
  Envelope envelope;  ///< of the whole chain
  Sech sech;          ///< fitted about the top of the envelope
};

/**
The late packet stands on a tail. Its amplitude on either side is the root mean square of the envelope between
40 and 80 sites from the packet's centre, where nothing is left of the sech, relative to the sech's height. */
/// Amplitude of the tail behind (`side` = -1) or ahead (+1) of the packet.
double tail_amplitude(const Snapshot& shot, int side);

/// The snapshot of `state`, its sech fitted around the packet.
Snapshot snapshot(const Chain& chain, const State<double>& state);

/**
A run has a sample every unit of time and snapshots at the times asked for. It also records when a contact
was last open, because the splitting of the later part relies on closed ones. */
struct CompressedRun : ImpactRun {
  std::vector<PacketSample> samples{};
  std::vector<Snapshot> shown{};
  double last_open = 0;  ///< time of the last sample with an open contact
};

/// Steps before and after the settling time.
struct CompressedSteps {
  double early = 0.1, late = 0.4;
  /// Both halved so many times.
  CompressedSteps halved(int times = 1) const {
    return {std::ldexp(early, -times), std::ldexp(late, -times)};
  }
};
/// When the methods are changed, in units of time.
inline constexpr double settling_time = 40;

/**
The impact takes place at $t = 0$. With compression we change methods at the settling time; without it
contacts go on opening, and the event-corrected method integrates all the time. */
CompressedRun strike_compressed(const Impact& impact, const std::vector<double>& times,
                                CompressedSteps steps);

/**
What is a breather, and what a wave train? A breather keeps its energy: the share of the packet goes like
$t^0$. The front of a linear wave train spreads like $t^{1/3}$, and its share falls like $t^{-1/3}$. In the same
way a surface mode keeps its share of the first five sites, while a train thins out there like $1/t$ or
faster. A packet that comes back moves backwards for some time: `steadiness` is the least advance in any 100
units of time over the mean one. */
struct Traits {
  /// Shares at the end, of packet and boundary, with their exponents; speed of the centre.
  double share, share_exponent, boundary, boundary_exponent, speed, steadiness;
};

/**
The exponents come from straight lines through the last three quarters of the samples. A run must last more
than 140 units of time, because the advance is taken over a hundred. */
Traits traits(const std::vector<PacketSample>& samples);

}  // namespace lattice
