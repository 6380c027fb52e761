#include "commands/compressed_impact.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "lattice/impact/impact.hpp"
#include "sec4/packets.hpp"

namespace lattice {

Table CompressedImpact::table() const {
  const Impact impact =
      on_long_chain({velocity, {.well = well, .contact = CompressedHertz{d}}, time});
  const auto runs =
      refined(tolerance, [&](const EventCorrected& method) { return strike(method, impact); });
  const ImpactRun &coarse = runs.coarse, &fine = runs.fine;
  const PacketSample a = packet_sample(time, coarse.density), b = packet_sample(time, fine.density);
  const Snapshot rough = snapshot(impact.chain, coarse.end),
                 best = snapshot(impact.chain, fine.end);
  const auto width = [](const Snapshot& shot) {
    const double off = std::abs(shot.sech.centre - shot.centre), limit = envelope_half_width;
    return std::max(off, shot.sech.width) < limit ? shot.sech.width : std::nan("");
  };

  // Where it is, its form, and how far the run can be trusted
  Answers q{"a --time at which one packet stands out"};
  q.add("centre", compare(a.centre, b.centre), "site",
        "energy centre of the packet that holds the most energy, at the end of the run");
  q.add("width", compare(width(rough), width(best)), "site",
        "width w of the sech((n - n_0)/w) that fits the envelope of its velocities",
        "no sech: the top or the width of the one that fits best lies beyond the " +
            std::to_string(2 * envelope_half_width + 1) + " sites of the fit");
  q.add_small("residual", compare(rough.sech.residual, best.sech.residual), "",
              "root mean square of what this sech leaves of the envelope, relative to its height");
  q.add("energy_fraction", compare(a.share, b.share), "",
        "energy within twenty sites of the packet's peak over that of the chain, at the end");
  q.add_small("boundary_energy_fraction", compare(a.boundary, b.boundary), "",
              "energy of the first five sites over that of the chain, at the end");
  q.add_small("energy_drift", compare(coarse.run.energy_drift, fine.run.energy_drift), "",
              "largest change of the chain's energy during the run, relative to it");
  return q.table;
}

}  // namespace lattice
