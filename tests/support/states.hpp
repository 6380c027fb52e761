#pragma once
// Where runs of tests start and end.

#include <random>

#include "lattice/integrators/integrate.hpp"

/// Displacements and velocities of up to `size`, without any order; the same on every machine.
template <class T = double>
lattice::State<T> random_state(std::size_t sites, double size = 1, unsigned seed = 1) {
  std::mt19937_64 bits(seed);
  lattice::State<T> s(sites);
  for (auto* x : {&s.y, &s.v})
    for (T& value : *x) value = T(size * (double(bits() >> 11) * 0x1p-52 - 1));
  return s;
}

/// The state to which a method carries another one, `time` later.
inline lattice::State<double> after(const lattice::Method& method, const lattice::Chain& chain,
                                    lattice::State<double> s, double time) {
  s.t = 0;
  evolve(method, chain, s, time);
  return s;
}

/// Two wells with a hill between them, on whose top the beads rest: W''(0) = -1.
struct Hill {
  template <class T>
  T energy(T y) const {
    return y * y * (y * y / T(2) - T(1)) / T(2);
  }
  template <class T>
  T force(T y) const {
    return y * (T(1) - y * y);
  }
  template <class T>
  T stiffness(T y) const {
    return T(3) * (y * y) - T(1);
  }
};
