#pragma once
/**
# A wave on a ring of equal beads

Near $x_n = A\cos(qn-t)$, it moves on by one site in the time $q$, so that symmetry alone makes the mean forces of all
contacts equal: the case that checks how they are averaged. In the guess neighbours are $2A\sin\frac q2$ apart, and of
the two forces on a bead there is the first harmonic only. */

#include <cmath>
#include <cstddef>
#include <numbers>

#include "lattice/orbits/shooting.hpp"

namespace lattice {

/// Newton's method where a motion may be shifted in time, along the chain or as a whole, which makes the matrix
/// singular: of all steps it takes the shortest.
inline const NewtonRule<double> shortest{.most_steps = 60, .damped = true, .rank = 1e-9};

/// Coefficient of cos t in (cos t)_+^(3/2), to three digits: good enough for a guess.
inline constexpr double harmonic = 0.457;

/// The wave on a ring of `sites` beads without wells; an orbit is the motion by one site.
inline Orbit<double> ring_wave(std::size_t sites, double q) {
  const Shooting<double> problem{{sites, None{}, PowerContact{1.5}, Ends::periodic},
                                 travelling(sites, 1, true),
                                 2 * std::numbers::pi / q};
  const double A = std::pow(harmonic * std::pow(2 * std::sin(q / 2), 2.5), -2);
  State<double> guess(sites);
  for (std::size_t n = 0; n < sites; ++n) {
    guess.y[n] = A * std::cos(q * double(n));
    guess.v[n] = A * std::sin(q * double(n));
  }
  return newton(problem, problem.reduce(guess), shortest);
}

}  // namespace lattice
