#pragma once
/**
# Floquet multipliers

A small change $z$ of a periodic orbit becomes $Mz$ after one period, and the eigenvalues $\lambda$ of
the monodromy matrix $M$, the multipliers, decide stability. In a Hamiltonian chain they come as
$\lambda$ and $1/\lambda$, and one pair is always $+1$: a shift in time changes nothing, and a change
of the energy only leads to a neighbouring orbit. That pair is *defective*, there is but one eigenvector
for both. An error $\delta$ of $M$ moves its eigenvalues by $\sqrt\delta$, and a second pair near $+1$,
that of a breather which can be shifted along the chain, is dragged along. So the multipliers near
$+1$ should not be read off $M$. What we need is a quantity in which both pairs are far apart or one
of them is absent. */

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

#include "lattice/orbits/shooting.hpp"

namespace lattice {

/**
The derivative of the flow comes from the variational equations, landing on every switching
(landing.hpp). What refuses an inaccurate flow for an orbit refuses it here. */
/// Derivative of the flow from `start` over `duration`: 2N x 2N, positions before velocities.
/// Throws NoConvergence where the flow is not accurate.
template <class T, class Onsite, class Contact>
Matrix<T> monodromy(const Chain<Onsite, Contact>& chain, const State<T>& start, const T& duration,
                    const Landing<T>& rule = {}) {
  State<T> end = start;
  Tangent<T> tangent(chain.sites, 2 * chain.sites);
  if (!is_accurate(flow(chain, end, duration, rule, &tangent), rule))
    throw NoConvergence("the flow is not accurate enough for multipliers", {});
  const auto n = Eigen::Index(2 * chain.sites);
  return Eigen::Map<Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
      tangent.entries.data(), n, n);
}

/**
The structure that we use belongs to positions and momenta, and the first thing to know about a
computed map is by how much it misses that structure. */
/// The derivative in positions and momenta: velocities are multiplied by the masses.
template <class T, class Onsite, class Contact>
Matrix<T> in_momenta(const Chain<Onsite, Contact>& chain, Matrix<T> f) {
  const auto n = Eigen::Index(chain.sites);
  for (Eigen::Index i = 0; i < n && !chain.mass.empty(); ++i) {
    f.row(n + i) *= T(chain.mass_of(std::size_t(i)));
    f.col(n + i) /= T(chain.mass_of(std::size_t(i)));
  }
  return f;
}

/// Largest entry of F^T Omega F - Omega, zero for the derivative of an exact flow in momenta.
template <class T>
T symplectic_defect(const Matrix<T>& f) {
  const Eigen::Index n = f.rows() / 2;
  Matrix<T> turned(2 * n, 2 * n);
  turned << f.bottomRows(n), -f.topRows(n);
  Matrix<T> defect = f.transpose() * turned;
  defect.topRightCorner(n, n).diagonal().array() -= T(1);
  defect.bottomLeftCorner(n, n).diagonal().array() += T(1);
  return sup<T>(defect.reshaped());
}

/**
## Orbits that start from rest

An orbit that is even in time rests at $t=0$ and at $T_b/2$. Let $A, B, C, D$ be the four blocks of the
derivative $F$ of the flow from $0$ to $T_b/2$, in positions and momenta. The way back in time gives the
second half of the period, $M = RF^{-1}RF$ with $R = \mathrm{diag}(1,-1)$, and the inverse of a
symplectic matrix needs no elimination:
$$M = \begin{pmatrix} 1+2K & 2D^TB\\ 2A^TC & 1+2K^T\end{pmatrix},\qquad K = B^TC,\qquad
M + M^{-1} = \begin{pmatrix} 2+4K & 0\\ 0& 2+4K^T\end{pmatrix}.$$
Each eigenvalue $\kappa$ of the $N\times N$ matrix $K$ is therefore one pair,
$$\lambda + \frac1\lambda - 2 = 4\kappa,\qquad \lambda = 1 + 2\kappa \pm 2\sqrt{\kappa(1+\kappa)},$$
and its eigenvector holds the positions of the mode. A real $\kappa$ in $[-1,0]$ is a stable pair, at
the angle $2\arcsin\sqrt{-\kappa}$; $\kappa > 0$ is an unstable one, $\ln\lambda = 2\,\mathrm{arsinh}\sqrt\kappa$.
The difference from two, in which all digits would be lost, never appears. */
/// The matrix K of a half-period map in momenta.
template <class T>
Matrix<T> pair_matrix(const Matrix<T>& half) {
  const Eigen::Index n = half.rows() / 2;
  return half.topRightCorner(n, n).transpose() * half.bottomLeftCorner(n, n);
}

/// The two multipliers of a pair: `sign` > 0 gives the larger one, or the one above the real axis.
inline std::complex<double> multiplier(std::complex<double> kappa, int sign) {
  const std::complex<double> root = std::sqrt(kappa * (1.0 + kappa));
  return 1.0 + 2.0 * (kappa + double(sign) * root);
}

/**
The pair of the shift in time is removed exactly. Such a shift changes the momenta at $t=0$ by the
force $f$ and arrives at $T_b/2$, where the chain is at rest again, without a change of the positions:
$Bf = 0$, hence $f^TK = 0$. The image of $K$ is perpendicular to $f$, and $K$ restricted to these
vectors has all eigenvalues but the zero of the phase. In the restricted matrix an eigenvalue near
zero is a simple one, so that an error $\delta$ of the flow costs $\delta$. */
/// An orthonormal basis of all vectors perpendicular to `f`, by a Householder reflection.
template <class T>
Matrix<T> perpendicular_to(const Vector<T>& f) {
  Vector<T> u = f / f.norm();
  Eigen::Index top = 0;
  u.cwiseAbs().maxCoeff(&top);
  u[top] += u[top] > T(0) ? T(1) : T(-1);
  u /= u.norm();
  const Matrix<T> all = Matrix<T>::Identity(f.size(), f.size()) - T(2) * u * u.transpose();
  Matrix<T> basis(f.size(), f.size() - 1);
  basis << all.leftCols(top), all.rightCols(f.size() - 1 - top);
  return basis;
}

/**
How well $f^TK$ vanishes, and how well $F$ is symplectic, is kept with the pairs. */
template <class T>
struct Pairs {
  std::vector<std::complex<T>> kappa;  ///< all but that of the phase
  Vector<T> mode;   ///< positions at t = 0 of the mode of kappa.front(), of length one
  T defect{};       ///< of the half-period map, see symplectic_defect
  T phase_error{};  ///< largest entry of f^T K for f of length one
  T pinning() const { return kappa.front().real(); }
};

/**
The pairs are sorted by the modulus of $\kappa$, that is by their distance from $+1$; the first one is
the pinning pair. */
/// Eigenvalues and the first mode of `k` restricted to the vectors perpendicular to `f`.
template <class T>
Pairs<T> pairs_of(const Matrix<T>& k, const Vector<T>& f) {
  const Matrix<T> basis = perpendicular_to(f);
  const Eigen::EigenSolver<Matrix<T>> solver(basis.transpose() * k * basis);
  if (solver.info() != Eigen::Success) throw NoConvergence("no eigenvalues", {});
  std::vector<std::pair<std::complex<T>, Eigen::Index>> all;
  for (Eigen::Index i = 0; i < k.rows() - 1; ++i) all.emplace_back(solver.eigenvalues()[i], i);
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return std::norm(a.first) < std::norm(b.first);
  });
  Pairs<T> pairs;
  for (const auto& one : all) pairs.kappa.push_back(one.first);
  pairs.mode = basis * solver.eigenvectors().col(all.front().second).real();
  pairs.mode /= pairs.mode.norm();
  pairs.phase_error = sup<T>(k.transpose() * f / f.norm());
  return pairs;
}

/**
Together: half a period of the tangent, one product, one eigenvalue problem of half the usual size. */
/// The pairs of an orbit that begins at rest at `start`, even in time, with period `period`. Throws
/// std::invalid_argument where it does not begin at rest, NoConvergence where the flow is inaccurate.
template <class T, class Onsite, class Contact>
Pairs<T> floquet_pairs(const Chain<Onsite, Contact>& chain, const State<T>& start, const T& period,
                       const Landing<T>& rule = {}) {
  for (const T& v : start.v)
    if (v != T(0)) throw std::invalid_argument("the orbit must begin at rest");
  const Matrix<T> half = in_momenta(chain, monodromy(chain, start, period / T(2), rule));
  const std::vector<T> a = accelerations(chain, start.y);
  Vector<T> force(Eigen::Index(a.size()));
  for (std::size_t n = 0; n < a.size(); ++n) force[Eigen::Index(n)] = T(chain.mass_of(n)) * a[n];
  Pairs<T> pairs = pairs_of(pair_matrix(half), force);
  pairs.defect = symplectic_defect(half);
  return pairs;
}

/**
Where a matrix has no structure that we use, all its eigenvalues are computed. */
/// All eigenvalues of a square matrix, in Eigen's order. Throws NoConvergence.
template <class T>
std::vector<std::complex<T>> eigenvalues_of(const Matrix<T>& matrix) {
  const Eigen::EigenSolver<Matrix<T>> solver(matrix, false);
  if (solver.info() != Eigen::Success) throw NoConvergence("no eigenvalues", {});
  return {solver.eigenvalues().begin(), solver.eigenvalues().end()};
}

/**
## Errors

Two computations with different tolerances or types give two values of every $\kappa$. Their difference
is the error, together with the symplectic defect of the finer one, which shows without any
comparison. From $\kappa$ to the multiplier the error grows by $d\lambda/d\kappa \sim \kappa^{-1/2}$, up
to the square root of the error where $\kappa$ is not told from zero. */
struct Pair {
  std::complex<double> kappa;
  double error;
  bool is_unstable() const { return std::abs(kappa.imag()) > error || kappa.real() > error; }
  /// Error of either multiplier.
  double multiplier_error() const {
    const double distance = std::max(std::abs(kappa * (1.0 + kappa)), error);
    return 2 * error * (1 + std::abs(1.0 + 2.0 * kappa) / std::sqrt(distance));
  }
};

/**
Each eigenvalue of the finer computation is compared with the nearest one of the coarser that is not
taken yet. */
/// The pairs with their errors, in the order of `fine`.
template <class C, class T>
std::vector<Pair> compare_pairs(const Pairs<C>& coarse, const Pairs<T>& fine) {
  using Narrow = std::complex<double>;
  std::vector<std::complex<T>> left;
  for (const auto& k : coarse.kappa) left.emplace_back(T(k.real()), T(k.imag()));
  std::vector<Pair> out;
  for (const std::complex<T>& here : fine.kappa) {
    const auto nearest = std::min_element(left.begin(), left.end(), [&](auto a, auto b) {
      return std::norm(a - here) < std::norm(b - here);
    });
    const std::complex<T> apart = *nearest - here;
    left.erase(nearest);
    out.push_back(
        {Narrow(double(here.real()), double(here.imag())),
         std::abs(Narrow(double(apart.real()), double(apart.imag()))) + double(fine.defect)});
  }
  return out;
}

/**
## Two other ways to the pinning pair

Around a bond the reflection of the chain splits all changes into odd ones, with the shift in time
among them, and even ones, with the pinning mode: the block of $K$ on even vectors needs no
restriction. Around a site $F$ and the symmetry $S' = -P$ make a map whose square is $M$; it has the phase
pair at $+1$ and the pinning pair at $-1$. As before, $-PA$ has the mean $\alpha$ of each pair as its
eigenvalue, and $\kappa = \alpha^2 - 1$. */
template <class T>
T pinning_by_symmetry(const Matrix<T>& half, Centre centre) {
  const Eigen::Index n = half.rows() / 2, right = n / 2;
  Matrix<T> block;
  if (centre == Centre::bond) {
    const Matrix<T> k = pair_matrix(half);
    block =
        k.bottomRightCorner(right, right) + k.bottomLeftCorner(right, right).rowwise().reverse();
  } else {
    block = Matrix<T>::Identity(n, n) - Matrix<T>(half.topLeftCorner(n, n).colwise().reverse());
  }
  const std::vector<std::complex<T>> all = eigenvalues_of(block);
  const auto nearer = [](const auto& a, const auto& b) { return std::norm(a) < std::norm(b); };
  const T value = std::min_element(all.begin(), all.end(), nearer)->real();
  return centre == Centre::bond ? value : value * (value - T(2));
}

/**
The same from the monodromy matrix of whatever integrator: each of the four eigenvalues next to $+1$
may be wrong by the root of the matrix's error, but not the sum of $(\lambda-1)^2/\lambda$. It is
$8\kappa$, because the phase pair adds nothing. */
inline double quadruplet_kappa(const Matrix<double>& map) {
  std::vector<std::complex<double>> all = eigenvalues_of(map);
  std::sort(all.begin(), all.end(), [](auto a, auto b) {
    return std::pair(std::abs(a - 1.0), a.imag()) < std::pair(std::abs(b - 1.0), b.imag());
  });
  std::complex<double> sum = 0;
  for (std::size_t i = 0; i < std::min<std::size_t>(4, all.size()); ++i)
    sum += (all[i] - 1.0) * (all[i] - 1.0) / all[i];
  return sum.real() / 8;
}

}  // namespace lattice
