#pragma once
/**
# Linear waves of a compressed chain

Contacts under a compression $d$ respond to small motions like springs. With $V$ of Eq. (33) and the
relative displacement $r = y_{n+1} - y_n$,
$$V'(r) = v_1 r + v_2 r^2 + v_3 r^3 + O(r^4), \qquad
  v_1 = \tfrac32 d^{1/2},\quad v_2 = -\tfrac38 d^{-1/2},\quad v_3 = -\tfrac1{16} d^{-3/2}.$$
Because of the linear part, waves $e^{i(qn - \omega t)}$ can travel, which are called phonons. Their
frequencies form a band, Eq. (34),
$$\omega^2(q) = 1 + 2 v_1 (1 - \cos q), \qquad 0 \le q \le \pi.$$
Two derivatives of $\omega$ matter later: the group velocity $c = \omega'$, with which packets travel, and
the curvature $\omega'' = v_1\omega_2/\omega$, with which they spread. The curvature vanishes at one
wavenumber $q_c$; there $c$ is largest, and nothing linear is faster.

Everything is a template on the scalar, `double` or `long double`, so that a formula evaluated in both
shows its own rounding error. */

namespace lattice {

/// Expansion coefficients v_1, v_2, v_3 of the contact about its compressed rest.
template <class T>
struct ContactSeries {
  T v1, v2, v3;
};

/// The coefficients for the compression `d`, from Eq. (33). Throws std::invalid_argument unless d > 0.
template <class T>
ContactSeries<T> contact_series(T d);

/**
A packet of wavenumber $q$ takes three numbers from the band: its frequency, the group velocity
$c = \omega'$ in sites per unit of time, and the scaled dispersion $\omega_2$, which together with a
nonlinear coefficient decides whether it is stable (nls.hpp). They are computed together. */
template <class T>
struct Phonon {
  T omega, group_velocity, omega_2;
  /// omega''(q).
  T curvature(T v1) const { return v1 * omega_2 / omega; }
};

/// The phonon of wavenumber `q`, Eq. (34) and its derivatives (text after Eq. (36)).
template <class T>
Phonon<T> phonon(T q, T v1);

/// Upper edge of the band, at q = pi; the lower one, at q = 0, is 1.
template <class T>
T upper_edge(T v1);

/**
The curvature vanishes at the inflection of the band, where $\cos q_c = v_1(1-\cos q_c)^2$. */
/// The wavenumber q_c of the inflection.
template <class T>
T inflection(T v1);

}  // namespace lattice
