#include "lattice/dps/dps_impact.hpp"

#include <algorithm>
#include <cmath>

namespace lattice {

// The packet at one sample, and whether the motion has come to the far end
static void look(DpsOutcome& out, double tau, const Field& field) {
  const auto d = density(field);
  const auto site = front_packet(d);
  if (tau > 0 && site) out.track.add(tau, d, *site);
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

double packet_amplitude(const Track& track) {
  const double end = track.centre.back();
  const double last = track.largest_peak(end - 1, end).value;
  return std::sqrt(std::isnan(last) ? track.largest_peak(end - 2, end).value : last);
}

DpsPair follow_dps_to(double tolerance, const Dps& dps, const Field& start, double duration,
                      std::size_t samples, const DpsObserver& watch) {
  return {follow_dps(dps, start, duration, samples, 100 * tolerance, Unwatched{}),
          follow_dps(dps, start, duration, 2 * samples, tolerance, watch)};
}

}  // namespace lattice
