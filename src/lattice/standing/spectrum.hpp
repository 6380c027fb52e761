#pragma once
/**
# Small motions about a stationary DpS state

A perturbation of a stationary state (stationary.hpp) is written as $v_n = e^{i\mu t}(u_n + x_n + iy_n)$. The force of a
contact changes at the rate $\alpha|d_n|^{\alpha-1}$ along the strain $d_n = u_{n+1}-u_n$, and at the rate
$|d_n|^{\alpha-1}$ across it. With the gradient $(\nabla x)_n = x_{n+1}-x_n$ both follow from one matrix,
$$M = \nabla^T\,\mathrm{diag}\,|d_n|^{\alpha-1}\,\nabla, \qquad \dot x = (\mu - M)y,\quad \dot y = -(\mu - \alpha M)x.$$
Each eigenvector of $M$, with eigenvalue $m$, moves independently, like $e^{\lambda t}$ with
$\lambda^2 = -(\mu-m)(\mu-\alpha m)$. Eq. (14) says $Mu = \mu u$. Where neighbours have opposite signs, by the
Perron–Frobenius theorem $m_1 = \mu$ is simple and the largest. Hence such a state is spectrally unstable if and only
if the second eigenvalue exceeds $\mu/\alpha$, with one real pair $\pm\lambda$ for each such $m$. */

#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

#include "lattice/algebra/dense.hpp"
#include "lattice/model/dps.hpp"
#include "lattice/numerics/estimate.hpp"
#include "lattice/standing/stationary.hpp"

namespace lattice {

/// |d_n|^{alpha-1} of every contact, for spheres the roots of the strains, `sites - 1` of them.
template <class T>
std::vector<T> contact_roots(const Stationary<T>& state);

/**
## The spectrum of M

The invariance under a change of phase, which gives the full problem a defective double eigenvalue $\lambda = 0$, is
here the simple eigenvalue $m_1 = \mu$. The computed value checks state and solver at once: we keep its residual and put
$\mu$ itself in its place, so that the exponent of the phase is exactly zero. */
template <class T>
struct ContactSpectrum {
  T mu;                   ///< frequency of the state
  std::vector<T> m;       ///< from the largest on; m[0] is known to be mu and set to it
  double exponent = 1.5;  ///< alpha of the state
  T phase_residual{0};    ///< computed m[0] minus mu
  Vector<T> second{};     ///< unit eigenvector of m[1]
};

/// The spectrum of M. Throws std::runtime_error if Eigen's iteration does not converge.
template <class T>
ContactSpectrum<T> contact_spectrum(const Stationary<T>& state);

/// How many eigenvalues of the M with these `roots` are larger than `x`: by Sylvester's law of inertia as many as the
/// elimination of $M-x$ has positive pivots. At $x = \mu/\alpha$ this is the verdict: one for a stable state, $1+k$ for
/// one with $k$ real pairs.
template <class T>
std::size_t eigenvalues_above(const std::vector<T>& roots, const T& x);

/// The k-th largest eigenvalue of M, k >= 1, between 0 and 2 mu, by halving until no number of the format
/// is left inside the interval: the error is one rounding.
template <class T>
T counted_eigenvalue(const Stationary<T>& state, std::size_t k);

/// Near $m = \mu/\alpha$ an error $\delta$ of $m$ changes it by about $(\alpha-1)\mu\delta$.
template <class T>
T lambda_squared(const T& mu, const T& m, double alpha = 1.5) {
  return (mu - m) * (T(alpha) * m - mu);
}

/// |lambda|, a rate where lambda^2 > 0 and a frequency where it is < 0.
template <class T>
T lambda_modulus(const T& mu, const T& m, double alpha = 1.5) {
  using std::abs;
  using std::sqrt;
  return sqrt(abs(lambda_squared(mu, m, alpha)));
}

/// m - mu / alpha: for the second eigenvalue, unstable if and only if positive.
template <class T>
T instability_margin(const T& mu, const T& m, double alpha = 1.5) {
  return (T(alpha) * m - mu) / T(alpha);
}

/// Both exponents of each m, two per site, as (real, imaginary): lambda, then -lambda. One part is exactly zero: a
/// spectrum from $M$ cannot show a small growth that comes from rounding.
template <class T>
std::vector<std::pair<T, T>> exponents(const ContactSpectrum<T>& spectrum);

/**
## How close to the edge

Rounding and the ends of the chain could turn the sign of a margin. We vary both, the precision from double to `Fine`
and the length by ten sites, and add the two changes. Divided by $\mu$ margins at different frequencies may be compared
digit by digit. */
/// How far a state is from the edge of stability.
struct Margin {
  Estimate margin, exponent;  ///< (m_2 - mu / alpha) / mu, positive if unstable, and |lambda| / mu
  /// The margin with its error a hundredfold, by which a verdict must stay clear of the edge.
  Estimate safe() const { return {margin.value, 100 * margin.error}; }
};

/// The margin of the breather of frequency `mu` on `sites` sites.
template <class Fine>
Margin margin_of(Centre centre, double mu, std::size_t sites, double alpha = 1.5);

/**
## The pinning pair

The second eigenvector $V$ of $M$ looks like the derivative of the breather along the chain: added to the field it
shifts the breather, and $iV$ pushes it. In the coordinates $x = V\cdot\mathrm{Re}\,w$ and $y = V\cdot\mathrm{Im}\,w$ a
perturbation $w$ moves like a pendulum near one of its rest positions, $\dot x = (\mu-m)y$, $\dot y = (\alpha m-\mu)x$.
The growing part is $\frac12(x + (\mu-m)y/\lambda)$: a push counts as much as a shift that is larger by its *leverage* $(\mu-m)/\lambda$. */
struct PinningMode {
  Eigen::VectorXd V;   ///< of length one; its sign is arbitrary
  double mu, m, rate;  ///< rate: |lambda|
  double leverage;     ///< of a push: (mu - m) / |lambda|

  /// From a spectrum with its second eigenvector.
  explicit PinningMode(const ContactSpectrum<double>& spectrum);

  /// (x, y) of the perturbation `w`. The projection is exact, since V has unit length and the
  /// eigenvectors of M are orthogonal.
  std::complex<double> of(const Field& w) const;
  /// The part along the growing direction, measured by the x that belongs to it.
  double growing(const Field& w) const;
  /// Adds z V to `w`: the real part shifts, the imaginary part pushes.
  void add(std::complex<double> z, Field& w) const;
};

}  // namespace lattice
