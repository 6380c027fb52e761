#pragma once
/**
# How much energy the article's accuracies hide

The article prints two accuracies of one breather: the residual that Newton's method left and the last change of the
positions. Either allows some error of the energy. */

#include <cmath>
#include <cstddef>

#include "lattice/events/event_driven.hpp"
#include "lattice/orbits/breather.hpp"

namespace lattice {

/// An exact breather of another frequency leaves a residual after the period of the first, because its phase is off,
/// and has another energy. Both are proportional to the `detuning`: the energy where the residual is the given one.
inline double energy_of_residual(Shooting<double> problem, double residual, double detuning) {
  const Orbit<double> orbit = find_breather(problem);
  problem.omega += detuning;
  const Orbit<double> other = newton(problem, orbit.x);
  State<double> end = other.start;
  flow(problem.chain, end, orbit.period());
  const double left = largest_difference(end, other.start) / largest(other.start);
  return std::abs(other.energy - orbit.energy) * residual / left;
}

/// The energy, to first order, if every bead moves away from rest by `variation` times the amplitude.
inline double energy_of_variation(const Shooting<double>& problem, double variation,
                                  const NewtonRule<double>& rule) {
  const Orbit<double> orbit = find_breather(problem, Phase::compressed, rule);
  double slope = 0;
  for (std::size_t n = 0; n < orbit.start.y.size(); ++n)
    slope += std::abs(acceleration(problem.chain, orbit.start.y.data(), n));
  return slope * variation * orbit.amplitude;
}

}  // namespace lattice
