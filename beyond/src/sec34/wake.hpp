#pragma once
/**
# A packet without its waves

A packet leaves waves behind, and whether these turn it can be tried: take them away and see
(sec34_why_packets_turn.cpp). What lies further than a distance behind it is damped all the time or set to rest once;
the first bead is damped, which leaves all waves and only weakens their reflection at the struck end; or the packet is
moved to a long chain at rest, where it has neither old waves nor an end. */

#include <cstddef>
#include <vector>

#include "lattice/impact/turning.hpp"
#include "lattice/numerics/observer.hpp"

namespace lattice {

/// An impact in quartic wells, Eqs. (9), (10) and (26), and what is absorbed: the damping nu_n is zero elsewhere.
struct WavesAbsorbed {
  double s = 1, velocity = 1.9;
  std::size_t behind = 0;  ///< nu = 0.1 more than so many sites behind the packet, 0: nowhere
  bool first_bead =
      false;         ///< nu = 0.2 on the first bead, from t = 60 on, when the packet has left
  double wiped = 0;  ///< when all sites more than eight behind the packet are set to rest, 0: never
  double moved = 0;  ///< when its seventeen sites are moved to the middle of a chain at rest
  std::size_t around = 0;  ///< from then on nu = 0.1 more than so many sites from it, 0: nowhere
};

/// Half of the window of seventeen sites that is left when all others are set to rest.
inline constexpr std::size_t kept = 8;

/// Sees the state, its energy density, and the centre of the packet, counted from the first bead of the chain that was
/// struck. It may return false to end the run.
using PacketLook = Observer<State<double>, std::vector<double>, double>;

/**
An absorber that follows the packet is placed anew whenever the observer looks, which is every 0.2 units of time,
or every two steps if these are shorter: so two steps also show the error of the moving absorber and of the
looks. In between, half of its friction acts before each step and half after it, as in driven_chain.hpp.

`sites` has to be so large that nothing comes back from the far end. Throws std::runtime_error when a wave has reached
it. */
/// The packet of an impact whose waves are absorbed.
Path follow_without(const WavesAbsorbed& impact, double step, double until, std::size_t sites,
                    const PacketLook& watch = {});

/**
What becomes of such a packet in a long time? It *returns* if its mean over the width of the smoothing comes
back by five sites, the criterion of turning.hpp. Of the others one is *trapped* if it moves by less than a site
in the last tenth of the time, and the rest *go on*. */
enum class Late : std::int64_t { goes_on, returns, trapped };

/// What became of one packet.
struct LateFate {
  Late late = Late::goes_on;
  double furthest = 0;  ///< mean centre of the way out
  double when = 0;      ///< and the time of it
  Path path{};
};

/// Follows a packet until it has returned or the time is over.
LateFate late_fate(const WavesAbsorbed& impact, double step, double until, std::size_t sites);

}  // namespace lattice
