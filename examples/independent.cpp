// The same impact twice, by our method and by GSL, and how far the two differ.
#include <iostream>
#include "lattice/gsl/reference.hpp"
#include "lattice/impact/impact.hpp"

using namespace lattice;

int main() {
  const Chain chain{20, Quartic{-1.0 / 6}};
  auto ours = struck(20, 1.5), theirs = ours;
  evolve(EventCorrected{0.01}, chain, ours, 10);
  evolve_reference(chain, theirs, 10, 1e-12);
  std::cout << "difference " << distance(ours, theirs) << '\n';
}
