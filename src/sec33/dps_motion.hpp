#pragma once
/**
# A breather of the DpS equation that moves

Section 3.3 perturbs a stationary breather (stationary.hpp) and sees it move. Its place is the centre of
$|v_n|^4$: the fourth power keeps out small noise along the chain. For a small shift $x$ and push $y$ along
the pinning pair of spectrum.hpp the displacement is $X = gx$, where $g$ is the derivative of the centre,
and $\ddot X = \pm\lambda^2X$ with the plus at a site and the minus at a bond. The simplest
potential with both is a sine, in which the centre moves like a pendulum; about a site
$$\ddot X = \frac{\lambda^2}{2\pi}\sin 2\pi X,$$
and a push $y$ gives it the initial speed $g(\mu-m)y$. This predicts the push that frees a bond-centred
breather, $y_c = |\lambda|/(\pi g(\mu-m))$, and the time that a site-centred one takes to the next bond. If
its push has the growing share $c = (\mu-m)y/(2\lambda)$, it starts with the speed $v = 2g\lambda c$, and
$$t = \int_0^{1/2}\frac{dX}{\sqrt{v^2+(\lambda/\pi)^2\sin^2\pi X}},$$
a complete elliptic integral, for which the arithmetic-geometric mean suffices. */

#include <complex>
#include <cstddef>
#include <string>
#include <vector>

#include "lattice/dps/evolve.hpp"
#include "lattice/numerics/estimate.hpp"
#include "lattice/standing/spectrum.hpp"

namespace lattice {

/// Centre of |v_n|^4 in sites, counted from the rest position of a breather with this centre.
double quartic_centre(Centre centre, const Field& v);

/**
An eigenvector has neither a sign nor a scale in sites, and the pendulum needs both. The derivative of the
centre along $V$ gives them: its modulus is $g$, and the sign of $V$ is chosen such that a positive shift
leads to larger $n$. With $g$ and $\lambda$ the pendulum has no free parameter left, and its predictions can
be compared with runs of the whole equation. */
/// A breather with its pinning pair, whose sign is such that a shift x > 0 goes to larger n.
struct PinnedBreather {
  Centre centre;
  double mu;         ///< its frequency
  double exponent;   ///< alpha, of the contact force
  Field u;           ///< its profile, real
  PinningPair pair;  ///< with that sign
  double shift;      ///< g: how far the centre moves, in sites, for a unit of x

  /// The breather of frequency `frequency` on `sites` sites.
  PinnedBreather(Centre c, double frequency, std::size_t sites);
  /// The breather that has been computed already.
  explicit PinnedBreather(const Stationary<double>& state);

  /// The push at which a pendulum passes the site beside its bond.
  double freeing_push() const;

  /// When a pendulum that is pushed from a site, with this growing share, is half a site away.
  double departure(double growing) const;
};

/**
What a breather does is read from its displacement at samples in time, so a second resolution has to
differ in the samples as well as in the tolerance. The moment at which a distance is passed is
interpolated between two samples; its error comes mainly from noise that oscillates faster than the
samples can show. */
/// Tolerance of the integrator, and samples for each unit of time.
struct Accuracy {
  double tolerance, samples;
};

/// Displacement against time, with the relative drifts of what is conserved.
struct DpsBreatherRun {
  std::vector<double> t{}, X{};
  double norm_drift = 0, energy_drift = 0;
  double sites = 0, most_sites = 0;  ///< on which the breather lives, at first and at most

  /// The largest |X|.
  double largest() const;
  /// When |X| exceeds `distance` for the first time, interpolated; nan if it never does.
  double reaches(double distance) const;
  /// The run up to a time.
  DpsBreatherRun until(double time) const;
  /// By which factor the number of its sites grew.
  double spread() const { return most_sites / sites; }
};

/**
We integrate in the frame that turns with the breather (evolve.hpp), where only the perturbation moves.
Norm and energy are watched at every sample: unless their drift stays far below the share of the energy
that pins the breather, the run says nothing about pinning. */
/// Follows the field `v`, given in the frame that turns with the breather; `watch` sees every sample.
DpsBreatherRun follow_breather(const PinnedBreather& breather, Field v, double time,
                               const Accuracy& accuracy, const DpsLook& watch = {});

/**
Two questions can be put to a breather that is perturbed along the pinning pair and in no other way. The
first: does a perturbation in the growing direction grow at the rate that the matrix says? */
/// The slope of a line through the logarithm of the growing share, after a perturbation of this `size`.
double measured_rate(const PinnedBreather& site, double size, const Accuracy& accuracy);

/// Has it passed the next rest position of its own kind, by the time `by`?
bool moved(const DpsBreatherRun& run, double by = HUGE_VAL);

/**
The second: which push frees a breather? The interval between a push that does not and one that does is
halved `steps` times. The pendulum says where to look, within 20 per cent. */
/// The push that frees `bond`. Throws std::runtime_error if the threshold is not near the pendulum's.
double bisect_push(const PinnedBreather& bond, const Accuracy& accuracy, int steps);

/**
## Breathers under noise

Noise may be complex or real, of both signs or positive, absolute or a share of $u_n$, and the difference matters, since
a push counts far more than a shift. One seed gives the same perturbation on every machine. */
struct Noise {
  const char* name;
  bool imaginary, positive, relative;  ///< complex; of positive parts only; as a share of u_n
  double amplitude;                    ///< the largest of either part

  /// Noise for every site of the breather `u`.
  Field operator()(const Field& u, std::size_t seed) const;
};

/**
To first order the noise moves the breather only through its component along the pinning pair. A trial
records that component together with the runs, so that we can ask later whether it predicts them. It can
also be removed from the noise, which leaves a control that differs in nothing else. */
struct NoiseTrial {
  std::size_t seed;
  std::complex<double> kick{};     ///< shift and push of the noise
  double growing = 0;              ///< size of its growing share
  DpsBreatherRun rough{}, good{};  ///< at two tolerances
};

/// Breather plus noise, the latter with or without (`pinned` false) its component along the pinning pair;
/// records that component in `trial`.
Field perturbed(const PinnedBreather& breather, const Noise& noise, bool pinned, NoiseTrial& trial);

/**
The effect of noise is a matter of counting cases, at both tolerances, because a count is exact only if
both give the same.

The speed of a trial is the mean over the first site that its breather crosses after leaving, if it does. A
departure that has not happened counts as infinitely late, so that the median is not biased by the end of
the run. */
struct Census {
  std::size_t left = 0, moved = 0;             ///< trials that passed half a site, and a whole one
  std::vector<double> departures{}, speeds{};  ///< sorted; a departure that is missing is infinite

  /// The median departure.
  double departure() const { return departures[departures.size() / 2]; }
};

/// Counts what the trials do up to the time `by`, from their runs at one of the tolerances.
Census tally(const std::vector<NoiseTrial>& trials, DpsBreatherRun NoiseTrial::*which,
             double by = HUGE_VAL);

/**
Does the pendulum predict these runs? Departures are compared one by one, and the largest relative
difference counts. Pushes are compared with the one that frees a breather: how many trials are pushed
harder, and how many end as this alone would predict? */
/// The largest relative difference between a departure and that of the pendulum.
double departure_difference(const std::vector<NoiseTrial>& trials,
                            DpsBreatherRun NoiseTrial::*which, const PinnedBreather& site);

/// `over` trials are pushed harder than the push that frees, `told` end as this predicts.
struct PushCount {
  std::size_t over = 0, told = 0;
};

/// Counts both, for the push `freeing`.
PushCount count_pushes(const std::vector<NoiseTrial>& trials, DpsBreatherRun NoiseTrial::*which,
                       double freeing);

/**
A run must not hang on its tolerance, and the structure of a breather that leaves its place may last all the same. */
/// Trials that move at one tolerance and not at the other.
std::size_t torn(const std::vector<NoiseTrial>& trials);

/// By which factor the breathers of these trials spread at most, at both tolerances.
Estimate largest_spread(const std::vector<NoiseTrial>& trials);

/**
Is it the pinning pair that moves a breather? Then its control, whose noise lacks that pair, passes the next site later.
What has not passed it by the end of its run passes it no earlier. */
struct Delay {
  Estimate later{};  ///< share of the seeds of which the control passes later
  Estimate ratio{};  ///< of the median times
};
Delay delay_of(const std::vector<NoiseTrial>& controls, const std::vector<NoiseTrial>& trials);

}  // namespace lattice
