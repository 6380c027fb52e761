#pragma once
/**
# How far the DpS equation is from the chain

Section 3.1 says that the approximation of Eq. (13) is $O(\epsilon^{3/2})$-close to the chain up to times
$t = O(\epsilon^{-1/2})$, in linear wells and in all others whose frequency at rest is one. Both equations are
followed here from the same start, and what counts is the largest deviation of any bead. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lattice/dps/evolve.hpp"
#include "lattice/integrators/refinement.hpp"
#include "lattice/numerics/estimate.hpp"

namespace lattice {

/// A field from which both equations start, the wells of the chain, and the rate of the DpS equation.
struct Compared {
  Field start;
  Well well{};
  double rate = 1 / (2 * tau_0());
};

/**
Three errors could be mistaken for that of the approximation: those of the chain's integration, of
the DpS integration, and of the sampling of a maximum over time. The chain is moved by a
Runge–Kutta–Nyström scheme that treats the opening and closing of contacts (event_corrected.hpp), the DpS
equation by GSL's adaptive method of order eight. Every point is computed twice, the second time with
half the step, twice the samples and a hundredth of the tolerance. What must agree is the *deviation*,
the number that we want. The difference of the two is the error in the tables, and it must stay far
below the deviation. */
struct ErrorResolution {
  int halvings;
  double tolerance;
};
inline constexpr ErrorResolution error_resolutions[] = {{0, 1e-9}, {1, 1e-11}};

/**
The deviation compares both equations at the same instants, so they run side by side: the chain's samples
set the grid, and the DpS integrator is carried to the same slow time. */
/// The largest deviations up to each of the `horizons` in slow time, of which the last is the longest.
inline std::vector<double> deviations(const Compared& both, double eps,
                                      const ErrorResolution& resolution,
                                      const std::vector<double>& horizons) {
  Chain chain{both.start.size()};
  chain.well = both.well;
  State<double> state = dps_state(both.start, eps, 0);
  Reference slow(Dps{.sites = both.start.size(), .rate = both.rate}, 2 * both.start.size(),
                 resolution.tolerance);
  std::vector<double> x = interleaved(both.start);
  Field field = both.start;
  std::vector<double> largest(horizons.size());
  double tau = 0;
  const EventCorrected method = method_for(1e-6, 0.1, resolution.halvings);
  const double time = horizons.back() / std::sqrt(eps);
  evolve(method, chain, state, time, denser(0.2), [&](const State<double>& now) {
    if (now.t == 0) return;
    slow.advance(tau, std::sqrt(eps) * now.t, x);
    for (std::size_t n = 0; n < field.size(); ++n) field[n] = {x[2 * n], x[2 * n + 1]};
    const auto approximate = dps_state(field, eps, now.t).y;
    double apart = 0;
    for (std::size_t n = 0; n < field.size(); ++n)
      apart = std::max(apart, std::abs(approximate[n] - now.y[n]));
    for (std::size_t k = 0; k < horizons.size(); ++k)
      if (tau <= horizons[k] * (1 + 1e-12)) largest[k] = std::max(largest[k], apart);
  });
  return largest;
}

/// The same with errors, from both resolutions.
inline std::vector<Estimate> refined_deviations(const Compared& both, double eps,
                                                const std::vector<double>& horizons) {
  const auto coarse = deviations(both, eps, error_resolutions[0], horizons);
  const auto fine = deviations(both, eps, error_resolutions[1], horizons);
  std::vector<Estimate> out;
  for (std::size_t k = 0; k < fine.size(); ++k) out.push_back(compare(coarse[k], fine[k]));
  return out;
}

}  // namespace lattice
