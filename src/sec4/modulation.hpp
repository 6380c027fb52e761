#pragma once
/**
# A modulated phonon on a ring

In a compressed chain linear waves, phonons (dispersion.hpp), can travel. An unstable phonon does not stay
uniform: a slight modulation of it grows until the energy has gathered in a packet. Eq. (39) shows this
on a ring of $N$ beads that starts from a phonon of amplitude $a$ running to the right, modulated along
the ring by the fraction $b$,
$$x_n(0) = a\sin qn\,(1 + b\cos(2\pi n/N)), \qquad
  \dot x_n(0) = -a\,\omega\cos qn\,(1 + b\cos(2\pi n/N)).$$
On the ring of figure 26 no contact opens until $t = 25000$: the motion is smooth, and a symplectic
splitting of order six with fourteen stages (schemes.hpp) keeps its full order. In hard wells a breather
may open contacts, at the most unstable wavenumber from about $t = 4600$ on; then the step has the order
of the appendix, and two steps tell the error. */

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "lattice/numerics/estimate.hpp"
#include "sec4/compressed_impact.hpp"
#include "sec4/dispersion.hpp"

namespace lattice {

/// The start of Eq. (39), with the values of the article.
struct ModulatedPhonon {
  double s = -1.0 / 6, d = 0.5, q = std::numbers::pi / 4, a = 0.15, b = 0.01;
  std::size_t sites = 200;

  /// The ring.
  Chain ring() const { return {sites, Quartic{s}, CompressedHertz{d}, Ends::periodic}; }
  /// How long a packet with the phonon's group velocity needs to go round the ring.
  double round() const { return double(sites) / phonon(q, contact_series(d).v1).group_velocity; }
  /// Its state at t = 0, Eq. (39).
  State<double> start() const {
    const double pi = std::numbers::pi, omega = phonon(q, contact_series(d).v1).omega;
    State<double> state(sites);
    for (std::size_t i = 0; i < sites; ++i) {
      const double n = double(i + 1), factor = 1 + b * std::cos(2 * pi * n / double(sites));
      state.y[i] = a * std::sin(q * n) * factor;
      state.v[i] = -a * omega * std::cos(q * n) * factor;
    }
    return state;
  }
};

/**
One long run answers two questions: what becomes of the wave in the end, and whether that moves. For the
second we follow the packet's centre during the last 60 units of time, about ten oscillations. */
struct Modulated {
  State<double> end;
  std::vector<double> density{};      ///< of the energy at the end
  std::vector<double> t{}, centre{};  ///< during the last 60 units of time
  double drift = 0;                   ///< of the energy, relative
  Snapshot shown{};                   ///< of the end
};

/// The run of length `time`, with steps of at most `step`.
Modulated modulate(const ModulatedPhonon& phonon, double time, double step);

/**
Is such a state a fact about the equations or about the integrator? An instability magnifies differences.
So two runs go on side by side, with steps that differ by a factor of two. Every 50 units of time we look at
both, and stop when their relative distance has reached a tenth: later statements about the state would be
merely statistical. The time at which they part is known to within one interval; if they have not parted by
`longest`, that is how long they were watched, an exact number.

A packet shows in a few numbers. How many times the mean is the largest energy density, and how many sites
share the energy? The energy has *gathered* when the first is more than five and the second less than half of
the ring. How wide is the packet itself? And is there one packet or are there two: how much energy has the
richest window of 21 sites, and how much the richest one beside it? */
struct RingSample {
  double t, peak_over_mean, participation;
  double second;  ///< energy of the second window over that of the first
  bool gathered;
  double width = 0;  ///< of the packet at half height
};

/**
The number of sites that share the energy of the *ring* does not measure the packet: it counts the background too, and
a narrow packet on a background has a larger one than a wide packet without. So we take the width of the highest hump
at half its height, of the energy density averaged over five neighbours, because within half a wavelength the carrier
makes it oscillate. */
/// That width, in sites; all of them if the density does not fall to half of its height.
double packet_width(const std::vector<double>& density);

/// What is seen of a ring at one instant.
RingSample ring_sample(const Chain& ring, const State<double>& state);

/// Two runs side by side, the finer one second.
struct RingPair {
  std::vector<std::array<RingSample, 2>> samples{};
  Estimate agree{};                   ///< how long the runs agree
  double gathered = std::nan("");     ///< when the energy has gathered in both,
  std::array<Modulated, 2> packet{};  ///< and what they look like a little later

  /// The least number of sites that share the energy.
  Estimate narrowest() const;
  /// The least width of the packet, up to half as long again as it took the energy to gather.
  Estimate width() const;
  /// The largest density over the mean.
  Estimate highest() const;
};

/// Goes on until the runs part, until `longest`, or until `patience` times the time that it takes the energy
/// to gather.
RingPair run_ring_pair(const ModulatedPhonon& phonon, double longest,
                       const std::array<double, 2>& steps,
                       double patience = std::numeric_limits<double>::infinity());

/// The wavenumbers of the ring at which Phi, Eq. (37), is positive, one in `every`, from the largest Phi on.
std::vector<double> unstable_band(const ModulatedPhonon& phonon, std::size_t every);

/**
When does a pulse split? The second window holds half of the first or more, in both runs, after the pulse has gone
round the ring once as one, with the group velocity $c$ of its phonon. This alone could be a pulse that spreads; so
later the energy is to be gathered and shared in the same way. */
struct PulseSplits {
  Estimate one_pulse_for;        ///< the longest time for which it was one pulse before
  Estimate splits_at, apart_at;  ///< nan if it does not
};

/// From a pair of runs, with the time that a pulse needs to go round the ring.
PulseSplits pulse_splits(const RingPair& pair, double round);

/**
What has become of the wave is seen from a few numbers of two runs: the largest energy density over the mean, the
share of the sites that share the energy (188 of 200 at the start of the article's run), the speed of the centre, with
the error of its fit, and the width of the packet at half height. */
struct Formed {
  Estimate peak_over_mean, share_of_sites, speed, width;
};
Formed formed(const Modulated& coarse, const Modulated& fine);

}  // namespace lattice
