// A hundred impacts on all cores: how much of the energy stays at the end, against the velocity.
#include <iostream>
#include <vector>
#include "lattice/impact/impact.hpp"
#include "lattice/numerics/parallel.hpp"

using namespace lattice;

int main() {
  std::vector<double> share(100);
  parallel_for(share.size(), [&](std::size_t i) {
    const Chain chain{100, Pendulum{}};
    auto state = struck(100, 0.02 * double(i + 1));
    evolve(EventCorrected{0.1}, chain, state, 200);
    share[i] = boundary_share(energy_density(chain, state));
  });
  for (std::size_t i = 9; i < share.size(); i += 10) std::cout << share[i] << '\n';
}
