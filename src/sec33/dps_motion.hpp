#pragma once
/**
# A DpS breather that noise sets in motion

`sec33_dps_stability` follows perturbed DpS breathers and records their displacement $X$: the centre of $|v_n|^4$, in
sites from the place of rest. Here is what a pendulum would do, and how many runs are counted.

For a small shift $a$ and push $b$ along the translational mode $V$ (spectrum.hpp) the displacement is $X = ga$, where
$g$ is the derivative of the centre along $V$. In the potential of a sine, about a site,
$$\ddot X = \frac{\sigma^2}{2\pi}\sin 2\pi X,$$
and a push $b$ gives it the initial speed $g(\mu-m)b$. So the push that depins a breather from a bond is
$b_p = |\sigma|/(\pi g(\mu-m))$. */

#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

#include "lattice/numerics/estimate.hpp"
#include "lattice/standing/spectrum.hpp"

namespace lattice {

/// A breather with its translational mode, of the sign for which a shift a > 0 goes to larger n.
struct PinnedBreather {
  Centre centre;
  double mu;                ///< its frequency
  Field u;                  ///< its profile, real
  PinningPair pair;         ///< with that sign
  double centre_per_shift;  ///< g: how far the centre moves, in sites, for a unit of a

  explicit PinnedBreather(const Stationary<double>& state);

  /// b_p, the push at which a pendulum passes the site beside its bond.
  double pendulum_push() const;
};

/// Tolerance of the integrator, and samples per unit of time.
struct Accuracy {
  double tolerance, samples;
};

/// What a run is seen to do, sample by sample.
struct DpsRun {
  std::vector<double> t{}, X{};         ///< time and displacement
  std::vector<double> participation{};  ///< on how many sites the breather lives
  double drift = 0;                     ///< of norm or energy, whichever is larger

  /// When |X| exceeds `distance` for the first time, interpolated; nan if it never does.
  double reaches(double distance) const;
  /// Whether it does so by this time.
  bool passes(double distance, double by = HUGE_VAL) const { return reaches(distance) <= by; }
  /// The largest |X|.
  double farthest() const;
  /// When it passes the next site, |X| = 1; the end of the run if it never does.
  double passage() const;
  /// By which factor the number of sites grows at most.
  double spread() const;
};

/// One seed of the noise.
struct NoiseTrial {
  std::size_t seed;
  std::complex<double> kick{};  ///< shift and push of the noise along the translational mode
  DpsRun coarse{}, fine{};      ///< at two tolerances

  /// `number` of the finer run, with its distance from that of the coarser one.
  template <class Number>
  Estimate of(Number number) const {
    return compare(number(coarse), number(fine));
  }
};
using NoiseTrials = std::vector<NoiseTrial>;

/// How many pass a distance by the time `by`; exact if both tolerances give the same.
Estimate passing(const NoiseTrials& trials, double distance, double by = HUGE_VAL);

/// By which factor the number of sites on which these breathers live grows at most.
Estimate largest_spread(const NoiseTrials& trials);

/// The median of the times at which these breathers pass the next site.
Estimate median_passage(const NoiseTrials& trials);

}  // namespace lattice
