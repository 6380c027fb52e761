#pragma once
/**
# Stationary states of the DpS equation

Small static breathers are stationary states of the DpS equation. With $v_n = u_n e^{i\mu t}$, $u_n$ real,
its normalised form Eq. (11) becomes Eq. (14),
$$-\mu u_n = D_n - D_{n-1}, \qquad D_n = (u_{n+1}-u_n)\,|u_{n+1}-u_n|^{1/2},$$
with $D = 0$ beyond free ends. This file computes its localized solutions with the same relative accuracy
at every site, down to the last one that the number format can represent. Sites are numbered as in
sites.hpp. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>
#include "lattice/model/contact.hpp"
#include "lattice/model/sites.hpp"
#include "lattice/numbers/dense.hpp"

namespace lattice {

/**
To begin with we need an approximation. The article derives one by treating the envelope of the alternating
$D_n$ as a function of a continuous variable, Eqs. (15) to (17): $g(x) = (3/10)^3\cos^6(x/3)$ for
$|x| \le 3\pi/2$ and zero elsewhere. At $\mu = 1$ this gives $u_n = (-1)^n[g(n)+g(n-1)]$ around a bond,
Eq. (18), and $u_n = (-1)^n[g(n+\frac12)+g(n-\frac12)]$ around a site, Eq. (19). */
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

/**
A state keeps the strains $u_{n+1}-u_n$ from which it was computed, so that a neighbouring state can start
from them. */
/// `strain[k]` is u_{k+1} - u_k for k >= 0, the right half of the contacts.
template <class T>
struct Stationary {
  Centre centre;
  T mu;
  std::vector<T> u;             ///< one entry per site
  std::vector<T> strain;        ///< one entry per contact of the right half that is not zero
  std::vector<double> history;  ///< largest relative correction of each Newton step

  /// N = sum u_n^2.
  T norm() const {
    T sum(0);
    for (const T& x : u) sum += x * x;
    return sum;
  }
  /// sum |u_{n+1} - u_n|^{5/2}, which the equation makes equal to mu N.
  T contact_sum() const {
    using std::abs;
    T sum(0);
    for (std::size_t i = 0; i + 1 < u.size(); ++i)
      sum += abs((u[i + 1] - u[i]) * three_halves(u[i + 1] - u[i]));
    return sum;
  }
};

/**
## Unknowns

The differences of neighbouring equations contain only the strains $r_n = u_{n+1}-u_n$,
$$D_{n+1} - 2D_n + D_{n-1} + \mu r_n = 0, \qquad D_n = r_n|r_n|^{1/2}.$$
This has two merits. In the tail it reads $r_n \approx -D_{n-1}/\mu$: each strain follows from the one
before without cancellation, and $u_n = (D_{n-1}-D_n)/\mu$ is as accurate. And the symmetry is simple:
$D_{-1} = D_1$ around a bond and $D_{-1} = -D_0$ around a site, so that the right half of the chain
suffices and no direction is left in which a state could slide along the chain.

## Newton's method

The strains span hundreds of decades, so the unknowns of the linear system are the relative
corrections $\eta_n = \delta r_n/r_n$, and row $n$ is divided by $\mu r_n$. In the tail the scaled
matrix has ones on its diagonal and $3/2$ beside it: it is well conditioned however small the
strains are. */
template <class T>
Vector<T> newton_step(Centre centre, const T& mu, const std::vector<T>& r) {
  const auto count = Eigen::Index(r.size());
  Matrix<T> jacobian(count, count);
  Vector<T> residual(count);
  jacobian.setZero();
  for (Eigen::Index n = 0; n < count; ++n) {
    const auto force = [&](Eigen::Index k) {
      return k < count ? three_halves(r[std::size_t(k)]) / (mu * r[std::size_t(n)]) : T(0);
    };
    const auto couple = [&](Eigen::Index k, int weight) {
      if (k >= count) return;
      residual(n) += T(weight) * force(k);
      jacobian(n, k) += T(1.5 * weight) * force(k);
    };
    residual(n) = jacobian(n, n) = T(1);
    couple(n, -2);
    couple(n + 1, 1);
    if (n > 0) couple(n - 1, 1);
    if (n == 0 && centre == Centre::bond) couple(1, 1);
    if (n == 0 && centre == Centre::site) couple(0, -1);
  }
  return solve_square<T>(jacobian, -residual);
}

/**
When the strains are known, the displacements follow from Eq. (14), $u_n = (D_{n-1}-D_n)/\mu$, on the right
half; the other half is its mirror image. */
template <class T>
std::vector<T> displacements(Centre centre, const T& mu, const std::vector<T>& r,
                             std::size_t sites) {
  const auto pull = [&](std::size_t n) { return n < r.size() ? three_halves(r[n]) : T(0); };
  std::vector<T> u(sites, T(0));
  for (long n = centre == Centre::bond ? 1 : 0; n < long(sites) - long(sites - 1) / 2; ++n) {
    const T before = n > 0 ? pull(std::size_t(n - 1)) : -pull(0);
    const T value = (before - pull(std::size_t(n))) / mu;
    u[site_index(n, sites)] = value;
    if (centre == Centre::bond)
      u[site_index(1 - n, sites)] = T(0) - value;
    else
      u[site_index(-n, sites)] = value;
  }
  return u;
}

/**
The iteration stops when no strain is corrected by more than a hundred roundings, times $3/2$ for each
site, because $r_n \sim |r_{n-1}|^{3/2}$ makes a relative error that much larger from site to site.
Convergence is quadratic, so what the last correction leaves is far smaller than what it removed. Throws
std::runtime_error, with the history, if `most` steps are not enough. */
template <class T>
void converge_strains(Centre centre, const T& mu, std::vector<T>& r, int most,
                      std::vector<double>& history) {
  const double bound =
      100 * double(std::numeric_limits<T>::epsilon()) * std::pow(1.5, double(r.size()));
  std::ostringstream text;
  for (int k = 0; k < most; ++k) {
    const Vector<T> eta = newton_step(centre, mu, r);
    double largest = 0;
    for (std::size_t n = 0; n < r.size(); ++n) {
      const auto correction = std::abs(double(eta(Eigen::Index(n))));
      if (!(correction <= largest)) largest = correction;
      r[n] *= T(1) + eta(Eigen::Index(n));
    }
    text << (k > 0 ? ", " : "") << largest;
    history.push_back(largest);
    if (largest <= bound) return;
    if (!std::isfinite(largest)) break;
  }
  throw std::runtime_error(
      "Newton's method for the stationary DpS state did not converge, largest relative "
      "corrections " +
      text.str());
}

/**
## From a short chain to a long one

A wrong tail in the guess is fatal, since an error of the centre enters the $k$-th site from it with the
exponent $(3/2)^k$. So we first solve on a short chain, with the quasi-continuum profile `start` as the
guess, and lengthen it by a site at a time. Each new strain follows from its neighbour, and one or two
Newton steps do the rest. The tail ends where the strain is about to fall below the normal numbers; all
that follows is zero in this number format. */
/// Above it a number and its rounding error are both normal numbers of this type.
template <class T>
T least_exact() {
  using std::ldexp;
  return ldexp(T(1), std::numeric_limits<T>::min_exponent) / std::numeric_limits<T>::epsilon();
}

template <class T>
Stationary<T> stationary_from(Centre centre, const T& mu, std::vector<T> start, std::size_t sites,
                              int most = 30) {
  using std::abs;
  const T least = least_exact<T>();
  Stationary<T> out{centre, mu, {}, std::move(start), {}};
  for (;;) {
    converge_strains(centre, mu, out.strain, most, out.history);
    const T next = -three_halves(out.strain.back()) / mu;
    if (out.strain.size() == sites / 2 || abs(next) < least) break;
    out.strain.push_back(next);
  }
  out.u = displacements(centre, mu, out.strain, sites);
  return out;
}

/**
The short chain has four strains on the right half, because so far the quasi-continuum profile is a good
guess. */
inline constexpr std::size_t short_chain = 4;

/// The stationary state of frequency `mu` with the given centre on `sites` sites with free ends;
/// its phase is that of Eqs. (18) and (19) (central contact of a bond-centred state compressed,
/// central bead of a site-centred one displaced forward). Throws std::invalid_argument for impossible
/// input and std::runtime_error, with the history, if Newton's method does not converge.
template <class T = double>
Stationary<T> stationary(Centre centre, const T& mu, std::size_t sites, int most = 30) {
  if (!fits(centre, sites))
    throw std::invalid_argument(
        "a bond-centred state needs an even number of sites and a site-centred one an odd number, "
        "at least 2 (got " +
        std::to_string(sites) + ")");
  if (!(mu > T(0))) throw std::invalid_argument("mu must be > 0");
  std::vector<T> start(std::min(short_chain, sites / 2));
  for (std::size_t n = 0; n < start.size(); ++n)
    start[n] =
        mu * mu * (quasi_continuum<T>(centre, long(n) + 1) - quasi_continuum<T>(centre, long(n)));
  return stationary_from(centre, mu, std::move(start), sites, most);
}

}  // namespace lattice
