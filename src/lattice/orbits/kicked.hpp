#pragma once
/**
# The kick that frees a breather

A breather that is stable around its centre needs a kick of some size $c_c$ to leave it (depinning.hpp). This
file predicts $c_c$ from one period of the tangent map and the barrier at equal area, and finds it in
runs of the whole chain. */

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "lattice/measure/depinning.hpp"
#include "lattice/numbers/estimate.hpp"
#include "lattice/numbers/parallel.hpp"
#include "lattice/orbits/breather.hpp"
#include "lattice/stepping/contact_rkn.hpp"

namespace lattice {

/**
Whoever kicks needs a breather at rest on a chain that holds it, in linear wells. */
struct RestingBreather {
  Centre centre = Centre::bond;
  Chain<Harmonic, Hertz> chain{};
  State<double> rest{};
  double period = 0, energy = 0;

  /// The path after a kick, until `watch` says that it is enough.
  template <class Stepper, class Watch>
  Creep after(double c, const Stepper& stepper, double time, Watch watch) const {
    return creep(stepper, chain, kicked(rest, c), creep_sample(period), time, watch);
  }
  /// The same to the end of `time`.
  template <class Stepper>
  Creep after(double c, const Stepper& stepper, double time) const {
    return creep(stepper, chain, kicked(rest, c), creep_sample(period), time);
  }
};

/**
The chain is as long as it is told; one site more gives a site-centred breather its middle. */
/// Throws ShortChain where the breather needs a longer one.
inline RestingBreather resting_breather(Centre centre, Phase phase, double omega,
                                        std::size_t sites) {
  const bool site = centre == Centre::site;
  const Fitted found =
      fit_chain(centre, omega, 0, site ? sites | 1 : sites, site ? 23 : 22, 1e-16, phase);
  return {centre,
          {found.problem.chain.sites},
          found.orbit.start,
          found.problem.period(),
          found.orbit.energy};
}

/**
## Prediction

The error comes from two tolerances of the tangent map and from the barrier. Where the breather is unstable
any kick moves it, and there is neither a frequency nor a threshold. */
struct Prediction {
  Estimate threshold{}, share{}, frequency{}, barrier{};
  bool exists() const { return frequency.value > 0; }
};

/// From the barrier at equal area, E_site - E_bond; without a frequency if the breather is unstable.
inline Prediction predict_threshold(const RestingBreather& at, const Estimate& barrier) {
  std::array<Pinning, 2> found;
  for (std::size_t i = 0; i < 2; ++i) {
    Landing<double> rule;
    if (i == 0) rule.tolerance *= 16;
    found[i] = pinning_of(at.chain, at.centre, at.rest, at.period, rule);
  }
  const auto pair = [&](auto of) { return compare(of(found[0]), of(found[1])); };
  Prediction out;
  out.share = pair([](const Pinning& p) { return p.share; });
  out.barrier = barrier;
  if (!(found[1].frequency2 > 0)) return out;
  out.frequency = pair([](const Pinning& p) { return std::sqrt(p.frequency2); });
  out.threshold = pair([&](const Pinning& p) { return freeing_kick(barrier.value, p); });
  out.threshold.error += 0.5 * out.threshold.value * std::abs(barrier.error / barrier.value);
  return out;
}

/**
## Runs

A run ends as soon as its fate is decided: the breather is well past the hill or has turned round. Just at the
threshold it would take for ever, so that ten times $1/\Omega$ is the limit, beyond which nothing is decided
within $10^{-7}$ of it. */
/// The path after a kick up to its decision; throws std::runtime_error if there is none in `limit`.
template <class Stepper>
Creep decided_path(const RestingBreather& at, double c, const Stepper& stepper, double limit) {
  Creep path =
      at.after(c, stepper, limit, [](const Creep& so_far, const State<double>&, const auto&) {
        return mobility_of(so_far) == Mobility::undecided;
      });
  if (mobility_of(path) == Mobility::undecided)
    throw std::runtime_error("a kick of " + std::to_string(1e6 * c) +
                             "e-6 neither frees the breather nor leaves it pinned");
  return path;
}

/**
Three kicks, 5, 20 and 40 per cent above the prediction, free the breather. The speeds with which the two
weaker ones pass the hill lead to the threshold; with the third one instead of the second the extrapolation
goes as far again, and the difference is its error. The least margin of the runs comes with it, $c^2/2$ over
what they lost. */
struct FreeingKick {
  Estimate value{};
  double margin = std::numeric_limits<double>::infinity();
};

/// The error is that of the extrapolation. Throws std::runtime_error where a kick does not free.
inline FreeingKick freeing_kick_of(const RestingBreather& at, const Prediction& guess,
                                   const ContactAware& stepper) {
  const double limit = 10 / guess.frequency.value, least = guess.threshold.value;
  const std::array<double, 3> c{1.05 * least, 1.2 * least, 1.4 * least};
  std::array<double, 3> v{};
  FreeingKick out;
  for (std::size_t i = 0; i < 3; ++i) {
    const Creep path = decided_path(at, c[i], stepper, limit);
    if (mobility_of(path) != Mobility::free)
      throw std::runtime_error("a kick above the prediction leaves the breather pinned");
    v[i] = hill_speed(path);
    out.margin = std::min(out.margin, path.drift_margin(c[i], at.energy));
  }
  out.value =
      compare(threshold_from(c[0], v[0], c[2], v[2]), threshold_from(c[0], v[0], c[1], v[1]));
  return out;
}

/**
Two schemes give the rest of the error. The longest runs come first. */
/// One threshold for each breather and its prediction, with the margin of the finer scheme.
inline std::vector<FreeingKick> freeing_kicks(const std::vector<RestingBreather>& at,
                                              const std::vector<Prediction>& guess,
                                              const ContactAware& coarse,
                                              const ContactAware& fine) {
  const std::size_t n = at.size();
  std::vector<FreeingKick> found(2 * n);
  parallel_for("thresholds", 2 * n, [&](std::size_t i) {
    found[i] = freeing_kick_of(at[i % n], guess[i % n], i < n ? fine : coarse);
  });
  for (std::size_t i = 0; i < n; ++i) found[i].value = compare(found[n + i].value, found[i].value);
  found.resize(n);
  return found;
}

/**
That the threshold lies where we say is then seen directly: one per cent below it the breather must turn
round, one per cent above it must get over. */
/// Lowers the margin of `found` to that of these runs; throws std::runtime_error where a fate is another.
inline void confirm(const RestingBreather& at, const Prediction& guess, const ContactAware& stepper,
                    FreeingKick& found) {
  std::array<double, 2> margins{};
  parallel_for("bracket", 2, [&](std::size_t i) {
    const double c = (i ? 1.01 : 0.99) * found.value.value;
    const Creep path = decided_path(at, c, stepper, 10 / guess.frequency.value);
    if (mobility_of(path) != (i ? Mobility::free : Mobility::pinned))
      throw std::runtime_error("the threshold is not within one per cent of " +
                               std::to_string(1e6 * found.value.value) + "e-6");
    margins[i] = path.drift_margin(c, at.energy);
  });
  found.margin = std::min({found.margin, margins[0], margins[1]});
}

}  // namespace lattice
