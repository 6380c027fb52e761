#pragma once
/**
# Two beads collide, in closed form

Conservation of energy gives largest compression and contact time of two free beads without integration in time. The
relative motion carries $\frac12\cdot\frac m2 V^2$, and all of it is in the contact when the compression is largest:
$\frac25\gamma\,x^{5/2} = \frac14 m V^2$, so $x = (5/8)^{2/5}\,\delta$. The contact time follows by a quadrature of
$1/\dot x$,
$$t = \frac{2x}{V}\int_0^1\frac{ds}{\sqrt{1-s^{5/2}}} = \frac{4\sqrt\pi}{5}\,
\frac{\Gamma(2/5)}{\Gamma(9/10)}\,\Bigl(\frac58\Bigr)^{2/5}\tau_h.$$ */

namespace lattice {

/// Contact time and largest compression, in units of tau_h and delta (see cantilever.hpp).
struct Collision {
  double contact_time, compression;
};
Collision collision_by_energy();

/// lambda^(5/2) of the article's cradle, (L / (g tau_h^2))^(5/2), whose strings have half a metre and whose collisions
/// were measured to take 0.077 ms; for gravity in m/s^2 and the contact time in units of tau_h.
double cradle(double gravity, double contact_time);

}  // namespace lattice
