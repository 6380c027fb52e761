#include "lattice/integrators/schemes.hpp"

namespace lattice {

Scheme verlet() {
  return {"verlet", 2, {0.5, 0.5}, {1.0, 0.0}};
}

// The splittings of Blanes and Moan, palindromes all: they are symmetric in time
Scheme blanes_moan_4() {
  const double b1 = 0.0829844064174052, b2 = 0.396309801498368, b3 = -0.0390563049223486;
  const double a1 = 0.245298957184271, a2 = 0.604872665711080, a3 = 0.5 - (a1 + a2);
  const double b4 = 1 - 2 * (b1 + b2 + b3);
  return {"blanes-moan-4", 4, {b1, b2, b3, b4, b3, b2, b1}, {a1, a2, a3, a3, a2, a1, 0}};
}

Scheme blanes_moan_6() {
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

// Their most accurate one begins with a drift, which here follows a kick of zero
Scheme blanes_moan_6_14() {
  Scheme scheme{"blanes-moan-6-14",
                6,
                {0, 0.09171915262446165, 0.183983170005006, -0.05653436583288827,
                 0.004914688774712854, 0.143761127168358, 0.328567693746804},
                {0.0378593198406116, 0.102635633102435, -0.0258678882665587, 0.314241403071447,
                 -0.130144459517415, 0.106417700369543, -0.00879424312851058}};
  std::vector<double>&kick = scheme.kick, &drift = scheme.drift;
  // Kicks and drifts each add up to a whole step, which fixes the ones in the middle
  double kicks = 0.5, drifts = 1;
  for (double k : kick) kicks -= k;
  for (double d : drift) drifts -= 2 * d;
  kick.push_back(kicks);
  drift.push_back(drifts);
  // The way back mirrors the way there
  for (std::size_t i = 8; i-- > 0;) kick.push_back(kick[i]);
  for (std::size_t i = 7; i-- > 0;) drift.push_back(drift[i]);
  drift.push_back(0);
  return scheme;
}

// The last row gives the new positions, where the next step begins
Nystrom dormand_prince_6() {
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

// A kick acts on later positions through the time that the bead drifts from there
Nystrom nystrom(const Scheme& scheme) {
  const std::size_t stages = scheme.kick.size();
  Nystrom base{scheme.name, scheme.order, std::vector<double>(stages, 0), {}, scheme.kick};
  for (std::size_t i = 0; i < stages; ++i) {
    if (i > 0) base.c[i] = base.c[i - 1] + scheme.drift[i - 1];
    base.a.emplace_back(i);
    for (std::size_t j = 0; j < i; ++j) base.a[i][j] = scheme.kick[j] * (base.c[i] - base.c[j]);
  }
  return base;
}

}  // namespace lattice
