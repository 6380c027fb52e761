#pragma once
/**
# Does a shift grow before the breather has died?

A breather that loses energy slowly passes through the breathers of its branch. Its *area*
$\mathcal A = \oint\sum\mu_n\dot y_n^2\,dt$, 2$\pi$ times the action, is an adiabatic invariant, from which friction
takes the share $\nu$ per unit of time, whatever the potentials: $\mathcal A(t) = \mathcal A(0)\,e^{-\nu t}$. A small
shift $X$ along the chain obeys
$$\ddot X + \frac\nu4\,\dot X = \sigma^2 X,\qquad \sigma^2 = \sigma^2(\mathcal A(t)),$$
where $\sigma$ is the growth rate of the breather with this area. In the DpS limit, where $\mathcal
A\propto(\omega_b-1)^4$ and $\sigma = \Lambda(\omega_b-1)$, this is $X'' = \sigma(0)^2X$ in the time of the slow clock
(arrivals.hpp). We take it for the chain, too, where $\sigma^2$ changes its sign along the branch; a test
(`beyond/tests/sec5/arrivals.cpp`) finds the growth of a shift in a damped chain to a tenth. */

#include <vector>

#include "lattice/orbits/breather.hpp"

namespace lattice {

/// A breather of the branch in linear wells, with the growth rate of its translational pair.
struct BranchMember {
  double omega = 0, area = 0;
  double kappa = 0;   ///< of the translational pair (floquet.hpp), real if positive
  double growth = 0;  ///< per unit of time, zero if the pair is on the circle
  /// The multiplier per period that belongs to the growth.
  double multiplier() const;
};

/// The member of the branch at this frequency. `fine` takes the tightest tolerance of the flow, otherwise
/// one that is a thousand times looser.
BranchMember member_at(Centre centre, double omega, bool fine = true);

/**
What is smooth along the branch is $\sigma^2/(\omega_b-1)^2$; it is taken as a straight line in $\ln\mathcal A$
between neighbouring members, and in $\omega_b-1$ between the first one and the limit $\Lambda^2$. */
/// The largest |X| until a hundredth of the area is left, if X begins at one and at rest with the last of
/// `members`, in ascending order of their frequencies; `limit` is $\Lambda$.
double largest_shift(const std::vector<BranchMember>& members, double limit, double nu);

/// The shortest lifetime 1/nu for which that is `factor`. Throws std::invalid_argument on a stable branch.
double lifetime_of_growth(const std::vector<BranchMember>& members, double limit, double factor);

}  // namespace lattice
