#pragma once
/**
# Free, pinned, and what linear theory expects

A breather that moves slowly feels a potential of its centre with the period of the chain. We draw it such that a
breather whose pinning pair is on the unit circle sits in a *minimum*, half a site away from a maximum. (Where the
effective mass is negative the energies are upside down.) A kick (kick.hpp) frees it if it carries it over the maximum.
*/

#include "lattice/algebra/dense.hpp"
#include "lattice/events/event_driven.hpp"
#include "lattice/model/sites.hpp"
#include "sec33/kick.hpp"

namespace lattice {

/// Free: 0.6 sites from the start, well beyond the maximum. Pinned: turned back by 0.02 sites before that.
enum class Mobility { undecided, free, pinned };
Mobility mobility_of(const KickedPath& path);

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
  double frequency2 = 0;  ///< Omega^2; negative for an unstable breather
  double share = 0;       ///< phi
  double cosine = 0;      ///< of the shift x and the direction g of the kick
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

/// Of one period around a bond, of half a period and the reflection around a site.
PeriodMap period_map(const Chain& chain, Centre centre, State<double> state, double period,
                     const EventTolerance<double>& rule);

/// Of the breather at rest in `start`. Around a site the map of half a period is squared, which doubles its angle.
Pinning pinning_of(const Chain& chain, Centre centre, const State<double>& start, double period,
                   const EventTolerance<double>& rule = {});

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

}  // namespace lattice
