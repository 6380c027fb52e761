#pragma once
/**
# The kick that sets a breather in motion

A breather that moves slowly feels a potential of its centre with the period of the chain. We draw it such that a
breather whose pinning pair is on the unit circle sits in a *minimum*, half a site away from a maximum. (Where the
effective mass is negative the energies are upside down.) A kick (kick.hpp) depins it above some $c_c$, which is
predicted from one period of the linearised flow and the barrier at equal action, and found in runs of the whole chain.
The chapter `sec33_mobility` derives both. */

#include <array>
#include <vector>

#include "lattice/events/event_driven.hpp"
#include "lattice/integrators/event_corrected.hpp"
#include "sec3/breather_pairs.hpp"
#include "sec3/kick.hpp"

namespace lattice {

/// A breather at the instant at which all beads are at rest, and how it is kicked.
struct RestingBreather {
  Centre centre = Centre::bond;
  Chain chain{};
  State<double> rest{};
  double period = 0, energy = 0;  ///< before the kick
  std::vector<double> g{};        ///< the direction of its kicks, of length one

  /// The path after a kick of size `c`, until `look` stops it or `time` is over.
  KickedPath after(double c, const Method& method, double time, const KickLook& look = {}) const {
    return follow_kicked(method, chain, kicked(rest, c, g), sample_of_mean(period), time, look);
  }
};

/// In wells of anharmonicity `s`, to be kicked along its discrete gradient. On `sites` sites (one more if a site-centred
/// one lacks its middle), which must hold its tail down to 1e-16. Throws ShortChain, NewtonFailed.
RestingBreather resting_breather(Centre centre, Phase phase, double omega_b, std::size_t sites,
                                 double s = 0);

/// The same breather, to be kicked along its pinning mode, or in the opposite direction.
RestingBreather along_pinning_mode(RestingBreather at);
RestingBreather reversed(RestingBreather at);

/// Event-corrected steps of this length by the method of order six with fourteen stages.
EventCorrected fourteen_stages(double step);

/**
## The slow plane

A shift $\xi$ of the positions and a push $\zeta$ of the velocities span the plane of slow motion along the chain, in
which the monodromy matrix turns by $\theta$ in a period. Symmetry separates it from a shift in time, whose multiplier is
exactly one (floquet.hpp). Around a bond a shift along the chain is even under $n \to 1-n$ and a shift in time is odd.
Around a site half a period followed by $y_n \to -y_{-n}$ leaves a shift in time alone and reverses one along the chain. */
struct Pinning {
  double frequency2 = 0;  ///< Omega^2; negative for an unstable breather
  double phi = 0;         ///< the fraction of c^2/2 that becomes kinetic energy of translation
  double along = 0;       ///< (xi g)^2, the fraction of c^2/2 along the mode
  std::vector<double> shift{};  ///< xi, of length one, with a positive part along g
};

/// Of a breather and its kick.
Pinning pinning_of(const RestingBreather& at, const EventTolerance<double>& rule = {});

/// What linear theory predicts. Errors come from two tolerances of the linearised flow and from the barrier. If the
/// pinning pair is real the slightest kick may move the breather, and there is neither a frequency nor a threshold.
struct Prediction {
  Estimate threshold{}, phi{}, along{}, frequency{}, barrier{};  ///< barrier: E_site - E_bond
  bool exists() const { return frequency.value > 0; }            ///< whether there is a threshold
};

/// From the barrier at equal action.
Prediction predict_threshold(const RestingBreather& at, const Estimate& barrier);

/// The mean speed over a site of a pendulum that has the speed `start` in a minimum or at a maximum of its potential and
/// swings in a minimum with `omega`: the arithmetic-geometric mean of the speeds there. Zero if it does not get over.
double pendulum_speed(double start, double omega, bool from_maximum);

/**
## From speeds to the threshold

Near the maximum half a site away $X \simeq (V/\Omega)\sinh\Omega t$ is nearly a cubic in $t$ whose least slope is the
speed $V$. */
/// This speed, from all means within 0.05 sites of the maximum; std::invalid_argument if fewer than eight lie there.
double hill_speed(const KickedPath& path);

/// The path until the breather is free or pinned; std::runtime_error if it is neither within `limit`. Ten times 1/Omega
/// are enough for all kicks but those within 1e-7 of the threshold.
KickedPath decided_path(const RestingBreather& at, double c, const Method& method, double limit);

/// Kicks by which a threshold is found, over the predicted one.
inline constexpr std::array<double, 3> kicks_beyond{1.05, 1.2, 1.4};

/// The speeds V at the maximum after these kicks, and the c at which V^2, linear in c^2, vanishes: the two weaker ones
/// give the value, the third one the error.
struct Depinning {
  std::array<double, 3> c{}, speed{};
  double drift = 0;  ///< largest change of the energy, relative to that of the breather
  Estimate threshold{};
};
/// Throws std::runtime_error if one of the kicks does not free the breather within `limit`.
Depinning depinning(const RestingBreather& at, double predicted, const Method& method,
                    double limit);

}  // namespace lattice
