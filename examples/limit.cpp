// The limit of small amplitude: a packet of the DpS equation, struck at one end, and its speed.
#include <iostream>
#include "lattice/dps/evolve.hpp"

using namespace lattice;

int main() {
  const Dps dps{60};
  const DpsOutcome run = follow_dps(dps, dps_impact(60), 80, 400, 1e-9);
  std::cout << "speed " << packet_speed(run.path, 40).value
            << " sites per unit of slow time, norm drift " << run.norm_drift << '\n';
}
