#include "sec34/blowup_band.hpp"

#include <algorithm>

namespace lattice {

EscapeBand band_of(const std::vector<Escape>& trials) {
  const double spacing = trials[1].velocity - trials[0].velocity;
  EscapeBand band{trials.back().velocity, trials.front().velocity, spacing, 0};
  for (const Escape& trial : trials) {
    if (!trial.agreed())
      band.disputed += 1 / double(trials.size());
    else if (trial.gone(0))
      band.first_escape = std::min(band.first_escape, trial.velocity);
    else
      band.last_survivor = std::max(band.last_survivor, trial.velocity);
  }
  return band;
}

}  // namespace lattice
