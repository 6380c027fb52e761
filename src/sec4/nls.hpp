#pragma once
/**
# Weakly nonlinear waves: the NLS equation

A phonon of small amplitude (dispersion.hpp), $y_n = \epsilon A e^{i(qn-\omega t)} + c.c.$ (Eq. (35)),
has a slowly varying envelope $A(\tau,\xi)$ in $\tau = \epsilon^2t$ and $\xi = \epsilon(n-ct)$, which
obeys the nonlinear Schrödinger (NLS) equation, Eq. (36),
$$i\,\partial_\tau A = -\tfrac12\omega''(q)\,\partial_\xi^2 A + h|A|^2A, \qquad h = \beta/\omega.$$
Where does $\beta$ come from? Insert $A e^{i\theta} + A_2 e^{2i\theta} + c.c.$ with
$\theta = qn - \omega t$. The quadratic part of the contact force drives the second harmonic,
$$A_2 = \frac{4i\,v_2\sin q\,(1-\cos q)}{3 + 4v_1(1-\cos q)^2}\,A^2,$$
whose product with the first returns to the frequency $\omega$, together with the cubic parts of contact
and well. (The quadratic part also has a mean, but it is the same in every contact and so moves no bead.)
At $e^{i\theta}$ the terms balance if $\omega_{nl}^2 = \omega^2 + 2\beta|A|^2$ with
$$\beta = \frac{16v_2^2\sin^2q\,(1-\cos q)^2}{4v_1(1-\cos q)^2+3} +
  \tfrac32\left[4v_3(1-\cos q)^2 + s\right].$$ */

#include <cstddef>
#include <vector>

#include "sec4/dispersion.hpp"

namespace lattice {

/// NLS coefficient beta(q) for the well's anharmonicity s (text after Eq. (36)).
template <class T>
T nls_beta(T q, const ContactSeries<T>& v, T s);

/**
Whether a wave survives is a question of signs. A uniform wave is unstable against slow modulations if
$\omega''h < 0$, that is if $\Phi = -\beta\,\omega_2 > 0$, Eq. (37). We keep in one place all that the NLS
equation says about one wavenumber. */
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
How fast does the instability grow? On the wave $y_n = a\sin(qn-\omega t)$, that is $|A| = a/2$ with
$\epsilon = 1$, a modulation of wavenumber $Q$ grows at the rate $\sigma(Q)$ with
$$\sigma^2 = \tfrac12|\omega''|Q^2\,\bigl(2|h||A|^2 - \tfrac12|\omega''|Q^2\bigr),$$
which is at most $|h||A|^2$. */
/// The growth rate sigma of a wave of amplitude `a` at this wavenumber, zero if the wave is stable.
template <class T>
T nls_growth(const Coefficients<T>& at, T a, T modulation);

/// The modulation that grows fastest, at the rate |h| a^2 / 4; only where phi > 0.
template <class T>
T fastest_modulation(const Coefficients<T>& at, T a);

/**
Where the instability begins is a zero of $\Phi$. Bisection finds it between two wavenumbers without
using the closed form of the inflection, so that one can check the other. */
/// The zero of phi between the wavenumbers `low` and `high`. Throws std::invalid_argument if phi has the
/// same sign at both.
double sign_change_of_phi(double d, double s, double low, double high);

/**
Both factors of $\Phi$ can change sign, $\omega_2$ at the inflection and $\beta$ wherever the well outweighs the
contact or no longer does. So the unstable wavenumbers may be one interval, or several, or none, and any of them may be
narrow. None is lost if we know all zeros. That of $\omega_2$ has a closed form, and with $x = 1-\cos q$ those of $\beta$
are the zeros of a polynomial,
$$\tfrac{2d}9\,(4v_1x^2+3)\,\beta = -x^4 + x^3 + \bigl(2sd^{3/2}-\tfrac14d^{-1/2}\bigr)x^2 + sd,$$
of which three stationary points are known, one of them at $x = 0$. */
/// Wavenumbers from `from` to `to`, in 1/site.
template <class T>
struct Wavenumbers {
  T from, to;
};

/// The intervals between 0 and pi in which phi is positive.
template <class T>
std::vector<Wavenumbers<T>> unstable_wavenumbers(T d, T s);

/// The largest value of phi on a grid of `points` + 1 wavenumbers from 0 to pi, or zero if all are
/// negative.
double largest_phi(double d, double s, std::size_t points);

}  // namespace lattice
