#pragma once
/**
# A DpS breather that noise sets in motion

The chapter on the stability of the DpS breathers perturbs them (stationary.hpp), follows them in time, and reads their
displacement $X$: the centre of $|v_n|^4$, in sites from the place of rest. Here is what it expects of such a run, and
how many runs are counted.

For a small shift $x$ and push $y$ along the translational mode $V$ (spectrum.hpp) the displacement is $X = gx$, where
$g$ is the derivative of the centre along $V$, and $\ddot X = \pm\lambda^2X$ with the plus at a site and the minus at a
bond. The simplest potential with both is a sine, in which the centre moves like a pendulum; about a site
$$\ddot X = \frac{\lambda^2}{2\pi}\sin 2\pi X,$$
and a push $y$ gives it the initial speed $g(\mu-m)y$. So the push that depins a breather from a bond is
$y_c = |\lambda|/(\pi g(\mu-m))$. From a site a perturbation whose growing part is $c$ starts with the speed
$v = 2g\lambda c$, and reaches the next bond after
$$t = \int_0^{1/2}\frac{dX}{\sqrt{v^2+(\lambda/\pi)^2\sin^2\pi X}},$$
a complete elliptic integral. Nothing in these predictions is fitted. */

#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

#include "lattice/numerics/estimate.hpp"
#include "lattice/standing/spectrum.hpp"

namespace lattice {

/// A breather with its translational mode, of the sign for which a shift x > 0 goes to larger n.
struct PinnedBreather {
  Centre centre;
  double mu;         ///< its frequency
  Field u;           ///< its profile, real
  PinningPair pair;  ///< with that sign
  double shift;      ///< g: how far the centre moves, in sites, for a unit of x

  explicit PinnedBreather(const Stationary<double>& state);

  /// The push at which a pendulum passes the site beside its bond.
  double freeing_push() const;
  /// When a pendulum that starts from a site with this growing part is half a site away.
  double departure(double growing) const;
};

/// Tolerance of the integrator, and samples per unit of time.
struct Accuracy {
  double tolerance, samples;
};

/// What a run is seen to do, sample by sample.
struct DpsRun {
  std::vector<double> t{}, X{};        ///< time and displacement
  std::vector<double> sites{};         ///< on how many sites the breather lives
  double drift = 0, energy_drift = 0;  ///< of norm or energy, whichever is larger; of the energy

  /// The largest |X|.
  double largest() const;
  /// When |X| exceeds `distance` for the first time, interpolated; nan if it never does.
  double reaches(double distance) const;
  /// The run up to a time.
  DpsRun until(double time) const;
  /// By which factor the number of its sites grew.
  double spread() const;
};

/**
A trial is one seed of the noise. To first order noise moves a breather only through its component along the
translational mode, so that this is recorded beside the runs. */
struct NoiseTrial {
  std::size_t seed;
  std::complex<double> kick{};  ///< shift and push of the noise
  double growing = 0;           ///< size of its growing part
  DpsRun coarse{}, fine{};      ///< at two tolerances
};
using NoiseTrials = std::vector<NoiseTrial>;

/**
A breather has *left* its place when $|X| > \frac12$, and *moved* when $|X| > 1$. A count is exact only if both
tolerances give the same. A departure that has not happened is infinitely late, so that the median does not depend on
the end of the run. */
/// How many pass a distance by the time `by`.
Estimate passing(const NoiseTrials& trials, double distance, double by = HUGE_VAL);

/// The median departure.
Estimate median_departure(const NoiseTrials& trials, double by);

/// Trials that move at one tolerance and not at the other.
std::size_t torn(const NoiseTrials& trials);

/// By which factor the breathers of these trials spread at most.
Estimate largest_spread(const NoiseTrials& trials);

/**
Is it the translational mode that moves a breather? Then the same noise without that mode, a *control*, acts later.
What has not moved by the end of its run moves no earlier. */
struct Delay {
  Estimate later{};  ///< fraction of the seeds of which the control moves later
  Estimate ratio{};  ///< of the median times
};
Delay delay_of(const NoiseTrials& controls, const NoiseTrials& trials);

}  // namespace lattice
