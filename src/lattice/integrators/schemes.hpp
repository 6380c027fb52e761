#pragma once
/**
# The coefficients

*Splittings* alternate kicks (a change of the velocities at fixed positions) and drifts (a change of the positions at
fixed velocities); they are symplectic. *Runge-Kutta-Nystrom schemes* combine accelerations taken at several instants of
a step of length $h$. A scheme has order $p$ if the error of a run of fixed duration falls like $h^p$ on a smooth
problem, without contacts that open or close; the tests measure every order claimed here. */

#include <cstddef>
#include <string>
#include <vector>

#include "lattice/numerics/ieee.hpp"

namespace lattice {

/// Kick by `kick[i]` h, then drift by `drift[i]` h. A step ends with the kind of operation with which the next one
/// begins, and a run of many steps merges the two. All of ours are symmetric in time.
struct Scheme {
  std::string name;
  int order;
  std::vector<double> kick, drift;
};

/// Velocity Verlet: order 2, one force evaluation per step.
Scheme verlet();

/// Blanes and Moan (J. Comput. Appl. Math. 142, 2002, table 3): order 4, six force evaluations per step.
Scheme blanes_moan_4();

/// Blanes and Moan (ibid.): order 6, eleven force evaluations per step.
Scheme blanes_moan_6();

/// Blanes and Moan (ibid., SRKN 14a): order 6, fourteen force evaluations per step and smaller errors, for more than
/// ten digits. It begins and ends with a drift; hence the first and last kicks are zero.
Scheme blanes_moan_6_14();

/**
The second family solves $\ddot y = g(y)$ from accelerations at several stages $Y_i$ of a step; $y$ and
$v$ are the positions and velocities at its start, $v'$ the velocities at its end:
$$Y_i = y + c_i h v + h^2 \sum_{j<i} a_{ij}\, g(Y_j), \qquad
v' = v + h \sum_i b_i\, g(Y_i).$$
The first stage is the old state ($c = 0$) and the last one the new positions ($c = 1$), so that a step ends with
the accelerations with which the next begins. */
struct Nystrom {
  std::string name;
  int order;                           ///< on a smooth problem
  std::vector<double> c;               ///< times of the stages, from 0 to 1
  std::vector<std::vector<double>> a;  ///< row i has i entries; the last gives the new positions
  std::vector<double> b;               ///< weights of the new velocities
  /// The index of the stage that is the new state.
  std::size_t last() const { return c.size() - 1; }
};

/// Dormand, El-Mikkawy and Prince (IMA J. Numer. Anal. 7, 1987, pair 6(4) with six stages, the
/// last of which is shared by neighbouring steps): order 6, five force evaluations per step.
Nystrom dormand_prince_6();

/// A splitting as such a scheme. Kick $j$ changes the velocity by $h k_j g(Y_j)$ at time $c_j h$, and the drifts from
/// there to stage $i$ make a change of position: $a_{ij} = k_j (c_i - c_j)$ and $b_j = k_j$.
Nystrom nystrom(const Scheme& scheme);

}  // namespace lattice
