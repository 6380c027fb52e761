#pragma once
/**
# One packet on the damped array with your own parameters

`sec5_experiment damped --velocity 1 --lifetime 10` measures the packet of one impact (damped_packet.hpp);
`--restitution 0.9` adds losses in the contacts. */

#include "report/program.hpp"

namespace lattice {

/// The command.
struct DampedArray {
  static constexpr Title title{"damped", "the packet of an impact on a damped array, after 10 ms"};
  double velocity = 1;     ///< of the impact, m/s
  double lifetime = 10;    ///< of the energy of a beam, ms
  double restitution = 1;  ///< of two cantilevers that meet at 1 m/s

  /// Declares them.
  void parameters(Parameters& p);
  /// What the program prints.
  Table table() const;
};

}  // namespace lattice
