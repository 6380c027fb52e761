#pragma once
/**
# Phonons of a compressed chain, and the NLS equation of their envelope

The formulas of section 4.1 for any compression $d$ and any anharmonicity $s$ of the wells. They are templates on the
scalar, so that evaluating one in `double` and in `long double` shows its own rounding error. */

#include <cmath>
#include <stdexcept>

#include "lattice/numerics/ieee.hpp"

namespace lattice {

/// Coefficients of V'(r) = v_1 r + v_2 r^2 + v_3 r^3 + ..., the contact of Eq. (33) about its compressed rest.
template <class T>
struct ContactSeries {
  T v1, v2, v3;
};
/// For the compression `d`. Throws std::invalid_argument unless d > 0.
template <class T>
ContactSeries<T> contact_series(T d) {
  using std::sqrt;
  if (!(d > T(0))) throw std::invalid_argument("a phonon band needs a compression d > 0");
  const T root = sqrt(d);
  return {T(3) / T(2) * root, -T(3) / T(8) / root, -T(1) / T(16) / (d * root)};
}

/// Frequency, group velocity in sites per unit of time, scaled curvature omega omega''/v_1, and omega''.
template <class T>
struct Phonon {
  T omega, group_velocity, omega_2, curvature;
};
/// The phonon of wavenumber `q`, Eq. (34) and its derivatives.
template <class T>
Phonon<T> phonon(T q, T v1) {
  using std::cos, std::sin, std::sqrt;
  const T square = T(1) + T(2) * v1 * (T(1) - cos(q)), omega = sqrt(square);
  const T omega_2 = cos(q) - v1 * sin(q) * sin(q) / square;
  return {omega, v1 * sin(q) / omega, omega_2, v1 * omega_2 / omega};
}
/// The inflection q_c, where cos q_c = v_1 (1 - cos q_c)^2, a quadratic equation for 1 - cos q_c, written so that
/// nothing cancels. There the curvature vanishes and phonons are fastest.
template <class T>
T inflection(T v1) {
  using std::acos, std::sqrt;
  return acos(T(1) - T(2) / (T(1) + sqrt(T(1) + T(4) * v1)));
}

/**
Where does $\beta$ of Eq. (36) come from? Insert $A e^{i\theta} + A_2 e^{2i\theta} + c.c.$ with
$\theta = qn - \omega t$. The quadratic part of the contact force drives the second harmonic,
$$A_2 = \frac{4i\,v_2\sin q\,(1-\cos q)}{3 + 4v_1(1-\cos q)^2}\,A^2,$$
whose product with the first returns to the frequency $\omega$, together with the cubic parts of contact and well. (The
quadratic part also has a mean, but it is the same in every contact and so moves no bead.) At $e^{i\theta}$ the terms
balance if $\omega_{nl}^2 = \omega^2 + 2\beta|A|^2$ with
$$\beta = \frac{16v_2^2\sin^2q\,(1-\cos q)^2}{4v_1(1-\cos q)^2+3} + \tfrac32\left[4v_3(1-\cos q)^2 + s\right].$$ */
/// The NLS coefficient beta(q) for the well's anharmonicity s.
template <class T>
T nls_beta(T q, const ContactSeries<T>& v, T s) {
  using std::sin;
  const T half = sin(q / T(2)), x = T(4) * half * half * half * half;  // (1 - cos q)^2
  return T(16) * v.v2 * v.v2 * sin(q) * sin(q) * x / (T(4) * v.v1 * x + T(3)) +
         T(3) / T(2) * (T(4) * v.v3 * x + s);
}

/// All that the NLS equation says about one phonon; phi = -beta omega_2 is that of Eq. (37).
template <class T>
struct Coefficients : Phonon<T> {
  T beta, phi;
  /// Of Eq. (36).
  T h() const { return beta / this->omega; }
};
/// The coefficients at wavenumber `q` for the compression `d` > 0 and the anharmonicity `s`.
template <class T>
Coefficients<T> coefficients(T q, T d, T s) {
  const ContactSeries<T> v = contact_series(d);
  const Phonon<T> p = phonon(q, v.v1);
  const T beta = nls_beta(q, v, s);
  return {p, beta, -beta * p.omega_2};
}

}  // namespace lattice
