#pragma once
// Whether a periodic orbit is one, by the event-driven flow.

#include <algorithm>

#include "lattice/orbits/shooting.hpp"

/// Largest difference from the start after one period and, on a ring, a shift back by `shift` sites, over the
/// amplitude.
inline double return_error(const lattice::Shooting<double>& problem,
                           const lattice::Orbit<double>& orbit, long shift = 0) {
  lattice::State<double> end = orbit.start;
  flow(problem.chain, end, orbit.period());
  for (auto* x : {&end.y, &end.v}) std::rotate(x->begin(), x->begin() + shift, x->end());
  return largest_difference(end, orbit.start) / orbit.amplitude;
}
