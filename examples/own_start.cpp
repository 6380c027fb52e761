// A start of one's own: a modulated wave on a ring with a light bead, and a number with its error.
#include <iostream>
#include <numbers>
#include <vector>
#include "lattice/integrators/refinement.hpp"

using namespace lattice;

constexpr std::size_t beads = 200;

struct Result {
  State<double> end;
  Run run;
};

Result after(double time, const EventCorrected& method) {
  Chain ring{beads, Quartic{-1.0 / 6}, Hertz{}, Ends::periodic};
  std::vector<double> mass(beads, 1);
  mass[99] = 0.5;
  vary(ring, mass, {});  // masses; then stiffnesses of the contacts, or none
  State<double> start(beads);
  for (std::size_t n = 0; n < beads; ++n)
    start.y[n] = 0.1 * (n % 2 ? -1 : 1) * std::sin(std::numbers::pi * double(n) / beads);
  Result out{start, {}};
  out.run = evolve(method, ring, out.end, time, Every{1});
  return out;
}

int main() {
  const auto runs = refined(1e-8, [](const EventCorrected& method) { return after(50, method); });
  const Estimate y = runs.of([](const Result& result) { return result.end.y[99]; });
  std::cout << "the light bead is at " << y.value << " +- " << y.error << '\n';
}
