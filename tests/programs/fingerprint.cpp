// Prints the bits of a few runs. Built twice, with wide vectors and for the baseline processor.

#include <cstdint>
#include <cstdio>
#include <cstring>

#include "lattice/impact/impact.hpp"

using namespace lattice;

namespace {

template <class Stepper>
void show(const Stepper& method, const Chain& chain, State<double> state) {
  evolve(method, chain, state, 30);
  for (std::size_t n = 0; n < chain.sites; n += 1 + chain.sites / 40) {
    std::uint64_t bits;
    std::memcpy(&bits, &state.y[n], sizeof bits);
    std::printf("%016llx\n", static_cast<unsigned long long>(bits));
  }
}

void show(const Chain& chain, const State<double>& state) {
  show(Splitting{blanes_moan_6(), 0.05}, chain, state);
  show(EventCorrected{0.05}, chain, state);
  show(Splitting{verlet(), 0.05}, chain, state);
}

}  // namespace

int main() {
  show(Chain{50, Quartic{1}}, struck(50, 1.9));
  show(Chain{50, Pendulum{}}, struck(50, 2));
  State<double> wave(1000);
  for (std::size_t n = 0; n < 1000; ++n) wave.y[n] = 0.3 * std::sin(0.1 * double(n * n % 97));
  show(Chain{1000, Quartic{-0.2}, CompressedHertz{0.5}, Ends::periodic}, wave);
  show(Chain{1000, {}, {}, Ends::fixed}, wave);
  Chain varied{1000};
  std::vector<double> mass(1000, 1), eta(1001, 1);
  for (std::size_t n = 0; n < 1000; n += 7) mass[n] = 1.5, eta[n] = 0.8;
  vary(varied, mass, eta);
  show(varied, wave);
}
