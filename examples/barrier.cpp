// The energy barrier that a breather of frequency 1.1 has to pass on its way from bond to site.
#include <iostream>
#include "lattice/orbits/breather.hpp"

using namespace lattice;

int main() {
  const auto site = breather_problem(Centre::site, 1.1, Harmonic{}, 31);
  const auto bond = breather_problem(Centre::bond, 1.1, Harmonic{}, 32);
  const Barrier<double> gap = barrier(site, find_breather(site), find_breather(bond));
  std::cout << "at equal frequency " << gap.equal_frequency << ", at equal area "
            << gap.equal_action << '\n';
}
