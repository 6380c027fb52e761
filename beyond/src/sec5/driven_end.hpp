#pragma once
/**
# A driven end

A chain of equal wells has a band of a single frequency, and a drive of another frequency should shake the
first beads only. But contacts harden: breathers have frequencies above the band, and a drive of frequency
$\Omega = 1+\delta$ can feed one. Geniet and Leon (Phys. Rev. Lett. 89, 134102, 2002) found in chains with
band gaps that energy passes above a sharp amplitude, which they called nonlinear supratransmission; Leon (Phys. Lett.
A 319, 130, 2003) explained the threshold by the largest amplitude at the end of a static solution that decays into the
chain. There two static solutions meet in a fold, as Susanto (arXiv:0809.3861, 2008) proves for a discrete Schrödinger
equation. Maniadis, Kopidakis and Aubry (Physica D 216, 121, 2006) study such a threshold in systems with discrete
breathers, Yousefzadeh and Phani (arXiv:1510.00058, 2015) in damped, finite and disordered structures.

## The threshold of the DpS limit

With $y_n = 2\epsilon u_n\cos\Omega t$ and $\epsilon = (2\tau_0\delta)^2$ a motion locked to the drive obeys
Eq. (14) with $\mu = 1$, $-u_n = D_n - D_{n-1}$ for $n\ge1$. Read from right to left this is a map:
$$D_{n-1} = D_n + u_n,\qquad u_{n-1} = u_n - D_{n-1}|D_{n-1}|^{-1/3}.$$
With it James (Math. Models Methods Appl. Sci. 21, 2011, arXiv:1008.1153) found the static breathers, and James and
Starosvetsky (Localized Excitations in Nonlinear Complex Systems, Springer 2014) proved that they exist. It starts
in the tail, where $u_{n-1} = -u_n|u_n|^{-1/3}$, so that the solutions that decay are a curve with one parameter.
A piston stands in for bead 0, whose displacement it prescribes; a base pulls the first bead with the force that the
contact 0 would have. Beyond the first maximum of $|u_0|$ or $|D_0|$ along the curve the solution that grows from rest
with the drive has ended. These two numbers fix the law of the threshold (sec5_driving.cpp). */

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "lattice/numerics/estimate.hpp"
#include "lattice/orbits/newton.hpp"
#include "sec5/driven_chain.hpp"

namespace lattice {

/// The first maximum of |u_0| for a piston, of |D_0| for a base, along the curve of decaying solutions, from tails of two
/// depths.
Estimate dps_threshold(Drive::By by);

/// The amplitude of the threshold at the frequency omega > 1 by the law of small delta, with the error of its constant.
Estimate law_estimate(Drive::By by, double omega);

/// The same without its error.
double threshold_law(Drive::By by, double omega);

/**
## The quiet orbit of the chain, and its fold

With losses the motion below the threshold is a periodic orbit of the driven chain, whose period is that of the
drive. For Newton's method the unknowns are the state at the beginning of a
period and the amplitude of the drive, the equations say that the state returns, and that the point lies on a
plane across the curve of solutions. The flow is that of driven_chain.hpp with a given number of steps; its derivative
comes from differences, which cost little for a dozen beads. */
struct DrivenOrbit {
  DrivenChain driven;
  std::size_t steps = 64;          ///< per period of the drive
  Vector<double> from{}, along{};  ///< a point of the curve and its direction, in units of `scale`
  double length = 0;               ///< how far along the direction the plane lies
  double scale = 1;                ///< in which unknowns and equations are measured

  /// For Newton's method.
  Equations<double> equations() const;
  Evaluation<double> evaluate(const Vector<double>& x, bool with_jacobian) const;
  /// By how much the state after one period differs from `x` without its last entry, the amplitude.
  Vector<double> return_error(const Vector<double>& x) const;
};

/// The curve of quiet orbits from a weak drive to beyond its fold, and the fold.
struct QuietOrbits {
  std::vector<double> amplitude{};  ///< of the drive
  std::vector<double> response{};   ///< amplitude of the first bead when a period begins
  double fold = 0;                  ///< largest amplitude
};

/// Follows the quiet orbit, with `steps` steps a period, from point to point at the distance `apart` in units of the
/// law for a piston, until its amplitude has fallen to the share `beyond` of the fold. The drive of `driven` says what is
/// driven and how fast; its amplitude is not used. Throws NewtonFailed.
QuietOrbits quiet_orbits(const DrivenChain& driven, std::size_t steps, double apart = 0.1,
                         double beyond = 0.8);

/**
## What comes out

Behind a detector bead we count packets. Its energy density, as its maximum in each period of the drive,
must rise fourfold from its last minimum and above 0.03 $a^2$ to count, for a base 0.03 $(a/\delta)^2$, and fall to
half before the next one can. Intervals between packets that differ by less than a tenth make a train. */
struct Emission {
  std::vector<double> passages{};  ///< times at which packets are counted
  double power = 0;                ///< mean power of the drive in the second half of the run
  double response = 0;             ///< largest displacement of the first bead in the second half
  double far = 0;                  ///< and of the last one in the whole run
  double loudest = 0;  ///< largest energy density at the detector, in units of a^2 or (a / delta)^2
  double budget = 0;   ///< the largest imbalance, see driven_chain.hpp

  /// Packets per unit of time in the second half of a run of this length.
  double rate(double duration) const;
  /// Relative standard deviation of the intervals in the second half; -1 if there are fewer than three.
  double spread(double duration) const;
  /// Whether packets still pass at the end of a run of this length, being silent for less than `silence`.
  bool lasts(double duration, double silence) const;
};

/// Runs the chain from rest for `duration`, or until as many packets have passed the detector as are `enough`. With a
/// `silence` the run ends once it is known whether emission lasts: none has passed for that time, or one in the last.
Emission drive_chain(const DrivenChain& driven, double duration, std::size_t detector, double step,
                     std::size_t enough = std::numeric_limits<std::size_t>::max(),
                     double silence = std::numeric_limits<double>::infinity());

/// Density maps: energy of each bead, the maximum in each of `bins` equal times; entry bin * sites + n.
std::vector<double> drive_map(const DrivenChain& driven, double duration, std::size_t bins,
                              double step);

/**
A threshold is found by halving an interval of amplitudes, of which the lower end is quiet and the upper one
emits, until it is shorter than the share `accuracy`. Its error is that interval. Throws std::runtime_error if
both ends do the same. */
Estimate bisect_threshold(double quiet, double emits, double accuracy,
                          const std::function<bool(double)>& does_emit);

/**
Where emission dies out after an erratic time a stronger drive may be quiet and a weaker one emit. Then the
threshold is not an interval that can be halved, but what lies between the lowest amplitude that emits and the
highest that is quiet. */
/// The middle of these two among the 2 * `side` + 1 amplitudes around `centre` at the distance `apart`, and half the
/// way between them. Throws std::runtime_error unless the lowest is quiet and the highest emits.
Estimate threshold_among(double centre, double apart, int side,
                         const std::function<bool(double)>& does_emit);

}  // namespace lattice
