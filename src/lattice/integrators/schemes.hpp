#pragma once
/**
# The coefficients

Two families of time steppers share this file. *Splittings* alternate kicks (a change of the velocities at
fixed positions) and drifts (a change of the positions at fixed velocities); they are symplectic, which as
a rule keeps the energy error of a long run bounded. *Runge-Kutta-Nystrom schemes* combine accelerations
taken at several instants of a step of length $h$. Both are lists of numbers; integrate.hpp and
event_corrected.hpp say what is done with them. The tests measure every order claimed here: a scheme has order
$p$ if the error of a run of fixed duration falls like $h^p$. */

#include <cstddef>
#include <string>
#include <vector>

#include "lattice/numerics/ieee.hpp"

namespace lattice {

/**
A splitting is a list of pairs: kick by `kick[i]` h, then drift by `drift[i]` h. All of ours but one are
symmetric, so that a run is retraced if all velocities are reversed. A step ends with the kind of
operation with which the next one begins, and a run of many steps merges the two. `order` is that
on a smooth problem, without contacts that open or close. */
struct Scheme {
  std::string name;
  int order;
  std::vector<double> kick, drift;
};

/// Velocity Verlet: order 2, one force evaluation per step.
Scheme verlet();

/**
With order two, many digits cost many steps. The kinetic energy of a chain is quadratic in the
velocities, so that some of the errors of a splitting vanish by themselves. Blanes and Moan (J. Comput.
Appl. Math. 142, 2002, table 3) use the freedom that this leaves to make the others small: their
splittings need six force evaluations per step for order 4 and eleven for order 6. */

/// Blanes and Moan: order 4, six force evaluations per step.
Scheme blanes_moan_4();

/// Blanes and Moan (ibid.): order 6, eleven force evaluations per step.
Scheme blanes_moan_6();

/**
For the last digits the size of the error matters more than the cost of a step. The splitting with
fourteen evaluations (ibid., SRKN 14a) also has order 6, but smaller errors, and is chosen when more
than ten digits are asked for (refinement.hpp). It begins and ends with a drift; hence the first and last
kicks are zero. Only half of the coefficients are given; the rest follows because the scheme is
symmetric and its kicks, like its drifts, add up to one whole step. */
Scheme blanes_moan_6_14();

/**
The exception is the method of Calvo and Sanz-Serna (SIAM J. Sci. Comput. 14, 1993), which this field has often used.
It is symplectic but not symmetric. */
/// Calvo and Sanz-Serna: order 4, four force evaluations per step.
Scheme calvo_sanz_serna_4();

/**
The second family solves $\ddot y = g(y)$ from accelerations at several stages $Y_i$ of a step; $y$ and
$v$ are the positions and velocities at its start, $v'$ the velocities at its end:
$$Y_i = y + c_i h v + h^2 \sum_{j<i} a_{ij}\, g(Y_j), \qquad
v' = v + h \sum_i b_i\, g(Y_i).$$
We require that the first stage be the old state ($c = 0$) and the last one the new positions ($c = 1$).
A step then ends with the accelerations with which the next begins, and one evaluation is saved. */
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

/**
A splitting can be written as such a scheme, so that the treatment of contacts in event_corrected.hpp serves
both families. Kick $j$ changes the velocity by $h k_j g(Y_j)$ at time $c_j h$, and the drifts from there
to stage $i$ turn this into a change of position: $a_{ij} = k_j (c_i - c_j)$ and $b_j = k_j$. */
Nystrom nystrom(const Scheme& scheme);

}  // namespace lattice
