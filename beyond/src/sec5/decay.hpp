#pragma once
/**
# A static breather that dies

A breather at rest loses its energy to friction. If that happens slowly it should pass through the breathers
of its family, one after the other, its frequency following its amplitude. Linear friction makes this exact
in one respect: the area $\mathcal A = \oint\sum\mu_n\dot y_n^2\,dt$ of an orbit is an adiabatic invariant,
and friction takes the share $\nu$ of it per unit of time, whatever the potentials,
$$\mathcal A(t) = \mathcal A(0)\,e^{-\nu t}.$$
A weak instability has the time that the breather lives. In the DpS limit, where $\mathcal A\propto(\omega_b-1)^4$
and the growth rate is $\sigma = \Lambda(\omega_b-1)$, a small shift $X$ along the chain grows by the slow clock of
arrivals.hpp like $e^{\sigma(0)s}$, so that it has four lifetimes. At the time $t$ this is
$$\ddot X + \frac\nu4\,\dot X = \sigma^2 X,\qquad \sigma = \sigma(\mathcal A(t)),$$
which we take for the chain, too. There $\sigma^2$ changes its sign along the branch, and where it is negative the
shift swings back. The friction $\nu/4$ is that of the limit; tests/damped.cpp finds the growth of a shift in a
damped chain to a tenth. */

#include <vector>

#include "lattice/orbits/breather.hpp"
#include "lattice/orbits/floquet.hpp"

namespace lattice {

/// A breather of the branch in the well of anharmonicity s, with the growth rate of its translational pair.
struct Member {
  double omega = 0, area = 0;
  double kappa = 0;   ///< of the translational pair (floquet.hpp), real if positive
  double growth = 0;  ///< per unit of time, zero if the pair is on the circle
  /// The multiplier per period that belongs to the growth.
  double multiplier() const;
};

/// The breather with this centre and frequency.
Orbit<double> breather_at(Centre centre, double omega, double s = 0);

/// The member of the branch at this frequency. `fine` takes the tightest tolerance of the flow, otherwise
/// one that is a thousand times looser.
Member member_at(Centre centre, double omega, double s, bool fine = true);

/**
What is smooth along the branch is $\sigma^2/(\omega_b-1)^2$; it is taken as a straight line in $\ln\mathcal A$
between neighbouring members, and in $\omega_b-1$ between the first one and the limit $\Lambda^2$ of the DpS
equation (spectrum.hpp). */
/// $\Lambda$ of the DpS breather, zero if it has none.
double dps_growth(Centre centre);

/// The largest |X| until a hundredth of the area is left, if X begins at one and at rest with the last of
/// `members`, in ascending order of their frequencies; `limit` is $\Lambda$.
double largest_shift(const std::vector<Member>& members, double limit, double nu);

/// The shortest lifetime 1/nu for which that is `factor`.
double lifetime_of_growth(const std::vector<Member>& members, double limit, double factor);

/**
What a decaying breather does is read from one bead: its upward crossings through zero make periods; frequency
and energy are means over eight of them. */
struct DecayMoment {
  double t, omega, energy;  ///< t: middle of the eight periods
  double centre;  ///< of the energy, in sites from one, with half of a contact on either side
};

/// The life of a breather with losses: one moment for each period, over the eight that follow.
using Decay = std::vector<DecayMoment>;

/// Lets a breather of this orbit decay at the rate `nu` for the time `duration`.
Decay let_decay(const Orbit<double>& orbit, const Chain& chain, double nu, double duration,
                double step);

}  // namespace lattice
