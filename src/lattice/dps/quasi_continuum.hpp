#pragma once
/**
# The profile of a small breather, approximately

The article derives an approximation of the stationary states of the DpS equation (stationary.hpp) by
treating the envelope of the alternating $D_n$ as a function of a continuous variable, Eqs. (15) to (17):
$g(x) = (3/10)^3\cos^6(x/3)$ for $|x| \le 3\pi/2$ and zero elsewhere. At $\mu = 1$ this gives
$u_n = (-1)^n[g(n)+g(n-1)]$ around a bond, Eq. (18), and $u_n = (-1)^n[g(n+\frac12)+g(n-\frac12)]$ around a
site, Eq. (19). Computations of stationary states and of breathers start from it. */

#include <cmath>
#include <numbers>

#include "lattice/model/sites.hpp"

namespace lattice {

/// The envelope g(x).
template <class T>
T quasi_continuum_envelope(T x) {
  using std::abs;
  using std::cos;
  if (!(abs(x) < T(3) * std::numbers::pi_v<double> / T(2))) return T(0);
  const T c = cos(x / T(3)), c3 = c * c * c;
  return T(27) / T(1000) * c3 * c3;
}

/// Quasi-continuum profile u_n at mu = 1; for other mu it is mu^2 times as large.
template <class T = double>
T quasi_continuum(Centre centre, long n) {
  const T x = centre == Centre::bond ? T(n) : T(n) + T(0.5);
  const T u = quasi_continuum_envelope<T>(x) + quasi_continuum_envelope<T>(x - T(1));
  return n % 2 == 0 ? u : T(0) - u;
}

}  // namespace lattice
