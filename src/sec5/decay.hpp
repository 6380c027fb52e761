#pragma once
/**
# A static breather that dies

A breather at rest loses its energy to friction. If that happens slowly it should pass through the breathers
of its family, one after the other, its frequency following its amplitude. Linear friction makes this exact
in one respect: the area $\mathcal A = \oint\sum\mu_n\dot y_n^2\,dt$ of an orbit is an adiabatic invariant,
and friction takes the share $\nu$ of it per unit of time, whatever the potentials,
$$\mathcal A(t) = \mathcal A(0)\,e^{-\nu t}.$$
A weak instability with the growth rate $\sigma(\mathcal A)$ has the time that the breather lives, and
multiplies a small deviation by $e^G$ with
$$G = \int_0^\infty\sigma\,dt = \frac1\nu\int_0^{\mathcal A(0)}\sigma\,\frac{d\mathcal A}{\mathcal A}.$$
Friction of the deviation itself plays no part, since the breather shrinks as fast. In the DpS limit
$\sigma = \Lambda(\omega_b-1)$ and $\mathcal A\propto(\omega_b-1)^4$, hence $G = 4\sigma/\nu$: four
lifetimes, as the slow clock of journey.hpp says. */

#include <cstddef>
#include <vector>

#include "lattice/orbits/breather.hpp"
#include "lattice/orbits/floquet.hpp"
#include "sec5/bench.hpp"

namespace lattice {

/// A breather of the branch in the well of anharmonicity s, with the growth rate of its pinning pair.
struct Member {
  double omega = 0, energy = 0, area = 0;
  double kappa = 0;   ///< of the pinning pair (floquet.hpp); unstable if positive
  double growth = 0;  ///< per unit of time, zero if stable
  /// The multiplier per period that belongs to the growth.
  double multiplier() const;
};

/// The breather with this centre and frequency.
Orbit<double> breather_at(Centre centre, double omega, double s = 0);

/// The member of the branch at this frequency. `fine` takes the tightest tolerance of the flow, otherwise
/// one that is a thousand times looser.
Member member_at(Centre centre, double omega, double s, bool fine = true);

/**
Breathers around sites and bonds exchange their stability again and again along the branch, so that only
stretches of it count in $G$. What is smooth is $\pm\sigma^2/(\omega_b-1)^2$, positive where the breather is
unstable; it is taken as a straight line between neighbouring members, and below the first one between that
and its limit $\Lambda^2$ of the DpS equation (spectrum.hpp). */
/// $\Lambda$ of the DpS breather, zero if it is stable.
double dps_growth(Centre centre);

/// $\nu G$ of a breather that starts at the last of `members`, in ascending order of their frequencies, with
/// the `limit` $\Lambda$.
double growth_times_rate(const std::vector<Member>& members, double limit);

/**
What a decaying breather does is read from one bead: its upward passages through zero make periods; frequency
and energy are means over eight of them. */
struct DecayMoment {
  double t, omega, energy;  ///< t: middle of the eight periods
};

/// The life of a breather with losses.
struct Decay {
  std::vector<DecayMoment> moments{};  ///< one for each period, over the eight that follow
  double drift = 0;                    ///< of the energy centre from start to end, in sites
  double ledger = 0;                   ///< see run_bench
};

/// Lets a breather of this orbit decay at the rate `nu` for the time `duration`.
Decay let_decay(const Orbit<double>& orbit, const Chain& chain, double nu, double duration,
                double step);

}  // namespace lattice
