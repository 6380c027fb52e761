#include "sec2/localized.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "lattice/gsl/random.hpp"
#include "lattice/integrators/event_corrected.hpp"
#include "lattice/orbits/breather.hpp"

namespace lattice {

State<double> localized(const std::string& name, const State<double>& breather, std::size_t sites) {
  if (name == "breather") return resized(breather, sites);
  State<double> state(sites);
  const std::size_t middle = sites / 2, steps = 20;
  if (name == "displaced") state.y[middle] = 1;
  if (name == "kicked") state.v[middle] = 1;
  if (name == "pair") {
    state.y[middle] = 0.5;
    state.y[middle + 1] = -0.5;
  }

  // Steps upwards, between two ends at rest
  if (name == "increasing" || name == "step_down") {
    const std::vector<double> rise = shaken(std::vector<double>(steps, 0.05), 0.8, 13);
    for (std::size_t n = middle; n < sites; ++n)
      state.y[n] = state.y[n - 1] + (n < middle + steps ? rise[n - middle] : 0);
    if (name == "step_down")
      for (std::size_t n = middle + steps / 2; n < sites; ++n) state.y[n] -= 2 * rise[steps / 2];
  }
  return state;
}

Return closest_return(const Chain& chain, const State<double>& start, double step, double every,
                      double time) {
  Return out;
  const auto look = [&](const State<double>& now) {
    double d = 0;
    for (std::size_t n = 0; n < chain.sites; ++n)
      d = std::max({d, std::abs(now.y[n] - start.y[n]), std::abs(now.v[n] - start.v[n])});
    out.away = std::max(out.away, d);
    if (out.away > 1e-3) out.moved = true;
    if (out.moved) out.back = std::min(out.back, d / out.away);
  };
  State<double> state = start;
  const Run run = evolve(EventCorrected{step}, chain, state, time, every, look);
  assert_isolated(state, energy(chain, start) > 0 ? run.energy_drift : 0);
  return out;
}

void assert_isolated(const State<double>& end, double energy_drift) {
  if (end.v.front() != 0 || end.v.back() != 0)
    throw std::runtime_error("the ends of the chain have moved");
  if (!(energy_drift < 1e-8)) throw std::runtime_error("the energy drifts");
}

}  // namespace lattice
