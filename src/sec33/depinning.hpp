#pragma once
/**
# When a kick frees a breather

A breather that drifts slowly along the chain feels a Peierls-Nabarro potential with the period of the chain. We draw it
such that a breather whose pinning pair is on the unit circle sits in a *trough*: if that is so around a bond only, there
are troughs at the bonds and *hills* at the sites, if around a site, the reverse. (Where the effective mass is
negative the energies are upside down.) A kick (kick.hpp) depins it from a trough if it carries it over the hill. This
file tells a free breather from a pinned one, says what linear theory expects, and finds the least kick that frees. */

#include "lattice/algebra/dense.hpp"
#include "lattice/events/event_driven.hpp"
#include "lattice/model/sites.hpp"
#include "sec33/kick.hpp"

namespace lattice {

/**
## Free or pinned

A breather that starts in a trough has a hill on either side, half a site away. It is free as soon as it is
well beyond the hill, at 0.6 sites, and pinned if it has turned round before that, by 0.02 sites. */
enum class Mobility { undecided, free, pinned };

/// What a path, as far as it is known, says about its breather.
Mobility mobility_of(const KickedPath& path);

/**
## What linear theory expects

Close to a breather that starts at rest, the map of one period has a slow plane, spanned by a shift $x$ of
the positions and a push $z$ of the velocities with
$$A x = \cos\theta\,x,\quad
 A^Tz = \cos\theta\,z,\quad z^TBz = b\,z^Tx,$$
where $A$ and $B$ are the derivatives of the final positions with respect to the initial positions and
velocities. Over many periods this is an oscillator (or, if $\cos\theta > 1$, its unstable twin) of squared
frequency $\Omega^2 = 2(1-\cos\theta)/T^2$. Its *kinetic* energy after a kick $c\,g$ is
$$K = \varphi\,\frac{c^2}2,\qquad \varphi = \frac{b\,(x\cdot g)^2}{T\,(x\cdot z)}.$$
Only the small fraction $\varphi$ of the kick moves the breather along; the rest goes into its internal
oscillation and changes the action. */
struct Pinning {
  double frequency2 = 0;  ///< Omega^2; negative for an unstable breather
  double share = 0;       ///< phi
  double cosine = 0;      ///< of the shift x and the direction g of the kick
};

/// The eigenvector whose eigenvalue is nearest to `value`, by inverse iteration from `guess`. The shift
/// of 1e-5 keeps the matrix from being singular.
Vector<double> eigenvector_near(const Matrix<double>& m, double value, Vector<double> guess);

/**
The multipliers of this plane, nearly one, cannot be told from that of a shift in time, which is exactly
one (floquet.hpp), but symmetry separates the two. Around a bond a shift along the chain is even under
$n \to 1-n$ and a shift in time is odd. Around a site half a period followed by $y_n \to -y_{-n}$ leaves
a shift in time alone and reverses one along the chain. `basis` holds the directions that are left. */
struct PeriodMap {
  Matrix<double> A, B, basis;  ///< the basis column by column
};

/// A, B and the basis: of one period around a bond, of half a period and the reflection around a site.
PeriodMap period_map(const Chain& chain, Centre centre, State<double> state, double period,
                     const EventTolerance<double>& rule);

/**
`pinning_of` returns frequency and share for the breather at rest in `start`. Around a site the map of
half a period is squared, which doubles its angle. */
Pinning pinning_of(const Chain& chain, Centre centre, const State<double>& start, double period,
                   const EventTolerance<double>& rule = {});

/**
Now the threshold. In the slow motion the action is constant, so the height of the hill is the barrier at
equal area (breather.hpp), and the breather is freed by a kick whose share equals it. The effective mass
may be negative, as it is here: then the trough is the *higher* of the two energies, and the barrier and
the share change sign together. */
double freeing_kick(double barrier, const Pinning& pinning);

/**
## From speeds to the threshold

Close to the threshold a breather stays near the top of the hill for long, and to bisect between free and
pinned would cost a long run for every digit. What changes smoothly is the speed $V$ with which a free
breather passes the top. Its kinetic energy there is the share of the kick less the barrier, so that
$V^2 \propto c^2 - c_c^2$, and two free breathers give $c_c$.

Near the top the path is $X \simeq (V/\Omega)\sinh\Omega t$ with $\Omega$ the rate of the hill. There it is
nearly a cubic whose least slope is $V$, and we fit one to all means within `half_width` of the top. */
/// The speed on the hill at `hill` sites from the start. Throws std::invalid_argument if fewer than
/// eight means lie within `half_width` of it.
double hill_speed(const KickedPath& path, double hill = 0.5, double half_width = 0.05);

/**
The straight line through the two values of $V^2$ against $c^2$ is followed to zero. */
/// The kick at which $V^2$ vanishes, from two kicks that free and their speeds on the hill. Throws
/// std::invalid_argument if the line has no zero at positive c.
double threshold_from(double c1, double v1, double c2, double v2);

/**
## A pendulum

How does the speed of a freed breather depend on its kick? If the potential is a sine, the centre moves
like a pendulum, and its mean speed over a whole site is the arithmetic-geometric mean of the speeds on
the hill and in the trough: $V$ and $(V^2+\Omega^2/\pi^2)^{1/2}$ for a start on a hill, $V$ and
$(V^2-\Omega^2/\pi^2)^{1/2}$ from a trough. */
double arithmetic_geometric(double a, double b);

/// Mean speed over a site of a pendulum that swings with `omega` in its trough and starts with speed
/// `start` there or, with `on_hill`, at the top; zero if it does not get over.
double pendulum_speed(double start, double omega, bool on_hill);

}  // namespace lattice
