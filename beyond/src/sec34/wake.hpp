#pragma once
/**
# A packet without its waves

A packet leaves waves behind, and whether these turn it can be tried: take them away and see (sec34_boomeron_why.cpp). What
lies further than a distance behind it is damped; or the first bead is, which leaves all waves and only weakens their
reflection at the struck end; or the packet is cut out and put on a quiet chain, where it meets only its own fresh wake. */

#include <cstddef>
#include <functional>
#include <vector>

#include "lattice/impact/turning.hpp"

namespace lattice {

/// An impact in quartic wells, Eqs. (9), (10) and (26), and what is taken away from it.
struct WavesRemoved {
  double s = 1, velocity = 1.9;
  double cut = 0;           ///< time at which the packet is cut out, 0: never
  std::size_t behind = 0;   ///< damps what lies more than so many sites behind it, 0: nothing
  bool first_bead = false;  ///< damps the first bead, once the packet has left
  bool counted = false;     ///< counts the energy that friction takes, which costs some time
};

/// The site of the largest density, which is where the packet is.
std::size_t peak_index(const std::vector<double>& density);

/**
A cut copies the packet with one site more on either side than its energy centre takes into account, onto a
chain that is longer by `shift` sites on the side where it comes from. Displacements and velocities are
untouched, so that if it moves differently afterwards the reason is that something is missing. */
State<double> cut_out(const Chain& chain, const State<double>& state, std::size_t shift);

/**
On the way the observer sees the chain before every sample, with the number of sites by which a cut has
shifted it and the energy that friction has taken. It may return false to end the run. */
struct WakeSample {
  const Chain& chain;
  const State<double>& state;
  const std::vector<double>& density;
  std::size_t peak;  ///< where the density is largest
  std::size_t shift;
  double dissipated;  ///< zero unless it is counted
};
/// Sees the chain; false ends the run.
using WakeLook = Observer<WakeSample>;

/**
An absorber that follows the packet is placed anew whenever the observer looks, which is every 0.2 units of time,
or every two steps if these are shorter: so two steps also show the error of the moving absorber and of the
looks. In between, half of its friction acts before each step and half after it, as in driven_chain.hpp.

`sites` is the length of the struck chain and of what a cut puts behind the packet. It has to be so long that
nothing comes back from its ends. Throws std::runtime_error when a wave has reached one. */
/// The packet of an impact from which something is taken away; its centre in sites of the struck chain.
Path follow_without(const WavesRemoved& impact, double step, double until, std::size_t sites,
                    const WakeLook& observe = {});

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
};

/// Follows a packet until it has returned or the time is over, and appends its way to `path` if there is one.
LateFate late_fate(const WavesRemoved& impact, double step, double until, std::size_t sites,
                   Path* way = nullptr);

/**
Where do energy and momentum go? The energy of the chain is divided among the packet with its eleven sites, the
waves up to fifteen sites behind its centre, those further behind, and friction; the sum is conserved but for
what runs ahead. The momentum of the packet's sites is changed by the push of the contact behind them, by that
of the contact ahead, and by the wells. */
struct Budget {
  double packet = 0, near = 0, far = 0, friction = 0;  ///< change of energy
  double push_behind = 0, push_ahead = 0, wells = 0;   ///< mean forces, the last one backward
};

/// The budgets of a packet between two times.
Budget budget(WavesRemoved impact, double step, double from, double to);

/**
Is the packet a breather that moves? Its energy centre and energy are means over stretches of twenty units of
time; so is $\sum\dot y_n^2$ over its sites, which times the period is its area in phase space. The frequency is
read from the upward zeros of $\sum(-1)^n y_n$ over the packet, since neighbours in a breather have opposite signs;
the alternating sign cancels long waves that run through it and would shift the zeros of a single site. */
struct Inside {
  double t = 0, site = 0, energy = 0, area = 0, omega = 0;  ///< t: middle of the stretch
};

/// The inside of a packet, stretch by stretch.
std::vector<Inside> gauge(const WavesRemoved& impact, double step, double until);

}  // namespace lattice
