#include "sec34/escapes.hpp"

#include <algorithm>
#include <stdexcept>

#include "lattice/diagnostics/path.hpp"
#include "lattice/integrators/refinement.hpp"

namespace lattice {

Trial trial_of(const Impact& impact, double tolerance) {
  const Impact whole = on_long_chain(impact);
  const auto escape = [&](int halvings) {
    return strike(method_for(tolerance, largest_step, halvings), whole).run.escape_time;
  };
  return {impact.velocity, escape(0), escape(1)};
}

EscapeBand band_of(const std::vector<Trial>& trials) {
  EscapeBand band{.first_escape = far_away, .last_survivor = 0, .latest = 0};
  for (const Trial& trial : trials)
    if (!trial.agreed()) {
      ++band.disputed;
    } else if (trial.escaped()) {
      band.first_escape = std::min(band.first_escape, trial.velocity);
      band.latest = std::max(band.latest, trial.fine);
    } else {
      band.last_survivor = std::max(band.last_survivor, trial.velocity);
    }
  if (!(band.last_survivor > 0 && band.first_escape < far_away))
    throw std::runtime_error("all impacts of a scan have the same outcome: choose another range");
  return band;
}

}  // namespace lattice
