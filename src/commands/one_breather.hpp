#pragma once
/**
# One breather with your own parameters

`sec32_newton_breathers breather --centre site --omega 1.1` computes one breather of section 3.2. The chain
must be long enough for it: a bead at the end must not feel that its outer neighbour is missing, and a longer
chain tells how much it would. `--well pendulum` takes another well. All have the same frequency at rest, so that their
families begin alike, and each is followed from there.

Contacts may have another exponent (`--contact power --alpha 1.8`) or be compressed (`--precompression 1e-3
--omega 1.3`), and beads may have two masses in turn (`--mass-ratio 0.8 --omega 1.3`) or one other in the middle
(`--defect-mass 1.5`); the frequency must then be above the linear waves of the chain. In Python this is
`lattice.breather`. */

#include "sec3/breather_options.hpp"

namespace lattice {

/// The command: which breather, what Newton finds, its tables.
struct OneBreather : ChosenBreather {
  static constexpr Title title{"breather", "one breather: amplitude, energy, area, residual"};
  bool as_profile = false;  ///< whether `table` is the profile

  /// Declares them and which breather.
  void parameters(Parameters& p);

  using Found = Fitted;
  /// The breather. Throws UsageError, NewtonFailed, NoBranch.
  Found find() const;
  /// Rows `quantity,value,error,unit,kind,meaning,reason`.
  Table quantities(const Found& found) const;
  /// The positions at t = 0, with relative accuracy at every site.
  Table profile(const Found& found) const;
  /// What the program prints.
  Table table() const;
};

}  // namespace lattice
