// Strikes a chain of 100 beads and prints how much of the energy stays at its end. Core only.
#include <iostream>
#include "lattice/measure/impact.hpp"

using namespace lattice;

int main() {
  const Chain<Quartic, Hertz> chain{100, {-1.0 / 6}};
  auto state = struck(100, 1.5);
  evolve(ContactAware{0.05}, chain, state, 200, 200, Unobserved{});
  std::cout << "boundary share " << boundary_share(energy_density(chain, state)) << '\n';
}
