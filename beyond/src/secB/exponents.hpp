#pragma once
/**
# Static breathers for contacts of any exponent

We find both static breathers of the DpS equation (stationary.hpp) for every exponent $\alpha > 1$ of the contact
force that we try. Which one is stable, and by how much? Around a site and around a bond, at equal frequency, they are
compared by their norms, $N_{bond}/N_{site}-1$, and each is judged by its margin $m_2/\mu-1/\alpha$ (spectrum.hpp),
which is positive if it is unstable. All of these are free of the scale of $\mu$.

In the limit $\alpha \to \infty$ only the central contacts remain: around a bond $u = \frac12(1,-1)$, around a site
$u = \frac13(-1,2,-1)$, and with these the norms tend to $\frac12$ and $\frac23$ and the margins to $0$ and $\frac13$.
In the limit $\alpha \to 1$ both breathers become wide and the same: with $D_n = (-1)^nf(n)$ and
$f^{1/\alpha} \approx f\,[1-(\alpha-1)\ln f]$ Eq. (14) tends to a logarithmic equation, whose solution is a Gaussian,
$u_n \propto (-1)^ne^{-(\alpha-1)x^2}$ with $x$ counted from the centre. */

#include <cstddef>
#include <vector>

#include "lattice/model/sites.hpp"
#include "lattice/numerics/estimate.hpp"

namespace lattice {

/**
What tells a site from a bond is then exponentially small. Farther out we put $f = e^{-S(X)/\delta}$ with
$\delta = \alpha-1$ and $X = \delta x$; the leading terms of the equation are $e^S = \cosh^2\frac{S'}2$, so that
$S = 2\ln\cosh p$ and $dX = p^{-1}\tanh p\,dp$ with $p = S'/2$. A sum over sites of $f^2$ depends on where the centre is
through its Fourier component $e^{2\pi ix}$. The path of integration may be moved along imaginary $p = i\theta$ up to
$\theta = \frac\pi2$, where $S' = \pi i$; there the integrand has fallen to $e^{-c/\delta}$,
$$c = \int_0^{\pi/2}\frac{2\pi-4\theta}{\theta}\,\tan\theta\,d\theta.$$
This is an argument and not a proof; norms and margins follow it (a test). */
/// c, by Simpson's rule on two grids.
Estimate pinning_exponent();

/**
Near $\alpha = 1.2$ such differences leave the digits of double precision, so we compute in quadruple precision and with
fifty digits. The error is the difference of the two plus the change with ten more sites. Where the margin is not known to a digit, its sign says nothing. */
/// What a static breather is worth at one exponent, at mu = 1.
struct BreatherOfExponent {
  Estimate norm;    ///< sum u_n^2
  Estimate margin;  ///< (m_2 - mu / alpha) / mu, positive if unstable
  Estimate rate;    ///< |lambda| / mu: of growth if the margin is positive, else a frequency
  Estimate bend;    ///< of ln|u_n| at the centre, over -2 (alpha - 1): 1 for a Gaussian
};

/// Both breathers at one exponent.
struct OfExponent {
  double alpha;
  BreatherOfExponent site, bond;
  Estimate norm_difference;  ///< N_bond / N_site - 1

  /// One of the two.
  const BreatherOfExponent& of(Centre centre) const { return centre == Centre::site ? site : bond; }
};

/// Both breathers of exponent `alpha`, on chains that are `longer` by an even number of sites than usual. Throws
/// std::invalid_argument unless alpha > 1, and std::runtime_error where `stationary` does.
OfExponent breathers_of_exponent(double alpha, std::size_t longer = 0);

/// The same for each of `alphas`, on all cores and in their order.
std::vector<OfExponent> scan_exponents(const std::vector<double>& alphas);

}  // namespace lattice
