// Strikes a chain of 100 beads in soft wells and prints how much of the energy stays at its end.
#include <iostream>
#include "lattice/impact/impact.hpp"

using namespace lattice;

int main() {
  const Chain chain{100, Quartic{-1.0 / 6}};
  auto state = struck(100, 1.5);
  evolve(EventCorrected{0.05}, chain, state, 200);
  std::cout << "boundary share " << boundary_share(energy_density(chain, state)) << '\n';
}
