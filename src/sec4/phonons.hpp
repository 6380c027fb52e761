#pragma once
/**
# Phonons of a compressed chain, and their envelope

The formulas of section 4.1 for any compression $d$ and any anharmonicity $s$ of the wells. Everything is a template on
the scalar, `double` or `long double`, so that a formula evaluated in both shows its own rounding error. */

#include <cstddef>
#include <vector>

#include "lattice/numerics/ieee.hpp"

namespace lattice {

/// Coefficients of V'(r) = v_1 r + v_2 r^2 + v_3 r^3 + ..., the contact of Eq. (33) about its compressed rest.
template <class T>
struct ContactSeries {
  T v1, v2, v3;
};
/// For the compression `d`. Throws std::invalid_argument unless d > 0.
template <class T>
ContactSeries<T> contact_series(T d);

/// Frequency, group velocity in sites per unit of time, and scaled curvature.
template <class T>
struct Phonon {
  T omega, group_velocity, omega_2;
  /// omega''(q).
  T curvature(T v1) const { return v1 * omega_2 / omega; }
};
/// The phonon of wavenumber `q`, Eq. (34) and its derivatives.
template <class T>
Phonon<T> phonon(T q, T v1);
/// Upper edge of the band, at q = pi; the lower one, at q = 0, is 1.
template <class T>
T upper_edge(T v1);
/// The inflection q_c, where cos q_c = v_1 (1 - cos q_c)^2, the curvature vanishes and phonons are fastest.
template <class T>
T inflection(T v1);

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
T nls_beta(T q, const ContactSeries<T>& v, T s);

/// All that the NLS equation says about one wavenumber; phi = -beta omega_2 is that of Eq. (37).
template <class T>
struct Coefficients {
  T omega, group_velocity, curvature, beta, omega_2, phi;
  /// Of Eq. (36).
  T h() const { return beta / omega; }
};
/// The coefficients at wavenumber `q` for the compression `d` > 0 and the anharmonicity `s`.
template <class T>
Coefficients<T> coefficients(T q, T d, T s);

/**
On the wave $y_n = a\sin(qn-\omega t)$, that is $|A| = a/2$ with $\epsilon = 1$, a modulation of wavenumber $Q$ grows at
the rate $\sigma$ with $\sigma^2 = \tfrac12|\omega''|Q^2\,\bigl(2|h||A|^2 - \tfrac12|\omega''|Q^2\bigr)$, which is at
most $|h||A|^2$. */
/// The growth rate sigma of a wave of amplitude `a` at this wavenumber, zero if the wave is stable.
double nls_growth(const Coefficients<double>& at, double a, double modulation);
/// The modulation that grows fastest, at the rate |h| a^2 / 4; only where phi > 0.
double fastest_modulation(const Coefficients<double>& at, double a);

/// The unstable wavenumbers that fit on a ring, one in `every`, from the largest phi on.
std::vector<double> unstable_on_ring(double d, double s, std::size_t sites, std::size_t every = 1);

/// The zero of phi between `low` and `high`, by bisection, which does not use the closed form of the inflection.
/// Throws std::invalid_argument if phi has the same sign at both.
double sign_change_of_phi(double d, double s, double low, double high);

/// The largest value of phi on a grid of `points` + 1 wavenumbers from 0 to pi, or zero if all are negative.
double largest_phi(double d, double s, std::size_t points);

}  // namespace lattice
