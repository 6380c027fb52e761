#pragma once
/**
# The coefficients

Two families of time steppers share this file. *Splittings* alternate kicks (a change of the velocities
at fixed positions) and drifts (a change of the positions at fixed velocities); they are symplectic,
which keeps the energy error of a long run bounded. *Runge-Kutta-Nystrom schemes* combine accelerations
taken at several instants of a step of length $h$. Both are lists of numbers; what is done with them
stands in integrate.hpp and contact_rkn.hpp. The tests measure every order claimed here: a scheme has
order $p$ if the error of a run of fixed duration falls like $h^p$. */

#include <cstddef>
#include <string>
#include <vector>

namespace lattice {

/**
A splitting is a list of pairs: kick by `kick[i]` h, then drift by `drift[i]` h. All of ours are
symmetric, so that a run is retraced if all velocities are reversed. A step ends with the kind of
operation with which the next one begins, and a run of many steps merges the two. `order` is that
on a smooth problem, without contacts that open or close. */
struct Scheme {
  std::string name;
  int order;
  std::vector<double> kick, drift;
};

/// Velocity Verlet: order 2, one force evaluation per step.
inline Scheme verlet() {
  return {"verlet", 2, {0.5, 0.5}, {1.0, 0.0}};
}

/**
With order two, many digits cost many steps. The kinetic energy of a chain is quadratic in the
velocities, so that some of the errors of a splitting vanish by themselves. Blanes and Moan (J. Comput.
Appl. Math. 142, 2002, table 3) use the freedom that this leaves to make the others small: their
splittings need six force evaluations per step for order 4 and eleven for order 6. */

/// Blanes and Moan: order 4, six force evaluations per step.
inline Scheme blanes_moan_4() {
  const double b1 = 0.0829844064174052, b2 = 0.396309801498368, b3 = -0.0390563049223486;
  const double a1 = 0.245298957184271, a2 = 0.604872665711080, a3 = 0.5 - (a1 + a2);
  const double b4 = 1 - 2 * (b1 + b2 + b3);
  return {"blanes-moan-4", 4, {b1, b2, b3, b4, b3, b2, b1}, {a1, a2, a3, a3, a2, a1, 0}};
}

/// Blanes and Moan (ibid.): order 6, eleven force evaluations per step.
inline Scheme blanes_moan_6() {
  const double b1 = 0.0414649985182624, b2 = 0.198128671918067, b3 = -0.0400061921041533;
  const double b4 = 0.0752539843015807, b5 = -0.0115113874206879;
  const double b6 = 0.5 - (b1 + b2 + b3 + b4 + b5);
  const double a1 = 0.123229775946271, a2 = 0.290553797799558, a3 = -0.127049212625417;
  const double a4 = -0.246331761062075, a5 = 0.357208872795928;
  const double a6 = 1 - 2 * (a1 + a2 + a3 + a4 + a5);
  return {"blanes-moan-6",
          6,
          {b1, b2, b3, b4, b5, b6, b6, b5, b4, b3, b2, b1},
          {a1, a2, a3, a4, a5, a6, a5, a4, a3, a2, a1, 0}};
}

/**
For the last digits the size of the error matters more than the cost of a step. The splitting with
fourteen evaluations (ibid., SRKN 14a) also has order 6, but smaller errors, and is chosen when more
than ten digits are asked for (accuracy.hpp). It begins and ends with a drift; hence the first and last
kicks are zero. Only half of the coefficients are given; the rest follows because the scheme is
symmetric and its kicks, like its drifts, add up to one whole step. */
inline Scheme blanes_moan_6_14() {
  Scheme scheme{"blanes-moan-6-14",
                6,
                {0, 0.09171915262446165, 0.183983170005006, -0.05653436583288827,
                 0.004914688774712854, 0.143761127168358, 0.328567693746804},
                {0.0378593198406116, 0.102635633102435, -0.0258678882665587, 0.314241403071447,
                 -0.130144459517415, 0.106417700369543, -0.00879424312851058}};
  std::vector<double>&kick = scheme.kick, &drift = scheme.drift;
  double kicks = 0.5, drifts = 1;
  for (double k : kick) kicks -= k;
  for (double d : drift) drifts -= 2 * d;
  kick.push_back(kicks);
  drift.push_back(drifts);
  for (std::size_t i = 8; i-- > 0;) kick.push_back(kick[i]);
  for (std::size_t i = 7; i-- > 0;) drift.push_back(drift[i]);
  drift.push_back(0);
  return scheme;
}

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
  std::size_t last() const { return c.size() - 1; }
};

/// Dormand, El-Mikkawy and Prince (IMA J. Numer. Anal. 7, 1987, pair 6(4) with six stages, the
/// last of which is shared by neighbouring steps): order 6, five force evaluations per step.
inline Nystrom dormand_prince_6() {
  return {"dormand-prince-6",
          6,
          {0, 1. / 10, 3. / 10, 7. / 10, 17. / 25, 1},
          {{},
           {1. / 200},
           {-1. / 2200, 1. / 22},
           {637. / 6600, -7. / 110, 7. / 33},
           {225437. / 1968750, -30073. / 281250, 65569. / 281250, -9367. / 984375},
           {151. / 2142, 5. / 116, 385. / 1368, 55. / 168, -6250. / 28101}},
          {151. / 2142, 25. / 522, 275. / 684, 275. / 252, -78125. / 112404, 1. / 12}};
}

/**
A splitting can be written as such a scheme, so that the treatment of contacts in contact_rkn.hpp serves
both families. Kick $j$ changes the velocity by $h k_j g(Y_j)$ at time $c_j h$, and the drifts from there
to stage $i$ turn this into a change of position: $a_{ij} = k_j (c_i - c_j)$ and $b_j = k_j$. */
inline Nystrom nystrom(const Scheme& scheme) {
  const std::size_t stages = scheme.kick.size();
  Nystrom base{scheme.name, scheme.order, std::vector<double>(stages, 0), {}, scheme.kick};
  for (std::size_t i = 0; i < stages; ++i) {
    if (i > 0) base.c[i] = base.c[i - 1] + scheme.drift[i - 1];
    base.a.emplace_back(i);
    for (std::size_t j = 0; j < i; ++j) base.a[i][j] = scheme.kick[j] * (base.c[i] - base.c[j]);
  }
  return base;
}

/**
The best-known method of all is among them: if the forces do not depend on the velocities, the classical
Runge-Kutta method of order four is such a scheme, with a fifth stage of zero weight for the new
positions. We need it to find the errors of a computation that took no notice of opening contacts. */
inline Nystrom classical_runge_kutta() {
  return {"runge-kutta-4",
          4,
          {0, 1. / 2, 1. / 2, 1, 1},
          {{}, {0}, {1. / 4, 0}, {0, 1. / 2, 0}, {1. / 6, 1. / 6, 1. / 6, 0}},
          {1. / 6, 1. / 3, 1. / 3, 1. / 6, 0}};
}

}  // namespace lattice
