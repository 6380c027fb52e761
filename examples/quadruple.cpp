// An orbit in quadruple precision: double finds it, and the wider type adds digits.
#include <iostream>
#include "lattice/orbits/breather.hpp"
#include "lattice/quadruple/orbits.hpp"

using namespace lattice;

int main() {
  const auto problem = breather_problem(Centre::site, 1.5, Harmonic{}, 21);
  const Orbit<double> orbit = find_breather(problem);
  NewtonRule<Quadruple> rule;
  rule.events.tolerance = Quadruple(1e-27);
  const auto wide = newton(in_precision<Quadruple>(problem), orbit, rule);
  std::cout.precision(25);
  std::cout << "energy " << wide.energy << ", residual " << wide.residual() << '\n';
}
