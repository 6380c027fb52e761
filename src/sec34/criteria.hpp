#pragma once
/**
# What we call a travelling breather, a trapped mode, a coincidence

The article says in words that a wave is a travelling breather, that energy is trapped, that curves
coincide. Here each such statement becomes a set of conditions on measured numbers (criterion.hpp), in
functions without side effects, so that tests can feed them inputs for which the words would be wrong. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lattice/diagnostics/observe.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/numerics/criterion.hpp"

namespace lattice {

/**
A packet is a travelling breather if it lasts: it moves at a constant speed and keeps its energy. We
compare the first and the second half of its way, and allow changes of five per cent in speed and ten in
energy, since a young packet is still shedding its tail. The front of a linear wave train, whose width
grows as the cube root of time, passes the first test and fails the second. What stays behind is weak if
it is weaker than the packet: no window of the same width behind it holds as much energy. The limits are
ours. */
struct Endurance {
  Estimate speed_change, energy_change;  ///< second half against first half, relative
  Estimate residue;                      ///< largest content of a window behind, over the packet's
};

/// Relative change of the packet's mean energy from the first half of its way to the second. Throws
/// std::runtime_error if fewer than six samples lie beyond `fit_from`.
double energy_change(const Track& track, double to = far_away);

/**
The strongest thing behind the packet is found by sliding a window of the same width: `residue` is the
largest energy in a window that is separated from the packet's by at least its width, over that of the
packet around `peak`. */
double residue(const std::vector<double>& e, std::size_t peak);

/// Whether a packet is a travelling breather, in three conditions.
Criterion travelling_breather(const Endurance& packet);

/**
The article says that a packet is mainly supported by seven sites. How many there are depends on where one
stops counting, but for a compact packet there is a natural place: ahead of it nothing has moved yet, and
the amplitude falls super-exponentially, by a factor of five, then fifteen, then two hundred from site to
site. We therefore look at the *largest* amplitude that a site reaches at a given distance ahead of the
peak, relative to the peak. */
class Front {
 public:
  /// Takes the density `e` of a packet whose largest site is `peak`.
  void add(const std::vector<double>& e, std::size_t peak) {
    for (std::size_t k = 0; k < largest_.size() && peak + k < e.size(); ++k)
      largest_[k] = std::max(largest_[k], e[peak + k]);
    for (std::size_t k = packet_half_width + 1; k <= 3 * packet_half_width && k <= peak; ++k)
      behind_ = std::max(behind_, e[peak - k]);
  }
  /// Amplitude `distance` sites ahead of the peak, relative to the peak.
  double amplitude(std::size_t distance) const {
    return std::sqrt(largest_.at(distance) / largest_[0]);
  }
  /// Sites of the packet, if it is as wide behind its peak as ahead of it: those above a hundredth.
  std::size_t width() const {
    std::size_t k = 0;
    while (k + 1 < largest_.size() && amplitude(k + 1) > 0.01) ++k;
    return 2 * k + 1;
  }
  /// Largest amplitude on the ten sites behind the packet's window, relative to the peak.
  double tail() const { return std::sqrt(behind_ / largest_[0]); }

 private:
  std::vector<double> largest_ = std::vector<double>(2 * packet_half_width, 0.0);
  double behind_ = 0;
};

/// A packet of `sites` sites, an odd number: on its undisturbed side the outermost of them exceeds
/// one per cent of the peak and the next one does not. A hundredth is what a drawing still shows.
Criterion supported_by(std::size_t sites, const Front& coarse, const Front& fine);

/**
Two curves coincide at small arguments if they meet there: their distance is below one per cent at the
small end, and at least twice as large farther on. Curves that are merely similar keep a distance
everywhere. */
struct Meeting {
  Estimate near, far;  ///< largest relative distance up to a small and up to a larger argument
};

/// Whether two curves meet at small arguments.
Criterion meet(const Meeting& m);

/**
Energy is trapped where it was put in if the boundary keeps more of it than the packet takes away;
otherwise it is not. This needs no number of our own. */
Criterion trapped(const Estimate& boundary, const Estimate& packet);

/**
Figure 21 of the article shows a surface mode and a travelling breather that are "clearly visible". Two
such excitations at the ends of a profile are visible if each rises above everything between them.
`prominence` is the height of the lower one over that of the highest wave in between. */
double prominence(const std::vector<double>& v, std::size_t peak, std::size_t near = 5);

/**
In pendulum wells a strong impact sends out not a breather but a kink, after which the beads rest in
another well. A transition from one to the other has been found if there are impact velocities of both
kinds, all breathers lie below all that is certain to be a kink, and so few velocities stay undecided that
a third regime among them would be narrow: we allow a twentieth of the scan. */
struct Transition {
  std::size_t breathers, kinks;  ///< velocities below the last breather and from the first kink on
  double last_breather, first_kink;  ///< impact velocities
  double undecided;                  ///< share of the scan
};

/// Whether a scan of impact velocities shows the transition.
Criterion transition(const Transition& t);

/**
A blow-up is a displacement that becomes infinite in finite time. Where no energy is negative, as in pendulum wells,
that of the impact bounds the speed of every bead by $v_0$ and its way by $v_0t$: a bead that is thrown off an end
goes away, but no faster than that. A bead that leaves a soft quartic well gains speed without bound. */
struct Confinement {
  Estimate speed;     ///< largest of any bead, over the impact's
  Estimate way;       ///< largest displacement, over v_0 times the time of the run
  Estimate drift;     ///< of the energy, relative
  double lasted;      ///< share of its time after which the run ended
  Estimate furthest;  ///< largest displacement
};

/// An impact followed to its end with two steps.
Confinement confinement(const Impact& impact, const ContactAware& rough, const ContactAware& fine);

/// Whether the run came to its end, keeps its energy, and no bead is faster or farther than that allows.
Criterion no_blowup(const Confinement& c);

/**
Three more speak of packets in hard wells (turning.hpp). A packet is reversed if it has a turning point, if the
acceleration of its centre points backward on the way out and on the way back, and if the time of its rebound is known
within ten units. Another is only slowed down, moderately, if it does not turn and is decelerated less than half as much. */
/// From the time of the turning point, the accelerations on both ways and the time of the rebound.
Criterion reversed_packet(const Estimate& apex_time, const Estimate& out, const Estimate& back,
                          const Estimate& return_time);

/// From whether it `slows` down without turning, and the accelerations of it and of one that turns.
Criterion slowed_packet(bool slows, const Estimate& force, const Estimate& turning_force);

/**
An ensemble becomes erratic if its centres stay together within a quarter of a site on the way out and back,
and spread over more than three long after. */
/// From the spread of an ensemble until the return and late.
Criterion erratic_packets(const Estimate& early, const Estimate& late);

}  // namespace lattice
