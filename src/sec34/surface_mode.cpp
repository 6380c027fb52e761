#include "sec34/surface_mode.hpp"

#include <utility>

namespace lattice {

WatchedBeads watch_beads(const EventCorrected& method, const Impact& impact, std::size_t beads,
                         double settled) {
  std::vector<Oscillation> seen(beads);
  std::vector<double> inner(beads, 0.0);
  double before = 0, turns = 0;  // velocity of bead 1
  const auto watch = [&](const State<double>& now, const std::vector<double>&) {
    if (now.t <= settled) return;
    const bool turning = before > 0 && now.v[0] <= 0;
    for (std::size_t n = 0; n < beads; ++n) {
      seen[n].add(now.t, now.y[n], now.v[n]);
      if (turning) inner[n] += now.y[n];
    }
    if (turning) ++turns;
    before = now.v[0];
  };
  ImpactRun run = strike(method, impact, watch);
  for (double& y : inner) y /= turns;
  return {std::move(run), seen, inner};
}

}  // namespace lattice
