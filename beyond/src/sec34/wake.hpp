#pragma once
/**
# A packet without its waves

A packet leaves waves behind, and whether these turn it can be tried: take them away and see (sec34_boomeron_map.cpp).
What lies further than a distance behind it is damped; or the first bead is, which leaves all waves and only weakens
their reflection at the struck end. */

#include <cstddef>
#include <vector>

#include "lattice/impact/turning.hpp"

namespace lattice {

/// An impact in quartic wells, Eqs. (9), (10) and (26), and what is absorbed: the damping nu_n is zero elsewhere.
struct WavesAbsorbed {
  double s = 1, velocity = 1.9;
  std::size_t behind = 0;  ///< nu = 0.1 more than so many sites behind the packet, 0: nowhere
  bool first_bead =
      false;  ///< nu = 0.2 on the first bead, from t = 60 on, when the packet has left
};

/**
An absorber that follows the packet is placed anew whenever the observer looks, which is every 0.2 units of time,
or every two steps if these are shorter: so two steps also show the error of the moving absorber and of the
looks. In between, half of its friction acts before each step and half after it, as in driven_chain.hpp.

`sites` has to be so large that nothing comes back from the far end. Throws std::runtime_error when a wave has reached
it. */
/// The packet of an impact whose waves are absorbed.
Path follow_without(const WavesAbsorbed& impact, double step, double until, std::size_t sites,
                    const ImpactLook& watch = {});

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
