// A breather of frequency 1.1 around a site, by Newton's method, and how far it misses its own equations.
#include "lattice/orbits/breather.hpp"
#include <iostream>

using namespace lattice;

int main() {
  const auto problem = breather_problem(Centre::site, 1.1, Harmonic{}, 31);
  const Orbit<double> orbit = find_breather(problem);
  std::cout << "amplitude " << orbit.amplitude << ", energy " << orbit.energy << ", residual "
            << orbit.residual() << " after " << orbit.iterations() << " steps\n";
}
