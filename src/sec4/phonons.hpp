#pragma once
/**
# Phonons of a compressed chain, and the NLS equation of their envelope

The formulas of section 4.1 for any compression $d$ and any anharmonicity $s$ of the wells. They have no step to halve, but
they have rounding errors, so they are templates on the scalar, to be evaluated in `double` and in `long double`. */

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <numbers>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "lattice/numerics/estimate.hpp"

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

/**
Both factors of $\Phi$ can change sign, so the unstable wavenumbers may be one interval, or several, or none. None is
lost if we know all zeros. That of $\omega_2$ has a closed form, and with $x = 1-\cos q$ those of $\beta$ are the zeros
of
$$\tfrac{2d}9\,(4v_1x^2+3)\,\beta = -x^4 + x^3 + \bigl(2sd^{3/2}-\tfrac14d^{-1/2}\bigr)x^2 + sd,$$
of which three stationary points are known, one of them at $x = 0$. */
/// The edges of these intervals between 0 and pi, in 1/site: from, to, from, to ... Phi is positive at q = 0 if beta is
/// negative there, and changes its sign at each zero of omega_2 and of beta.
template <class T>
std::vector<T> edges_of_instability(T d, T s) {
  using std::asin, std::sqrt;
  const T root = sqrt(d), b = T(2) * s * d * root - T(1) / (T(4) * root);
  const auto positive = [&](T x) { return x * x * (x * (T(1) - x) + b) + s * d > T(0); };
  // The polynomial is monotone between these places
  std::vector<T> places{T(0)};
  if (const T square = T(9) + T(32) * b; square > T(0)) {
    const T top = (T(3) + sqrt(square)) / T(8);
    for (T x : {-b / (T(2) * top), top})
      if (x > T(0) && x < T(2)) places.push_back(x);
  }
  places.push_back(T(2));
  std::vector<T> zeros{T(2) / (T(1) + sqrt(T(1) + T(6) * root))};  // that of omega_2
  for (std::size_t k = 1; k < places.size(); ++k) {
    T low = places[k - 1], high = places[k], middle;
    const bool before = positive(low);
    if (positive(high) == before) continue;
    while ((middle = low + (high - low) / T(2)) > low && middle < high)
      (positive(middle) == before ? low : high) = middle;
    zeros.push_back(middle);
  }
  std::sort(zeros.begin(), zeros.end());
  std::vector<T> edges;
  if (!positive(T(0))) edges.push_back(T(0));
  for (T x : zeros) edges.push_back(T(2) * asin(sqrt(x / T(2))));
  if (edges.size() % 2 == 1) edges.push_back(std::numbers::pi_v<T>);
  return edges;
}

/// A formula of these arguments in two precisions. Where large terms cancel, the last digit of an argument decides, in
/// both alike, so what one unit in its last place changes is added to the error.
template <class Formula, std::same_as<double>... Arguments>
Estimate in_two_precisions(Formula formula, Arguments... x) {
  const auto fine = [&](const std::array<double, sizeof...(x)>& at) {
    return std::apply([&](auto... y) { return formula(static_cast<long double>(y)...); }, at);
  };
  const std::array<double, sizeof...(x)> given{x...};
  const long double value = fine(given);
  Estimate out = with_error(double(formula(x...)), double(value));
  for (std::size_t i = 0; i < given.size(); ++i) {
    long double most = 0;
    for (double side : {-HUGE_VAL, HUGE_VAL}) {
      auto beside = given;
      beside[i] = std::nextafter(given[i], side);
      most = std::max(most, std::abs(fine(beside) - value));
    }
    out.error += double(most);
  }
  return out;
}

}  // namespace lattice
