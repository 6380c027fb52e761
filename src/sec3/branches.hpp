#pragma once
/**
# Branches from rest

A family of breathers is a branch of periodic orbits that bifurcates from the chain at rest. */

#include <cmath>

#include "lattice/orbits/breather_pairs.hpp"

namespace lattice {

/// The exponent of the amplitude in omega_b - 1 between two breathers: two near a bifurcation from rest, by Eq. (20),
/// zero where a family begins at a finite amplitude.
inline double growth_exponent(const Orbit<double>& lower, const Orbit<double>& upper) {
  return std::log(upper.amplitude / lower.amplitude) /
         std::log((upper.omega - 1) / (lower.omega - 1));
}

}  // namespace lattice
