#pragma once
/**
# Shooting by leapfrog

Far from any orbit the motions that Newton's method asks for are wild, and to end a step at every contact event
(event_driven.hpp) costs much for nothing. A search is better served by leapfrog steps of fixed
length $h$,
$$y \leftarrow y + \tfrac h2 v,\qquad v \leftarrow v + h\,a(y),\qquad y \leftarrow y + \tfrac h2 v,$$
with $a(y)$ the accelerations, and by the exact derivative of these steps. Orbits of this map at frequency
$\omega$ have a relative error of the order $(\omega h)^2/24$; what a search finds is a guess for the
exact flow. The averaging argument of section 2 carries over to the map: on an orbit the kicks of each bead
add up to zero over a period, as the integral of the force does. */

#include <functional>

#include "lattice/orbits/shooting.hpp"

namespace lattice {

/// Unknowns and equations are measured in units of the fixed number `scale`, so that a search whose orbit shrinks
/// to nothing ends there, at rest.
struct LeapfrogShooting : Shooting<double> {
  double scale = 1;
  int steps = 128;  ///< per period; a multiple of the symmetry's parts

  /// The equations of shooting.hpp with these steps, for Newton's method.
  Equations<double> equations() const;
  Evaluation<double> evaluate(const Vector<double>& x, bool with_jacobian = true) const;
  /// Advances a state and its tangent, if there is one, by `count` steps and shows each to `watch(z)`.
  void advance(State<double>& z, Tangent<double>* tangent, int count,
               const std::function<void(const State<double>&)>& watch) const;
};

}  // namespace lattice
