#pragma once
/**
# Breathers at rest, for comparison with a packet

A packet is compared with the breathers at rest of its frequency. Both families, around a bond and around a site, are
continued over the packet's range of frequencies in small steps, each starting Newton's method from the breather before,
and the barrier between them, $E_{\rm site}-E_{\rm bond}$ at equal area, is taken on the way. */

#include <string>
#include <vector>

#include "lattice/orbits/breather_pairs.hpp"
#include "report/program.hpp"
#include "sec34/wake.hpp"

namespace lattice {

/// Both families, at the same frequencies.
struct BreathersAtRest {
  std::vector<Orbit<double>> bond, site;
  std::vector<double> gap;  ///< E_site - E_bond at equal area
};

/// For frequencies from 1.58 to 1.86 and the anharmonicity `s`.
BreathersAtRest breathers_at_rest(double s);

/**
For the facts we average from $t = 100$ to 300 and compare with the breather of the same mean frequency. */
/// Adds frequency, energy and area of the packet, from two runs, and those of the breather at rest.
void compare_inside(Quantities& facts, const std::string& name, const BreathersAtRest& f,
                    const std::vector<Inside>& coarse, const std::vector<Inside>& fine);

}  // namespace lattice
