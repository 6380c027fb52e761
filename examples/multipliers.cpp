// Is a breather stable? The pair of multipliers that decides, in pendulum wells, with its error.
#include <iostream>
#include "lattice/orbits/breather.hpp"
#include "lattice/orbits/floquet.hpp"

using namespace lattice;

int main() {
  const auto problem = breather_problem(Centre::bond, 1.1, Pendulum{}, 32);
  const Orbit<double> orbit = find_breather(problem);
  const auto pairs = [&](double coarser) {
    EventTolerance<double> rule;
    rule.tolerance *= coarser;
    return floquet_pairs(problem.chain, orbit.start, orbit.period(), rule);
  };
  const MultiplierPair pinning = pairs_with_errors(pairs(16), pairs(1)).front();
  std::cout << "multipliers " << multiplier(pinning.kappa, -1) << " and "
            << multiplier(pinning.kappa, 1) << ", error " << pinning.multiplier_error() << '\n';
}
