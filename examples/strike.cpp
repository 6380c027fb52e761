// Strikes a chain of 100 beads and prints how much of the energy stays at its end. Core only.
#include <iostream>
#include "lattice/measure/impact.hpp"

int main() {
  const lattice::Chain<lattice::Quartic, lattice::Hertz> chain{100, {-1.0 / 6}};
  auto state = lattice::struck(100, 1.5);
  evolve(lattice::ContactAware{0.05}, chain, state, 200, 200, lattice::Unobserved{});
  std::cout << "boundary share " << boundary_share(energy_density(chain, state)) << '\n';
}
