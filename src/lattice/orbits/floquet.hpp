#pragma once
/**
# Floquet multipliers

A small change $z$ of a periodic orbit becomes $Mz$ after one period. The orbit is unstable if an eigenvalue $\lambda$
of the monodromy matrix $M$, a Floquet multiplier, lies outside the unit circle. They come in pairs $\lambda$ and
$1/\lambda$. That of the *phase*, a shift in time, is always $+1$ and *defective*, both have the same eigenvector: an
error $\delta$ of $M$ moves it by $\sqrt\delta$. A breather that can almost freely be shifted along the chain has a
second pair near $+1$, the *pinning pair*, which is dragged along. So the multipliers near $+1$ are not read off $M$
(sec33_floquet). */

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <type_traits>
#include <vector>

#include "lattice/numerics/estimate.hpp"
#include "lattice/orbits/shooting.hpp"

namespace lattice {

/// Derivative of the flow from `start` over `duration`: 2N x 2N, positions before velocities.
/// Throws NewtonFailed if the flow is not accurate.
template <class T>
Matrix<T> monodromy(const Chain& chain, const State<T>& start,
                    const std::type_identity_t<T>& duration, const EventTolerance<T>& rule = {});

/**
## Orbits that start from rest

An orbit that is even in time is at rest at $t=0$ and at $T_b/2$. With the blocks $A, B, C, D$ of the derivative $F$ of
the flow from $0$ to $T_b/2$, in positions and momenta, $M + M^{-1} = 2 + 4\,\mathrm{diag}(K, K^T)$ with $K = B^TC$.
Each eigenvalue $\kappa$ of the $N\times N$ matrix $K$ is therefore one pair,
$$\lambda + \frac1\lambda - 2 = 4\kappa,\qquad \lambda = 1 + 2\kappa \pm 2\sqrt{\kappa(1+\kappa)},$$
and its eigenvector holds the positions of the mode. A real $\kappa$ in $[-1,0]$ means a pair on the unit circle, any
other an unstable one; a complex $\kappa$ comes with its conjugate, as a *quadruplet* of multipliers. One pair alone can
therefore show that an orbit is unstable, but not that it is stable. */
/// The two multipliers of a pair: `sign` > 0 gives the larger one if kappa > 0, the one above the real axis on the
/// circle.
std::complex<double> multiplier(std::complex<double> kappa, int sign);

/**
A shift in time changes the momenta at $t=0$ in proportion to the force $f$, and no position at $T_b/2$: $Bf = 0$, hence
$f^TK = 0$. Restricted to vectors perpendicular to $f$, $K$ has all eigenvalues but the zero of the phase, and that of
the pinning pair is a simple one: an error $\delta$ of the flow costs $\delta$ and not $\sqrt\delta$. */
/// An orthonormal basis of all vectors perpendicular to `f`, by a Householder reflection.
template <class T>
Matrix<T> perpendicular_to(const Vector<T>& f);

/// The pairs of an orbit, with how well $F$ is symplectic.
template <class T>
struct MultiplierPairs {
  std::vector<std::complex<T>> kappa;  ///< all but that of the phase, by their distance from +1
  Vector<T> mode;        ///< positions at t = 0 of the mode of kappa.front(), of length one
  T symplectic_error{};  ///< largest entry of $F^T\Omega F - \Omega$, zero for an exact flow
  /// kappa of the pinning pair.
  T pinning() const { return kappa.front().real(); }
};

/// The pairs of an orbit that begins at rest at `start`, even in time, with period `period`. Throws
/// std::invalid_argument if it does not begin at rest, NewtonFailed if the flow is inaccurate, std::runtime_error if Eigen
/// finds no eigenvalues.
template <class T>
MultiplierPairs<T> floquet_pairs(const Chain& chain, const State<T>& start,
                                 const std::type_identity_t<T>& period,
                                 const EventTolerance<T>& rule = {});

/**
## Errors

Computations with two tolerances or types give two values of every $\kappa$. The error is their difference plus the
symplectic error of the finer one. From $\kappa$ to the multiplier the error
grows by $|d\lambda/d\kappa| \sim |\kappa(1+\kappa)|^{-1/2}$, up to the square root of the error if $\kappa$ cannot
be told from 0 or $-1$; what a double rounds off of $\kappa$ and $\lambda$ counts, too. */
struct MultiplierPair {
  std::complex<double> kappa;
  double error;  ///< of kappa, absolute
  /// The error with what a double rounds off of kappa.
  double radius() const { return error + std::numeric_limits<double>::epsilon() * std::abs(kappa); }
  /// Whether the multipliers leave the unit circle by more than the error allows.
  bool is_unstable() const {
    const double r = radius();
    return std::abs(kappa.imag()) > r || kappa.real() > r || kappa.real() < -1 - r;
  }
  /// Error of either multiplier.
  double multiplier_error() const {
    const double r = radius(), distance = std::max(std::abs(kappa * (1.0 + kappa)), r);
    return 2 * r * (1 + std::abs(1.0 + 2.0 * kappa) / std::sqrt(distance)) +
           2 * std::numeric_limits<double>::epsilon();
  }
};

/// The pairs with their errors, in the order of `fine`. Each eigenvalue of the finer computation is compared with
/// the nearest one of the coarser that has not been taken yet.
template <class C, class T>
std::vector<MultiplierPair> pairs_with_errors(const MultiplierPairs<C>& coarse,
                                              const MultiplierPairs<T>& fine);

/// By how much the largest modulus of the pairs from number `first` on exceeds one; its error allows for those of all
/// these pairs.
Estimate excess(const std::vector<MultiplierPair>& pairs, std::size_t first = 0);

}  // namespace lattice
