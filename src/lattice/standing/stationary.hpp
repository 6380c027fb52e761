#pragma once
/**
# Stationary states of the DpS equation

With $v_n = u_n e^{i\mu t}$, $u_n$ real, the DpS equation, in its normalised form Eq. (11), becomes Eq. (14),
$$-\mu u_n = D_n - D_{n-1}, \qquad D_n = (u_{n+1}-u_n)\,|u_{n+1}-u_n|^{\alpha-1},$$
with $D = 0$ beyond free ends; the article's spheres have $\alpha = 3/2$. Its localized solutions are computed with the
same relative accuracy at every site, down to the last one that the number format can represent. Sites are numbered as
in sites.hpp. */

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "lattice/model/quasi_continuum.hpp"

namespace lattice {

/// `strain[k]` is u_{k+1} - u_k for k >= 0, the right half of the contacts.
template <class T>
struct Stationary {
  Centre centre;
  T mu;                   ///< frequency
  std::vector<T> u;       ///< one entry per site
  std::vector<T> strain;  ///< one entry per contact of the right half that is not zero
  double exponent = 1.5;  ///< alpha, of the contact force

  /// N = sum u_n^2.
  T norm() const;
  /// sum |u_{n+1} - u_n|^{alpha+1}, which the equation makes equal to mu N.
  T contact_sum() const;
};

/**
The differences of neighbouring equations contain only the strains $r_n = u_{n+1}-u_n$,
$$D_{n+1} - 2D_n + D_{n-1} + \mu r_n = 0, \qquad D_n = r_n|r_n|^{\alpha-1}.$$
In the tail it reads $r_n \approx -D_{n-1}/\mu$: each strain follows from the one before without cancellation, and
$u_n = (D_{n-1}-D_n)/\mu$ is as accurate. The symmetry is $D_{-1} = D_1$ around a bond and $D_{-1} = -D_0$ around a
site, so that the right half of the chain suffices and no state can slide along the chain.

The first guess is the quasi-continuum profile. A wrong tail in it would be fatal, since an error of the
centre enters the $k$-th site from it with the exponent $\alpha^k$. So we first solve on a short chain, which holds the
support of the approximation, and lengthen it by a site at a time; each new strain follows from its neighbour, and a few
steps of Newton's method do the rest. */
/// Strains of the short chain's right half, four for spheres: where the quasi-continuum profile is not zero.
inline std::size_t short_chain(double alpha = 1.5) {
  return std::size_t(std::numbers::pi * alpha / (2 * (alpha - 1)));
}

/// The stationary state of frequency `mu` with the given centre on `sites` sites with free ends;
/// its phase is that of Eqs. (18) and (19) (central contact of a bond-centred state compressed,
/// central bead of a site-centred one displaced forward). Throws std::invalid_argument for impossible
/// input and std::runtime_error, with the history, if Newton's method does not converge.
/// T is double, long double or one of quadruple.hpp; `alpha` was tried from 1.01 to 10.
template <class T = double>
Stationary<T> stationary(Centre centre, const T& mu, std::size_t sites, double alpha = 1.5);

/// The same from strains `start` of a shorter chain or of another state.
template <class T>
Stationary<T> stationary_from(Centre centre, const T& mu, std::vector<T> start, std::size_t sites,
                              double alpha = 1.5);

/// Above it a number and its rounding error are both normal numbers of this type. A tail ends there.
template <class T>
T least_exact() {
  using std::ldexp;
  return ldexp(T(1), std::numeric_limits<T>::min_exponent) / std::numeric_limits<T>::epsilon();
}

}  // namespace lattice
