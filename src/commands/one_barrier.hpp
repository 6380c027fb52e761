#pragma once
/**
# A barrier with your own parameters

`sec32_barrier barrier --omega 1.1` prints the barrier (breather.hpp) at equal frequency and at equal area, both
with their signs, from two tolerances in the wider type. In Python this is `lattice.barrier`. */

#include "lattice/orbits/breather_pairs.hpp"
#include "report/program.hpp"

namespace lattice {

/// The command: omega_b and s (dimensionless), the pair of breathers, the table.
struct OneBarrier {
  static constexpr Title title{"barrier", "energy between the two breathers, with its sign"};
  double omega_b = 1.1, s = 0;

  /// Declares both.
  void parameters(Parameters& p);
  using Found = BreatherPair;
  /// Both breathers, measured in the wider type. Throws NewtonFailed, NoBranch.
  Found find() const;
  /// Rows `quantity,value,error,unit,kind,meaning,reason`.
  Table quantities(const Found& found) const;
  /// What the program prints.
  Table table() const { return quantities(find()); }
};

}  // namespace lattice
