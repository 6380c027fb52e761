#pragma once
/**
# The coefficients

Two families of time steppers share this file: splittings, which alternate kicks and drifts
and are symplectic, and Runge-Kutta-Nystrom schemes, which combine accelerations taken at
several instants of a step. Both are lists of numbers; what is done with them is told in
integrate.hpp and contact_rkn.hpp. The tests measure every order that is claimed here. */

#include <cstddef>
#include <string>
#include <vector>

namespace lattice {

/**
A scheme is a list of pairs: kick by `kick[i]` h, then drift by `drift[i]` h. All are
symmetric, so that a run can be reversed by turning the velocities round. Because a
step ends with the operation with which the next one begins, a run of many steps
merges the two; `order` is the order on a smooth problem. */
struct Scheme {
  std::string name;
  int order;
  std::vector<double> kick, drift;
};

/// Velocity Verlet: one force evaluation a step, order 2.
inline Scheme verlet() {
  return {"verlet", 2, {0.5, 0.5}, {1.0, 0.0}};
}

/**
Order two asks for many steps wherever many digits are wanted. The kinetic energy of a chain is
quadratic in the velocities, so that some of the errors of a splitting vanish by themselves, and
Blanes and Moan (J. Comput. Appl. Math. 142, 2002, table 3) spend the freedom which this leaves on
making the others small: Runge-Kutta-Nystrom splittings with six evaluations of the force a step
for order 4 and eleven for order 6. */

/// Blanes and Moan: order 4, six force evaluations a step.
inline Scheme blanes_moan_4() {
  const double b1 = 0.0829844064174052, b2 = 0.396309801498368, b3 = -0.0390563049223486;
  const double a1 = 0.245298957184271, a2 = 0.604872665711080, a3 = 0.5 - (a1 + a2);
  const double b4 = 1 - 2 * (b1 + b2 + b3);
  return {"blanes-moan-4", 4, {b1, b2, b3, b4, b3, b2, b1}, {a1, a2, a3, a3, a2, a1, 0}};
}

/// Blanes and Moan (ibid.): order 6, eleven force evaluations a step.
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
For the last digits the size of the error counts more than the cost of a step: the splitting with
fourteen evaluations (ibid., SRKN 14a) has order 6, too, with smaller errors, and is what a
tolerance of more than ten digits selects (accuracy.hpp). It begins and ends with a drift, hence the
empty first and last kicks. One half of the coefficients is given; that the scheme is symmetric and
carries the state by one whole step fixes the rest. */
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
The base step is a Runge-Kutta-Nystrom scheme for $\ddot y = g(y)$. Its stages are
$$Y_i = y + c_i h v + h^2 \sum_{j<i} a_{ij}\, g(Y_j), \qquad
v' = v + h \sum_i b_i\, g(Y_i),$$
and we ask that the first one is the old state ($c = 0$) and the last one the new
positions ($c = 1$). Then a step ends with the accelerations with which the next begins. */
struct Nystrom {
  std::string name;
  int order;                           ///< on a smooth problem
  std::vector<double> c;               ///< times of the stages, from 0 to 1
  std::vector<std::vector<double>> a;  ///< row i has i entries; the last gives the new positions
  std::vector<double> b;               ///< weights of the new velocities
  std::size_t last() const { return c.size() - 1; }
};

/// Dormand, El-Mikkawy and Prince (IMA J. Numer. Anal. 7, 1987, pair 6(4) with six stages, the
/// last of which is shared by neighbouring steps): five force evaluations a step.
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
A splitting is such a scheme, too, so that the treatment of contacts serves both families: kick
$j$ changes the velocity by $h k_j g(Y_j)$ at time $c_j h$, drifts carry it to stage $i$, and so
$a_{ij} = k_j (c_i - c_j)$ and $b_j = k_j$. */
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
The best known method of all belongs here, too: where the forces do not depend on the velocities, the
classical Runge-Kutta method of order four is such a scheme, with a fifth stage of no weight for the
new positions. Whoever looks for the error of a computation that knew of no switchings needs it. */
inline Nystrom classical_runge_kutta() {
  return {"runge-kutta-4",
          4,
          {0, 1. / 2, 1. / 2, 1, 1},
          {{}, {0}, {1. / 4, 0}, {0, 1. / 2, 0}, {1. / 6, 1. / 6, 1. / 6, 0}},
          {1. / 6, 1. / 3, 1. / 3, 1. / 6, 0}};
}

}  // namespace lattice
