#include "sec34/blowup_band.hpp"

#include <algorithm>
#include <array>

namespace lattice {

// Speed and way of the beads in an impact, at two resolutions
Confinement confinement(const Impact& impact, const EventCorrected& rough,
                        const EventCorrected& fine) {
  std::array<double, 2> speed{};
  std::array<ImpactRun, 2> run;
  for (std::size_t i : {0, 1})
    run[i] = strike(i ? fine : rough, impact, [&](const State<double>& now, const auto&) {
      for (double v : now.v) speed[i] = std::max(speed[i], std::abs(v) / impact.velocity);
    });
  const Estimate furthest = compare(run[0].largest_displacement, run[1].largest_displacement);
  return {compare(speed[0], speed[1]), quotient(furthest, exact(impact.velocity * impact.time)),
          compare(run[0].run.energy_drift, run[1].run.energy_drift),
          std::min(run[0].end.t, run[1].end.t) / impact.time, furthest};
}

}  // namespace lattice
