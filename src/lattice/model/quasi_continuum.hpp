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

/// (-1)^n times the two envelopes on either side of site `n`.
template <class T, class Envelope>
T staggered(Centre centre, long n, Envelope g) {
  const T x = centre == Centre::bond ? T(n) : T(n) + T(0.5);
  const T u = g(x) + g(x - T(1));
  return n % 2 == 0 ? u : T(0) - u;
}

/// Quasi-continuum profile u_n at mu = 1; for other mu it is mu^2 times as large.
template <class T = double>
T quasi_continuum(Centre centre, long n) {
  return staggered<T>(centre, n, [](const T& x) { return quasi_continuum_envelope<T>(x); });
}

/**
The article speaks of spheres. With another exponent $\alpha > 1$ of the contact force the same equation
$4g + g'' = g^{1/\alpha}$ has the solution $g(x) = \bigl(\frac{m}{4(m-1)}\bigr)^{m/2}\cos^m(2x/m)$ for
$|x| \le \pi m/4$ with $m = 2\alpha/(\alpha-1)$, which is six for spheres. */
/// The profile at mu = 1 for contacts of exponent `alpha` > 1; for other mu it is mu^{1/(alpha-1)} times as
/// large.
inline double quasi_continuum(Centre centre, long n, double alpha) {
  const double m = 2 * alpha / (alpha - 1), size = std::pow(m / (4 * (m - 1)), m / 2);
  return staggered<double>(centre, n, [&](double x) {
    return std::abs(x) < std::numbers::pi * m / 4 ? size * std::pow(std::cos(2 * x / m), m) : 0.0;
  });
}

}  // namespace lattice
