// A contact law of one's own: a layer that pushes like a Hertzian contact and stiffens when squeezed.
#include <cmath>
#include <iostream>
#include "lattice/impact/impact.hpp"

using namespace lattice;

struct Layer {
  double hardness = 4, exponent = 1.5;
  double opening() const { return 0; }
  double energy(double r) const {
    return r < 0 ? 0.4 * power(r, 2.5) + hardness / 3.5 * power(r, 3.5) : 0;
  }
  double force(double r) const { return r < 0 ? power(r, 1.5) + hardness * power(r, 2.5) : 0; }
  double stiffness(double r) const {
    return r < 0 ? 1.5 * power(r, 0.5) + 2.5 * hardness * power(r, 1.5) : 0;
  }
  static double power(double r, double alpha) { return std::pow(-r, alpha); }
};

int main() {
  const Chain chain{100, Harmonic{}, Layer{}};
  auto state = struck(100, 1.5);
  const Run run = evolve(EventCorrected{0.05}, chain, state, 200);
  std::cout << "energy drift " << run.energy_drift << '\n';
}
