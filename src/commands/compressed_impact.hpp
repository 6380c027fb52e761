#pragma once
/**
# One impact on a compressed chain

`sec4_precompression_mi impact` strikes a chain with wells of any name; the contact, whose compression is the subject,
stays. The named wells all have the phonons of the harmonic one, on which the length of the chain rests. Contacts may go
on opening for ever, so the event-corrected method goes all the way, with steps that are halved until the end states of
two runs agree to `tolerance`. It fails if they do not, or if a bead runs away before the end, because then there is no
packet to report. */

#include <cmath>
#include <string>

#include "lattice/impact/impact.hpp"
#include "report/model_options.hpp"
#include "report/program.hpp"
#include "sec4/packets.hpp"

namespace lattice {
using namespace report;

/// The command.
struct CompressedImpact {
  static constexpr Title title{
      "impact", "one impact on a compressed chain: centre, width and energy of the packet"};
  double time = 724, velocity = 1.87, d = 0.5, tolerance = 1e-4;
  Well well = Quartic{1};

  /// Declares well, time, velocity, compression and tolerance.
  void parameters(Parameters& p) {
    add_holding_well(p, well, "the phonon band is different");
    p.add("time", time, "duration of the run", {1, 2e4});
    p.add("velocity", velocity, "velocity of the impact on the first bead", {1e-6, 100});
    p.add("d", d, "static compression d of the contacts", {1e-3, 10});
    p.add("tolerance", tolerance, "relative error allowed in the final state", {1e-11, 0.1});
  }
  /// The packet with the most energy, and how far the run can be trusted.
  Table table() const {
    const Impact impact =
        on_long_chain({velocity, {.well = well, .contact = CompressedHertz{d}}, time});
    const auto runs =
        refined(tolerance, [&](const EventCorrected& method) { return strike(method, impact); });
    const auto packet = [&](auto of) {
      return runs.of([&](const ImpactRun& run) { return of(packet_sample(time, run.density)); });
    };
    const auto envelope = [&](auto of) {
      return runs.of([&](const ImpactRun& run) { return of(snapshot(impact.chain, run.end)); });
    };
    const auto width = [](const Snapshot& shot) {
      return shot.reach() < envelope_half_width ? shot.sech.width : std::nan("");
    };

    // Where it is, its form, and how far the run can be trusted
    Answers q{"a --time at which one packet stands out"};
    q.add("centre", packet([](const PacketSample& p) { return p.centre; }), "site",
          "energy centre, at the end of the run, of the packet with the most energy");
    q.add("width", envelope(width), "site",
          "width w of the sech((n - n_0)/w) fitted to the envelope of its velocities",
          "no sech fits: the centre or the width of the best one lies beyond the " +
              std::to_string(2 * envelope_half_width + 1) + " sites of the fit");
    q.add_small(
        "residual", envelope([](const Snapshot& shot) { return shot.sech.residual; }), "",
        "root-mean-square difference between envelope and fit, relative to the height of the fit");
    q.add(
        "energy_fraction", packet([](const PacketSample& p) { return p.share; }), "",
        "energy within twenty sites of the packet's peak divided by that of the chain, at the end");
    q.add_small("boundary_energy_fraction",
                packet([](const PacketSample& p) { return p.boundary; }), "",
                "energy of the first five sites divided by that of the chain, at the end");
    q.add_small("energy_drift", runs.of([](const ImpactRun& run) { return run.run.energy_drift; }),
                "", "largest relative change of the chain's energy during the run");
    return q.table;
  }
};

}  // namespace lattice
