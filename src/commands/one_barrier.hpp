#pragma once
/**
# A barrier with your own parameters

`sec32_barrier barrier --omega 1.1` prints the barrier (breather.hpp) at equal frequency and at equal area, both
with their signs, from two tolerances in extended precision, for other wells (`--well pendulum`) and contacts too
(`--contact power --alpha 1.75`, `--precompression 1e-3 --omega 1.3`). In Python this is `lattice.barrier`. */

#include "lattice/orbits/breather_pairs.hpp"
#include "sec3/breather_options.hpp"

namespace lattice {

/// The command: omega_b, well and contact, the pair of breathers, the table.
struct OneBarrier : ChosenBreather {
  static constexpr Title title{"barrier", "energy between the two breathers, with its sign"};

  /// Declares them.
  void parameters(Parameters& p);
  using Found = BreatherPair;
  /// Both breathers, measured in extended precision. Throws UsageError, NewtonFailed, NoBranch.
  Found find() const;
  /// Rows `quantity,value,error,unit,kind,meaning,reason`.
  Table quantities(const Found& found) const;
  /// What the program prints.
  Table table() const { return quantities(find()); }
};

}  // namespace lattice
