#pragma once
/**
# Two beads collide

Section 3.5 measures the chain against the collision of two free beads, which touch for $2.43\,\tau_h$ and
are compressed by $0.76\,\delta$ (the scales are those of cantilever.hpp). We check both numbers. Bead 1
runs into bead 2, which is at rest, with $V = 1$, in units in which $m = \gamma = 1$. The masses are
equal, so the beads exchange their velocities, and after the contact bead 1 is at rest. Both beads have
then been carried along with the centre of mass, at the speed $V/2$, for the contact time $t_c$: bead 1
rests at $y_1 = t_c/2$. So $t_c$ can be read off without finding an event. The compression is largest at
$t_c/2$. */

namespace lattice {

/// Contact time and largest compression, in units of tau_h and delta (see cantilever.hpp).
struct Collision {
  double contact_time, compression;
};

/// The collision, integrated with steps of length `step` until t = 4, when it is over.
Collision collide(double step);

/**
Conservation of energy gives the same without integration in time. The relative motion carries
$\frac12\cdot\frac m2 V^2$, and all of it is in the contact when the compression is largest:
$\frac25\gamma\,x^{5/2} = \frac14 m V^2$, so $x = (5/8)^{2/5}\,\delta$. The contact time follows by a
quadrature of $1/\dot x$,
$$t = \frac{2x}{V}\int_0^1\frac{ds}{\sqrt{1-s^{5/2}}} = \frac{4\sqrt\pi}{5}\,
\frac{\Gamma(2/5)}{\Gamma(9/10)}\,\Bigl(\frac58\Bigr)^{2/5}\tau_h.$$ */
Collision collision_by_energy();

/**
Compared with such a collision a cradle's pendulum is very slow. With $k/m = g/L$ the ratio of the two
times enters as $\lambda^{5/2} = (L/(g\,\tau_h^2))^{5/2}$, Eqs. (29) and (30), and $\tau_h$ follows from
a contact time measured in seconds (`measured`) and the same time in units of $\tau_h$
(`contact_time`). */
double cradle_ratio(double gravity, double length, double measured, double contact_time);

}  // namespace lattice
