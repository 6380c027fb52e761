#pragma once
/**
# A driven array

What a drive at its first bead sends into an array of beams, and the threshold that the limit of small amplitude gives
it. The command `drive` and the live page ask for all of this, the chapter for a part. */

#include <functional>
#include <string>
#include <vector>

#include "lattice/cantilever/cantilever.hpp"
#include "lattice/numerics/estimate.hpp"
#include "sec5/driven_chain.hpp"

namespace lattice {

/**
## The asymptotic threshold

In the DpS limit the motion of the period of the drive that decays into the chain is a static solution of Eq. (14),
$-U_n = D_n - D_{n-1}$ for $n\ge1$. Read from right to left this is a map:
$$D_{n-1} = D_n + U_n,\qquad U_{n-1} = U_n - D_{n-1}|D_{n-1}|^{-1/3}.$$
With it James (Math. Models Methods Appl. Sci. 21, 2011, arXiv:1008.1153) found the static breathers, and James and
Starosvetsky (Localized Excitations in Nonlinear Complex Systems, Springer 2014) proved that they exist. It starts in
the tail, where $U_{n-1} = -U_n|U_n|^{-1/3}$, so that the solutions that decay are a curve with one parameter. */
/// The first maximum of |U_0| for a piston, of |D_0| for a base, along this curve, from tails of two depths.
Estimate dps_threshold(Drive::By by);
/// The amplitude at which the solution that grows from rest ends, at the frequency omega > 1, as delta -> 0.
Estimate threshold_law(Drive::By by, double omega);
/// The same with the error of an asymptotic law, by how much the fold lies above it where we have computed both: by the
/// fraction 1.3 delta for a piston up to delta = 0.35, 3.5 delta for a base up to 0.2, and by (nu / delta)^2 with losses.
Estimate asymptotic_threshold(Drive::By by, double omega, double nu);

/**
## Packets at a detector

The energy density of a bead, as its maximum in each period of the drive, must rise fourfold from its last minimum and
above 0.03 of `drive_size` squared to count as a packet, and fall to half before the next one can. */
/// The displacement that a drive gives to the first bead, but for a factor: u_0 for a piston, u_0 / delta for a base.
double drive_size(const Drive& drive);

/// Sees the energy density of a bead at one time after the other.
class PacketCounter {
 public:
  explicit PacketCounter(const Drive& drive);
  /// Whether a packet is counted at the time `t`.
  bool passes(double t, double energy);

 private:
  double period_, floor_, highest_ = 0, next_ = 0, least_ = 0, most_ = 0;
  bool inside_ = false;
};

/// Times at which such a run is looked at. One is the middle; the maximum in a period needs some that lie close.
TimeGrid two_halves(double duration, double step);

/// What comes out of a run.
struct Emission {
  std::vector<double> passages{};  ///< times at which packets pass the detector
  double power = 0;                ///< mean power of the drive in the second half of the run
  double response = 0;             ///< largest displacement of the first bead in the second half
  double far = 0;                  ///< and of the last one in the whole run
  double budget = 0;               ///< the largest imbalance, see driven_chain.hpp

  /// Packets per unit of time in the second half of a run of this length.
  double rate(double duration) const;
};

/// Whether a run need not go on at the time t.
using Enough = std::function<bool(const Emission& so_far, double t)>;

/// Runs the chain from rest for `duration` or until it is `enough`, with steps of length `step`; beads count from one.
Emission drive_chain(const DrivenChain& driven, double duration, std::size_t detector, double step,
                     const Enough& enough = {});

/**
## One drive of the array of section 3.6 */
/// A quantity of such a drive.
struct DrivenQuantity {
  std::string name;
  Estimate value;
  std::string unit, meaning;
};

/// The drive grows during the first sixth of its `duration`.
struct DrivenArray : Scales {
  DrivenArray() : Scales(CantileverArray{}.scales()) {}

  /// Beads, the one behind which a packet counts, and those that a map shows.
  static constexpr std::size_t sites = 300, detector = 20, drawn = 60;
  static constexpr double step = 0.02;  ///< of the finer run, in units of tau_c

  double frequency = 7000, amplitude = 5, duration = 60;  ///< Hz, micrometres, ms
  double lifetime = 10;                                   ///< of the energy, in ms; 0: no losses
  Drive::By by = Drive::By::piston;
  std::size_t beads = sites;  ///< to begin with; `quantities` lengthens an array whose end moves

  /// The duration in units of tau_c.
  double horizon() const { return time(duration); }
  /// The same array in units of the chain.
  DrivenChain driven() const;
  /// One run with steps of length `h`.
  Emission run(double h) const;
  /// Three runs and what they say; the asymptotic threshold exists above the frequency of a beam.
  std::vector<DrivenQuantity> quantities() const;
};

/**
## Thresholds */
/// Halves an interval of amplitudes, of which the lower end is quiet and the upper one emits, until it is shorter than
/// the share `accuracy`; the error is that interval's half. Throws std::runtime_error if both ends do the same.
Estimate bisect_threshold(double quiet, double emits, double accuracy,
                          const std::function<bool(double)>& does_emit);

/// Where a stronger drive may be quiet and a weaker one emit: the middle of the lowest amplitude that emits and the
/// highest that is quiet, among 2 * `side` + 1 about `centre` at the distance `apart`, and half the way between them.
/// Throws std::runtime_error unless the lowest is quiet and the highest emits.
Estimate threshold_among(double centre, double apart, int side,
                         const std::function<bool(double)>& does_emit);

}  // namespace lattice
