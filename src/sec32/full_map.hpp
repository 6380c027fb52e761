#pragma once
/**
# The period map without symmetry

A breather returns after a whole period, $Y(T_b) = Y(0)$, where $Y$ holds all positions and velocities. This is what the
article demands and what its residual measures, the distance from $Y(0)$ to $Y(T_b)$ relative to $Y(0)$. Symmetries of the
breather lead to fewer equations (symmetry.hpp); here are the full ones, twice as many as unknowns, which are solved in the
sense of least squares.

A shift along the chain hardly violates them: the smallest singular value of their matrix belongs to a change of the
positions that moves the breather sideways. Along this mode the problem is ill-conditioned. */

#include "lattice/orbits/breather.hpp"
#include "lattice/orbits/breather_pairs.hpp"

namespace lattice {

/// The article's residual, in precision T.
template <class T>
T distance_after_period(const Shooting<double>& problem, const State<double>& start) {
  const auto wide = in_precision<T>(problem);
  State<T> begin(start.y.size());
  for (std::size_t n = 0; n < start.y.size(); ++n) begin.y[n] = T(start.y[n]);
  State<T> end = begin;
  flow(wide.chain, end, wide.period());
  return largest_difference(end, begin) / largest(begin);
}

/// Newton's iterations, where they end, and the least singular vector there.
struct FullMap {
  History history{};
  Vector<double> x{};
  Softness soft{};
};

/**
To see the drift along this mode we make the article's iterations one by one: integrate over the whole period,
solve, step. */
/// For the site-centred breather of frequency `omega_b`, from the quasi-continuum profile. Directions below `how.rank`
/// are left alone.
FullMap solve_full_map(double omega_b, int steps, const NewtonRule<double>& how = rule<double>(0));

}  // namespace lattice
