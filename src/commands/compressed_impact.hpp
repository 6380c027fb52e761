#pragma once
/**
# One impact on a compressed chain

`sec4_precompression_mi impact` strikes a chain with wells of any name; the contact, whose compression is the subject,
stays. The named wells all have the phonons of the harmonic one, on which the length of the chain rests. Contacts may go
on opening for ever, so the event-corrected method goes all the way, with steps that are halved until the end states of
two runs agree to `tolerance`. It fails if they do not, or if a bead runs away before the end, because then there is no
packet to report. */

#include "report/model_options.hpp"
#include "report/program.hpp"

namespace lattice {

/// The command.
struct CompressedImpact {
  static constexpr Title title{"impact", "one impact: centre, width and energy of the packet"};
  double time = 724, velocity = 1.87, d = 0.5, tolerance = 1e-4;
  Well well = Quartic{1};

  /// Declares well, time, velocity, compression and tolerance.
  void parameters(Parameters& p) {
    add_holding_well(p, well, "the phonons are others");
    p.add("time", time, "length of the run", {1, 2e4});
    p.add("velocity", velocity, "impact velocity", {1e-6, 100});
    p.add("d", d, "compression of the contacts", {1e-3, 10});
    p.add("tolerance", tolerance, "relative error allowed in the end state", {1e-11, 0.1});
  }
  /// The packet with the most energy, and how far the run can be trusted.
  Table table() const;
};

}  // namespace lattice
