#include "sec34/surface_mode.hpp"

namespace lattice {

WatchedBeads watch_beads(const EventCorrected& method, const Impact& impact, std::size_t beads,
                         double settled) {
  WatchedBeads out;
  out.beads.resize(beads);
  out.inner.assign(beads, 0.0);
  double before = 0, turns = 0;  // velocity of bead 1
  const auto watch = [&](const State<double>& now, const std::vector<double>&) {
    if (now.t <= settled) return;
    const bool turning = before > 0 && now.v[0] <= 0;
    for (std::size_t n = 0; n < beads; ++n) {
      out.beads[n].add(now.t, now.y[n], now.v[n]);
      if (turning) out.inner[n] += now.y[n];
    }
    if (turning) ++turns;
    before = now.v[0];
  };
  ImpactRun& run = out;
  run = strike(method, impact, watch);
  for (double& y : out.inner) y /= turns;
  return out;
}

}  // namespace lattice
