#pragma once
/**
# The kick that frees a breather

A breather that moves slowly feels a potential of its centre with the period of the chain. We draw it such that a
breather whose pinning pair is on the unit circle sits in a *minimum*, half a site away from a maximum. (Where the
effective mass is negative the energies are upside down.) A kick (kick.hpp) frees it above some $c_c$, which is predicted
from one period of the linearised flow and the barrier at equal area, and found in runs of the whole chain. */

#include "lattice/algebra/dense.hpp"
#include "lattice/events/event_driven.hpp"
#include "lattice/integrators/event_corrected.hpp"
#include "lattice/model/sites.hpp"
#include "lattice/orbits/breather_pairs.hpp"
#include "sec33/kick.hpp"

namespace lattice {

/**
## The slow plane

Close to a breather that starts at rest, the map of one period has a slow plane, spanned by a shift $x$ of the positions
and a push $z$ of the velocities,
$$A x = \cos\theta\,x,\quad A^Tz = \cos\theta\,z,\quad z^TBz = b\,z^Tx,$$
where $A$ and $B$ are the derivatives of the final positions with respect to the initial positions and velocities. Over
many periods this is an oscillator (or, if $\cos\theta > 1$, its unstable twin) with $\Omega^2 = 2(1-\cos\theta)/T^2$. A
kick $c\,g$ gives it the kinetic energy
$$K = \varphi\,\frac{c^2}2,\qquad \varphi = \frac{b\,(x\cdot g)^2}{T\,(x\cdot z)}.$$ */
struct Pinning {
  double frequency2 = 0;        ///< Omega^2; negative for an unstable breather
  double share = 0;             ///< phi
  double cosine = 0;            ///< of the shift x and the direction g of the kick
  std::vector<double> shift{};  ///< x, of length one, in the direction of g
};

/// The eigenvector of the eigenvalue nearest to `value`, by inverse iteration from `guess`.
Vector<double> eigenvector_near(const Matrix<double>& m, double value, Vector<double> guess);

/**
Symmetry separates this plane from a shift in time, whose multiplier is exactly one (floquet.hpp). Around a bond a shift
along the chain is even under $n \to 1-n$ and a shift in time is odd. Around a site half a period followed by
$y_n \to -y_{-n}$ leaves a shift in time alone and reverses one along the chain. */
struct PeriodMap {
  Matrix<double> A, B, basis;  ///< the basis of the directions that are left, column by column
};

/// The map of one period around a bond, of half a period and the reflection around a site.
PeriodMap period_map(const Chain& chain, Centre centre, State<double> state, double period,
                     const EventTolerance<double>& rule);

/// Of the breather at rest in `start`. Around a site the map of half a period is squared, which doubles its angle.
Pinning pinning_of(const Chain& chain, Centre centre, const State<double>& start, double period,
                   const EventTolerance<double>& rule = {});

/// A breather in harmonic wells at the instant at which all beads are at rest.
struct RestingBreather {
  Centre centre = Centre::bond;
  Chain chain{};
  State<double> rest{};
  double period = 0, energy = 0;  ///< before the kick

  /// The path after a kick of size `c`, until `look` stops it or `time` is over.
  KickedPath after(double c, const Method& method, double time, const KickLook& look = {}) const {
    return follow_kicked(method, chain, kicked(rest, c), sample_of_mean(period), time, look);
  }
};

/// On `sites` sites (one more if a site-centred one lacks its middle), which must hold its tail down to 1e-16. Throws
/// ShortChain, NewtonFailed.
RestingBreather resting_breather(Centre centre, Phase phase, double omega_b, std::size_t sites);

/// Event-corrected steps of this length by the method of order six with fourteen stages.
EventCorrected fourteen_stages(double step);

/// Both breathers of this frequency in harmonic wells, with their barriers at equal frequency and at equal area.
BreatherPair barriers_at(double omega_b);

/// What linear theory predicts. Errors come from two tolerances of the linearised flow and from the barrier. If the pinning pair is real the
/// slightest kick may move the breather, and there is neither a frequency nor a threshold.
struct Prediction {
  Estimate threshold{}, share{}, frequency{}, barrier{};  ///< c_c, phi, Omega, and E_site - E_bond
  Estimate along_mode{};  ///< c_c of a kick along the shift x, of length one, instead of g
  bool exists() const { return frequency.value > 0; }  ///< whether there is a threshold
};

/// From the barrier at equal area.
Prediction predict_threshold(const RestingBreather& at, const Estimate& barrier);

/**
## From speeds to the threshold

Close to the threshold a breather stays near the maximum for long. What changes smoothly is the speed $V$ with which a
free one passes it: its kinetic energy there is the share of the kick less the barrier, so that
$V^2 \propto c^2 - c_c^2$. Near the maximum $X \simeq (V/\Omega)\sinh\Omega t$ is nearly a cubic in $t$ whose least
slope is $V$. */
/// The speed at `hill` sites from the start, from all means within 0.05 sites of it; std::invalid_argument if fewer than
/// eight lie there.
double hill_speed(const KickedPath& path, double hill = 0.5);

/// The kick at which $V^2$ vanishes, from two others; std::invalid_argument if the line has no zero.
double threshold_from(double c1, double v1, double c2, double v2);

/// The path up to its decision; std::runtime_error if there is none within `limit`. Ten times 1/Omega are enough for
/// all kicks but those within 1e-7 of the threshold.
KickedPath decided_path(const RestingBreather& at, double c, const Method& method, double limit);

/// The threshold from the speeds at the maximum after kicks 5, 20 and 40 per cent above the prediction. The two weaker
/// ones give the value, the third the error. Throws std::runtime_error if one of them does not free the breather.
Estimate freeing_kick_of(const RestingBreather& at, const Prediction& guess,
                         const EventCorrected& method);

}  // namespace lattice
