#pragma once
/**
# Floquet multipliers

Is a periodic orbit stable? A small change $z$ of it becomes $Mz$ after one period. The eigenvalues
$\lambda$ of the monodromy matrix $M$, the Floquet multipliers, decide: the orbit is unstable if one of
them lies outside the unit circle. In a Hamiltonian chain they come in pairs $\lambda$ and $1/\lambda$.
One pair, that of the *phase*, is always $+1$: a shift in time changes nothing, and a change of the energy
only leads to a neighbouring orbit. This pair is *defective*, both have the same eigenvector; an error
$\delta$ of $M$ therefore moves its eigenvalues by $\sqrt\delta$. A breather that can almost freely be
shifted along the chain has a second pair near $+1$, the *pinning pair*, which is dragged along. So the
multipliers near $+1$ should not be read off $M$. What we need is a quantity in which the two pairs are
far apart or that of the phase is absent. */

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

/// In positions and momenta the derivative of a Hamiltonian flow is symplectic, $F^T\Omega F = \Omega$ with
/// $\Omega = \bigl(\begin{smallmatrix} 0 & 1\\ -1 & 0\end{smallmatrix}\bigr)$.
/// Largest entry of F^T Omega F - Omega, zero for the derivative of an exact flow in momenta.
template <class T>
T symplectic_error(const Matrix<T>& f);

/**
## Orbits that start from rest

An orbit that is even in time is at rest at $t=0$ and at $T_b/2$. Let $A, B, C, D$ be the four blocks of
the derivative $F$ of the flow from $0$ to $T_b/2$, in positions and momenta. The second half of the
period is the first one run backwards, $M = RF^{-1}RF$ with $R = \mathrm{diag}(1,-1)$, and the inverse of
a symplectic matrix needs no elimination:
$$M = \begin{pmatrix} 1+2K & 2D^TB\\ 2A^TC & 1+2K^T\end{pmatrix},\qquad K = B^TC,\qquad
M + M^{-1} = \begin{pmatrix} 2+4K & 0\\ 0& 2+4K^T\end{pmatrix}.$$
Each eigenvalue $\kappa$ of the $N\times N$ matrix $K$ is therefore one pair,
$$\lambda + \frac1\lambda - 2 = 4\kappa,\qquad \lambda = 1 + 2\kappa \pm 2\sqrt{\kappa(1+\kappa)},$$
and its eigenvector holds the positions of the mode. A real $\kappa$ in $[-1,0]$ means a pair on the unit circle, at the
angles $\pm 2\arcsin\sqrt{-\kappa}$; $\kappa > 0$ means an unstable one, $\ln\lambda = \pm
2\,\mathrm{arsinh}\sqrt\kappa$. Unstable are also $\kappa < -1$ and every complex $\kappa$, which comes with its
conjugate, as a *quadruplet* of multipliers. One pair alone can therefore show that an orbit is unstable, but not that
it is stable. Near $+1$ the difference $\lambda+1/\lambda-2$ would lose all digits; here it is never formed. */
/// The matrix K of a half-period map in momenta.
template <class T>
Matrix<T> pair_matrix(const Matrix<T>& half);

/// The two multipliers of a pair: `sign` > 0 gives the larger one if kappa > 0, the one above the real axis on the
/// circle.
std::complex<double> multiplier(std::complex<double> kappa, int sign);

/**
The time-translation pair can be removed exactly. A shift in time changes the momenta at $t=0$ in proportion to
the force $f$, and at $T_b/2$, where the chain is at rest again, it does not change the positions:
$Bf = 0$, hence $f^TK = 0$. The image of $K$ is perpendicular to $f$, and $K$ restricted to such vectors
has all eigenvalues but the zero of the phase. In the restricted matrix the eigenvalue of the pinning
pair is a simple one, so that an error $\delta$ of the flow costs $\delta$ and not $\sqrt\delta$. */
/// An orthonormal basis of all vectors perpendicular to `f`, by a Householder reflection.
template <class T>
Matrix<T> perpendicular_to(const Vector<T>& f);

/// The pairs of an orbit, with how well $F$ is symplectic.
template <class T>
struct MultiplierPairs {
  std::vector<std::complex<T>> kappa;  ///< all but that of the phase, by their distance from +1
  Vector<T> mode;        ///< positions at t = 0 of the mode of kappa.front(), of length one
  T symplectic_error{};  ///< of the half-period map, see symplectic_error
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
