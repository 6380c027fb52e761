#pragma once
// Whether a periodic orbit is one, by the event-driven flow.

#include "lattice/orbits/shooting.hpp"

/// Largest difference from the start after one period, over the amplitude.
inline double return_error(const lattice::Shooting<double>& problem,
                           const lattice::Orbit<double>& orbit) {
  lattice::State<double> end = orbit.start;
  flow(problem.chain, end, orbit.period());
  return largest_difference(end, orbit.start) / orbit.amplitude;
}
