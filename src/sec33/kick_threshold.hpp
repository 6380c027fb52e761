#pragma once
/**
# The kick that frees a breather

Section 3.3 kicks a breather along its pinning mode: each velocity is changed by $c\,g_n$, where $g_n$ is
the normalised discrete gradient (kick.hpp). A pinned breather is set in motion only if $c$ exceeds some
$c_c$. This file predicts $c_c$ from one period of the tangent map and the barrier at equal area
(depinning.hpp), and then finds it in runs of the whole chain. */

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "lattice/integrators/event_corrected.hpp"
#include "lattice/numerics/estimate.hpp"
#include "lattice/orbits/breather.hpp"
#include "lattice/orbits/breather_pairs.hpp"
#include "sec33/depinning.hpp"

namespace lattice {

/**
To begin with we need a breather at rest on a chain that holds it, in harmonic wells as in the article. */
struct RestingBreather {
  Centre centre = Centre::bond;
  Chain chain{};
  State<double> rest{};           ///< at the instant at which all beads are at rest
  double period = 0, energy = 0;  ///< of the breather before the kick

  /// The path after a kick of size `c`, until `look` stops it or `time` is over.
  KickedPath after(double c, const Method& method, double time, const KickLook& look = {}) const {
    return follow_kicked(method, chain, kicked(rest, c), sample_of_mean(period), time, look);
  }
};

/**
The chain has the given number of sites, or one more if a site-centred breather needs a middle, and must
hold the tail of the breather down to rounding, $10^{-16}$. */
/// Throws ShortChain if the breather needs a longer chain, NewtonFailed if it is not found.
RestingBreather resting_breather(Centre centre, Phase phase, double omega_b, std::size_t sites);

/// Event-corrected steps of this length by the method of order six with fourteen stages.
EventCorrected fourteen_stages(double step);

/// Both breathers of this frequency in harmonic wells, with their barriers at equal frequency and at equal area.
BreatherPair barriers_at(double omega_b);

/**
## Prediction

A pinned breather oscillates about its centre, with the frequency of its pinning mode, and the kick that
carries it over the barrier follows from the two (depinning.hpp). The error comes from two tolerances of
the tangent map and from the barrier. If the pinning pair is real the slightest kick may move it, and
there is neither a frequency nor a threshold. */
struct Prediction {
  Estimate threshold{}, share{}, frequency{},
      barrier{};  ///< c_c, phi, Omega, and the barrier at equal area
  Estimate
      along_mode{};  ///< c_c of a kick along the shift x, of length one, instead of the gradient
  /// Whether there is a threshold.
  bool exists() const { return frequency.value > 0; }
};

/// From the barrier at equal area, E_site - E_bond; without a frequency if the pinning pair is real.
Prediction predict_threshold(const RestingBreather& at, const Estimate& barrier);

/**
## Runs

A run ends as soon as its fate is decided: the breather is well past the top of the barrier, or it has
turned round. Exactly at the threshold this would take for ever. With $\Omega$ the frequency of the
pinning mode we allow ten times $1/\Omega$, in which all kicks are decided but those within $10^{-7}$ of
the threshold. */
/// The path after a kick up to its decision; throws std::runtime_error if there is none within `limit`.
KickedPath decided_path(const RestingBreather& at, double c, const Method& method, double limit);

/**
The threshold is extrapolated from runs above it. Three kicks, 5, 20 and 40 per cent above the prediction,
free the breather. The speeds with which the two weaker ones pass the top of the barrier lead to the
threshold; with the third instead of the second the extrapolation goes from twice as far, and the
difference is its error. With the threshold we keep the least margin of the runs: $c^2/2$, the energy of
the kick, over the energy that the integration lost. */
struct FreeingKick {
  Estimate value{};  ///< c_c
  double margin = std::numeric_limits<double>::infinity();
};

/// The threshold near `guess`, with the error of the extrapolation. Throws std::runtime_error if one of
/// the kicks does not free the breather.
FreeingKick freeing_kick_of(const RestingBreather& at, const Prediction& guess,
                            const EventCorrected& method);

/**
The rest of the error is that of the integration, and comes from two schemes. Those of the finer one take
longest and come first. */
/// One threshold for each breather and its prediction, with the margin of the finer scheme.
std::vector<FreeingKick> freeing_kicks(const std::vector<RestingBreather>& at,
                                       const std::vector<Prediction>& guess,
                                       const EventCorrected& coarse, const EventCorrected& fine);

/**
An extrapolation is no proof, so finally the threshold is bracketed directly: one per cent below it the
breather must turn round, one per cent above it must get over. */
/// Lowers the margin of `found` to that of these runs if they have less; throws std::runtime_error if one
/// of them ends otherwise.
void confirm(const RestingBreather& at, const Prediction& guess, const EventCorrected& method,
             FreeingKick& found);

}  // namespace lattice
