#pragma once
/**
# The kick that frees a breather

A pinned breather is set in motion only by kicks above some $c_c$. This file predicts $c_c$ from one period of the
linearised flow and the barrier at equal area (depinning.hpp), and finds it in runs of the whole chain. */

#include "lattice/integrators/event_corrected.hpp"
#include "lattice/orbits/breather_pairs.hpp"
#include "sec33/depinning.hpp"

namespace lattice {

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

/// Its errors come from two tolerances of the linearised flow and from the barrier. If the pinning pair is real the
/// slightest kick may move the breather, and there is neither a frequency nor a threshold.
struct Prediction {
  Estimate threshold{}, share{}, frequency{}, barrier{};  ///< c_c, phi, Omega, and E_site - E_bond
  Estimate along_mode{};  ///< c_c of a kick along the shift x, of length one, instead of g
  bool exists() const { return frequency.value > 0; }  ///< whether there is a threshold
};

/// From the barrier at equal area.
Prediction predict_threshold(const RestingBreather& at, const Estimate& barrier);

/// The path up to its decision; std::runtime_error if there is none within `limit`. Ten times 1/Omega are enough for
/// all kicks but those within 1e-7 of the threshold.
KickedPath decided_path(const RestingBreather& at, double c, const Method& method, double limit);

/// The threshold from the speeds at the maximum after kicks 5, 20 and 40 per cent above the prediction. The two weaker
/// ones give the value, the third the error. Throws std::runtime_error if one of them does not free the breather.
Estimate freeing_kick_of(const RestingBreather& at, const Prediction& guess,
                         const EventCorrected& method);

}  // namespace lattice
