#include "lattice/dps/dps_impact.hpp"

#include <algorithm>
#include <cmath>

namespace lattice {

// The packet at one sample, and whether the motion has come to the far end
static void look(DpsOutcome& out, double tau, const Field& field) {
  const auto d = density(field);
  const auto site = front_packet(d);
  if (tau > 0 && site) out.path.add(tau, d, *site);
  out.far_end = std::max(out.far_end, std::abs(field.back()));
}

DpsOutcome follow_dps(const Dps& dps, const Field& start, double duration, std::size_t samples,
                      const Tolerance& tolerance, const DpsObserver& watch) {
  DpsOutcome out{{}, start};
  out.norm_drift =
      evolve_dps(dps, out.end, duration, samples, tolerance, [&](double tau, const Field& field) {
        watch(tau, field);
        look(out, tau, field);
      });
  return out;
}

Estimate packet_amplitude(const Path& path) {
  const double end = path.back().centre;
  Estimate top = path.largest_peak(end - 1, end);
  if (std::isnan(top.value)) top = path.largest_peak(end - 2, end);
  const double amplitude = std::sqrt(top.value);
  return {amplitude, top.error / (2 * amplitude)};
}

}  // namespace lattice
