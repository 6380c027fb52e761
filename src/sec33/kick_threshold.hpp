#pragma once
/**
# The kick that sets a breather in motion

A breather that moves slowly feels a potential of its centre with the period of the chain. We draw it such that a
breather whose pinning pair is on the unit circle sits in a *minimum*, half a site away from a maximum. (Where the
effective mass is negative the energies are upside down.) A kick (kick.hpp) depins it above some $c_c$, which is
predicted from one period of the linearised flow and the barrier at equal action, and found in runs of the whole chain.
The chapter `sec33_mobility` explains both. */

#include <array>
#include <vector>

#include "lattice/algebra/dense.hpp"
#include "lattice/events/event_driven.hpp"
#include "lattice/integrators/event_corrected.hpp"
#include "lattice/model/sites.hpp"
#include "lattice/orbits/breather_pairs.hpp"
#include "sec33/kick.hpp"

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

/// Both breathers of this frequency, with their barriers at equal frequency and at equal action.
BreatherPair barriers_at(double omega_b, double s = 0);

/**
## The slow plane

Close to a breather that starts at rest the monodromy matrix $M$ has a slow plane, spanned by a shift $\xi$ of the
positions (the pinning mode) and a push $\zeta$ of the velocities,
$$M_{yy}\,\xi = \cos\theta\,\xi,\quad M_{yy}^T\zeta = \cos\theta\,\zeta,\quad
  \zeta\cdot M_{yv}\zeta = b\,\zeta\cdot\xi,$$
where $M_{yy}$ and $M_{yv}$ are the derivatives of the final positions with respect to the initial positions and
velocities. Over many periods this is an oscillator (or, if $\cos\theta > 1$, its unstable twin) with $\Omega^2 =
2(1-\cos\theta)/T_b^2$. A kick $c\,g$ gives it the kinetic energy
$$\varphi\,\frac{c^2}2,\qquad \varphi = \frac{b\,(\xi\cdot g)^2}{T_b\,\xi\cdot\zeta}.$$ */
struct Pinning {
  double frequency2 = 0;        ///< Omega^2; negative for an unstable breather
  double share = 0;             ///< the fraction phi
  std::vector<double> shift{};  ///< xi, of length one, with a positive part along g
};

/// The eigenvector of the eigenvalue nearest to `value`, by inverse iteration from `guess`.
Vector<double> eigenvector_near(const Matrix<double>& m, double value, Vector<double> guess);

/**
Symmetry separates this plane from a shift in time, whose multiplier is exactly one (floquet.hpp). Around a bond a shift
along the chain is even under $n \to 1-n$ and a shift in time is odd. Around a site half a period followed by
$y_n \to -y_{-n}$ leaves a shift in time alone and reverses one along the chain. */
struct PeriodMap {
  Matrix<double> yy, yv, basis;  ///< the basis of the directions that are left, column by column
};

/// The map of one period around a bond, of half a period and the reflection around a site.
PeriodMap period_map(const RestingBreather& at, const EventTolerance<double>& rule);

/// Of a breather and its kick. Around a site the map of half a period is squared, which doubles its angle.
Pinning pinning_of(const RestingBreather& at, const EventTolerance<double>& rule = {});

/// What linear theory predicts. Errors come from two tolerances of the linearised flow and from the barrier. If the
/// pinning pair is real the slightest kick may move the breather, and there is neither a frequency nor a threshold.
struct Prediction {
  Estimate threshold{}, share{}, frequency{}, barrier{};  ///< c_c, phi, Omega, and E_site - E_bond
  bool exists() const { return frequency.value > 0; }     ///< whether there is a threshold
};

/// From the barrier at equal action.
Prediction predict_threshold(const RestingBreather& at, const Estimate& barrier);

/// The mean speed over a site of a pendulum that has the speed `start` in a minimum or at a maximum of its potential and
/// swings in a minimum with `omega`: the arithmetic-geometric mean of the speeds there. Zero if it does not get over.
double pendulum_speed(double start, double omega, bool from_maximum);

/**
## From speeds to the threshold

Close to the threshold a breather stays near the maximum for long. What changes smoothly is the speed $V$ with which a
free one passes it: its kinetic energy there is $\varphi\,c^2/2$ less the barrier, so that
$V^2 \propto c^2 - c_c^2$. Near the maximum $X \simeq (V/\Omega)\sinh\Omega t$ is nearly a cubic in $t$ whose least
slope is $V$. */
/// The speed at `hill` sites from the start, from all means within 0.05 sites of it; std::invalid_argument if fewer than
/// eight lie there.
double hill_speed(const KickedPath& path, double hill = 0.5);

/// The kick at which $V^2$ vanishes, from two others; std::invalid_argument if the line has no zero.
double threshold_from(double c1, double v1, double c2, double v2);

/// The path until the breather is free or pinned; std::runtime_error if it is neither within `limit`. Ten times 1/Omega
/// are enough for all kicks but those within 1e-7 of the threshold.
KickedPath decided_path(const RestingBreather& at, double c, const Method& method, double limit);

/// Kicks by which a threshold is found, over the predicted one.
inline constexpr std::array<double, 3> kicks_beyond{1.05, 1.2, 1.4};

/// The speeds V at the maximum after these kicks, and the c at which V^2 vanishes: the two weaker ones give the value,
/// the third one the error.
struct Depinning {
  std::array<double, 3> c{}, speed{};
  double drift =
      0;  ///< largest change of the energy in these runs, relative to that of the breather
  Estimate threshold{};
};
/// Throws std::runtime_error if one of the kicks does not free the breather within `limit`.
Depinning depinning(const RestingBreather& at, double predicted, const Method& method,
                    double limit);

}  // namespace lattice
