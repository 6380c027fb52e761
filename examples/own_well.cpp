// A well that the library does not know: three functions, and the chain of such wells is struck.
#include <cmath>
#include <iostream>
#include "lattice/impact/impact.hpp"

using namespace lattice;

/// W = cosh y - 1: stiffer and stiffer, like no polynomial.
struct Stiffer {
  double energy(double y) const { return 2 * std::pow(std::sinh(y / 2), 2); }
  double force(double y) const { return -std::sinh(y); }
  double stiffness(double y) const { return std::cosh(y); }
};

int main() {
  const Chain chain{100, Stiffer{}};
  auto state = struck(100, 1.5);
  const Run run = evolve(EventCorrected{0.05}, chain, state, 200);
  std::cout << "energy drift " << run.energy_drift << '\n';
}
