// An array of cantilevers in SI units: what a blow of one metre per second does at cantilever 80.
#include <iostream>
#include "lattice/packets/array_impact.hpp"

using namespace lattice;

int main() {
  const ArrayImpact impact;
  const Way way = pass(impact, 80, 60, {0.1, 0.05});
  const Pulse pulse = pulse_of(way.at, impact.scales);
  std::cout << "force " << pulse.force << " N, velocity " << pulse.velocity << " m/s, arrival "
            << 1e3 * pulse.arrival << " ms\n";
}
