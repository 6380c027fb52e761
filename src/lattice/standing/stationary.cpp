#include "lattice/standing/stationary.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "lattice/model/contact.hpp"
#include "lattice/quadruple/quadruple.hpp"

namespace lattice {
/// D of the strain r.
template <class T>
static T force_of(const T& r, double alpha) {
  return r * secant_stiffness(r, alpha);
}

template <class T>
T Stationary<T>::norm() const {
  T sum(0);
  for (const T& x : u) sum += x * x;
  return sum;
}

template <class T>
T Stationary<T>::contact_sum() const {
  using std::abs;
  T sum(0);
  for (std::size_t i = 0; i + 1 < u.size(); ++i) {
    const T r = u[i + 1] - u[i];
    sum += abs(r * force_of(r, exponent));
  }
  return sum;
}

namespace {

/**
The strains span hundreds of decades, so the unknowns are the relative corrections $\eta_n = \delta r_n/r_n$, and row $n$
is divided by $\mu r_n$. The scaled matrix is well conditioned however small the strains are. */
template <class T>
Vector<T> newton_step(Centre centre, const T& mu, const std::vector<T>& r, double alpha) {
  const auto count = Eigen::Index(r.size());
  Matrix<T> jacobian(count, count);
  Vector<T> residual(count);
  jacobian.setZero();
  for (Eigen::Index n = 0; n < count; ++n) {
    const auto force = [&](Eigen::Index k) {
      return k < count ? force_of(r[std::size_t(k)], alpha) / (mu * r[std::size_t(n)]) : T(0);
    };
    const auto couple = [&](Eigen::Index k, int weight) {
      if (k >= count) return;
      residual(n) += T(weight) * force(k);
      jacobian(n, k) += T(alpha) * T(weight) * force(k);
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

/// From Eq. (14), $u_n = (D_{n-1}-D_n)/\mu$, on the right half; the other half is its mirror image.
template <class T>
std::vector<T> displacements(Centre centre, const T& mu, const std::vector<T>& r, std::size_t sites,
                             double alpha) {
  const auto pull = [&](std::size_t n) { return n < r.size() ? force_of(r[n], alpha) : T(0); };
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
The iteration stops when no strain is corrected by more than a hundred roundings, times $\alpha$ for each
site, because $r_n \sim |r_{n-1}|^\alpha$ makes a relative error that much larger from site to site. */
template <class T>
void converge_strains(Centre centre, const T& mu, std::vector<T>& r, double alpha) {
  const double bound =
      100 * double(std::numeric_limits<T>::epsilon()) * std::pow(alpha, double(r.size()));
  std::ostringstream text;
  // Each round multiplies every strain by one plus its relative correction
  for (int k = 0; k < 30; ++k) {
    const Vector<T> eta = newton_step(centre, mu, r, alpha);
    double largest = 0;
    for (std::size_t n = 0; n < r.size(); ++n) {
      const auto correction = std::abs(double(eta(Eigen::Index(n))));
      if (!(correction <= largest)) largest = correction;
      r[n] *= T(1) + eta(Eigen::Index(n));
    }
    text << (k > 0 ? ", " : "") << largest;
    if (largest <= bound) return;
    if (!std::isfinite(largest)) break;
  }
  // Without convergence, the list of corrections shows whether they stagnated or grew
  throw std::runtime_error(
      "Newton's method for the stationary DpS state did not converge, largest relative "
      "corrections " +
      text.str());
}

}  // namespace

// The balance of forces predicts the next strain, until the chain is full or the strain too small for the arithmetic
template <class T>
Stationary<T> stationary_from(Centre centre, const T& mu, std::vector<T> start, std::size_t sites,
                              double alpha) {
  using std::abs;
  const T least = least_exact<T>();
  Stationary<T> out{centre, mu, {}, std::move(start), alpha};
  for (;;) {
    converge_strains(centre, mu, out.strain, alpha);
    const T next = -force_of(out.strain.back(), alpha) / mu;
    if (out.strain.size() == sites / 2 || abs(next) < least) break;
    out.strain.push_back(next);
  }
  out.u = displacements(centre, mu, out.strain, sites, alpha);
  return out;
}

// The start is the compact profile of the quasi-continuum limit, scaled with a power of mu
template <class T>
Stationary<T> stationary(Centre centre, const T& mu, std::size_t sites, double alpha) {
  using std::pow;
  if (!fits(centre, sites))
    throw std::invalid_argument(
        "a bond-centred state needs an even number of sites and a site-centred one an odd number, "
        "at least 2 (got " +
        std::to_string(sites) + ")");
  if (!(mu > T(0))) throw std::invalid_argument("mu must be > 0");
  if (!(alpha > 1)) throw std::invalid_argument("alpha must be > 1");
  std::vector<T> start(std::min(short_chain(alpha), sites / 2));
  const bool spheres = alpha == 1.5;
  const auto near = [&](std::size_t n) {
    return spheres ? quasi_continuum<T>(centre, long(n))
                   : T(quasi_continuum(centre, long(n), alpha));
  };
  const T size = spheres ? T(mu * mu) : T(pow(mu, T(1) / (T(alpha) - T(1))));
  for (std::size_t n = 0; n < start.size(); ++n) start[n] = size * (near(n + 1) - near(n));
  // Towards alpha = 1 the edge of the profile is too small for its number
  while (start.size() > 1 && !(start.back() != T(0))) start.pop_back();
  return stationary_from(centre, mu, std::move(start), sites, alpha);
}

// The scalars that are used
#define LATTICE_STATIONARY(T)                                                                    \
  template struct Stationary<T>;                                                                 \
  template Stationary<T> stationary_from(Centre, const T&, std::vector<T>, std::size_t, double); \
  template Stationary<T> stationary(Centre, const T&, std::size_t, double);

LATTICE_STATIONARY(double)
LATTICE_STATIONARY(long double)
LATTICE_STATIONARY(Quadruple)

}  // namespace lattice
