#include "sec4/dispersion.hpp"

#include <cmath>
#include <stdexcept>

namespace lattice {

template <class T>
ContactSeries<T> contact_series(T d) {
  using std::sqrt;
  if (!(d > T(0))) throw std::invalid_argument("a phonon band needs a compression d > 0");
  const T root = sqrt(d);
  return {T(3) / T(2) * root, -T(3) / T(8) / root, -T(1) / T(16) / (d * root)};
}

template <class T>
Phonon<T> phonon(T q, T v1) {
  using std::cos, std::sin, std::sqrt;
  const T square = T(1) + T(2) * v1 * (T(1) - cos(q)), omega = sqrt(square);
  return {omega, v1 * sin(q) / omega, cos(q) - v1 * sin(q) * sin(q) / square};
}

template <class T>
T upper_edge(T v1) {
  using std::sqrt;
  return sqrt(T(1) + T(4) * v1);
}

/**
The condition at the inflection is a quadratic equation for $x = 1 - \cos q_c$, and its positive root is
written so that nothing cancels: $x = 2/(1+\sqrt{1+4v_1})$. */
template <class T>
T inflection(T v1) {
  using std::acos, std::sqrt;
  return acos(T(1) - T(2) / (T(1) + sqrt(T(1) + T(4) * v1)));
}

// The scalars that are used
#define LATTICE_BAND(T)                        \
  template ContactSeries<T> contact_series(T); \
  template Phonon<T> phonon(T, T);             \
  template T upper_edge(T);                    \
  template T inflection(T);

LATTICE_BAND(double)
LATTICE_BAND(long double)

}  // namespace lattice
