#pragma once
/**
# Solitary waves of a dimer chain

In a chain of heavy and light beads without wells, masses $1$ and $\mu$, a pulse leaves the light beads oscillating
behind it and loses energy, except at particular mass ratios. There it is a solitary wave: the heavy beads move like
$X(t-nT)$, the light ones like $Z(t-nT)$, and behind the pulse all are at rest again, equally displaced.

Let $G(t)$ be the force of a heavy bead on the light one in front of it. The wave has a centre of symmetry, the instant
$t = 0$ at which the heavy bead is fastest, and reversing the time about it shows that the light bead pushes back on the
heavy one behind with $G$, and on the next heavy bead with $G(T-t)$. So
$$\ddot X = G(-t)-G(t),\qquad \mu\ddot Z = G(t)-G(T-t),\qquad G = (X-Z)_+^{3/2},$$
with all at rest before. Behind the wave both beads have the same displacement if and only if
$$2\mu\int t\,G\,dt = T\int G\,dt - 2\int t\,G\,dt .$$
The values of $G$ on a grid and $\mu$ are the unknowns of as many equations; $T$ only fixes the units. Integrating
twice with Numerov's weights makes the error fall with the fourth power of the grid's step until the force's own
kinks show. */

#include <cstddef>
#include <vector>

namespace lattice {

/// The force `G` on the grid t = (j - middle) T / `steps`, and the mass ratio.
struct DimerWave {
  double mass_ratio = 0;
  double period = 0;      ///< T, from one heavy bead to the next
  std::size_t steps = 0;  ///< of the grid in T
  std::vector<double> force{};
};

/// A first guess: the pulse in a struck chain with masses 1 and `mass_ratio`, far from the impact.
DimerWave passing_pulse(double mass_ratio, std::size_t steps);

/// The solitary wave near `guess`, by Newton's method. Throws std::runtime_error if it does not converge.
DimerWave dimer_wave(DimerWave guess);

}  // namespace lattice
