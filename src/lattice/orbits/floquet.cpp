#include "lattice/orbits/floquet.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>

#include "lattice/algebra/dense.hpp"
#include "lattice/model/precisions.hpp"
#include "lattice/numerics/progress.hpp"

namespace lattice {

/// Velocities and accelerations of a state, one below the other: what a shift in time changes.
template <class T>
static Vector<T> shift_of(const Chain& chain, const State<T>& state) {
  const std::vector<T> a = accelerations(chain, state.y);
  Vector<T> out(Eigen::Index(2 * chain.sites));
  for (std::size_t n = 0; n < chain.sites; ++n) {
    out[Eigen::Index(n)] = state.v[n];
    out[Eigen::Index(chain.sites + n)] = a[n];
  }
  return out;
}

/// The map takes a shift in time of the start to that of the end, whatever the orbit is. By how much it does not,
/// relative to the terms of the product: then the tangent map was computed with other stiffnesses than those of the forces.
template <class T>
static T phase_residual(const Chain& chain, const State<T>& start, const State<T>& end,
                        const Matrix<T>& map) {
  const Vector<T> before = shift_of(chain, start), after = shift_of(chain, end);
  const T terms = sup<T>(map.cwiseAbs() * before.cwiseAbs());
  return sup<T>(map * before - after) / std::max(terms, sup<T>(after));
}

// Carry every small change along with the orbit; an inaccurate flow has no multipliers
template <class T>
Matrix<T> monodromy(const Chain& chain, const State<T>& start,
                    const std::type_identity_t<T>& duration, const EventTolerance<T>& rule) {
  const Progress progress("linearised flow");
  State<T> end = start;
  Tangent<T> tangent(chain.sites, 2 * chain.sites);
  if (!is_accurate(try_flow(chain, end, duration, rule, &tangent), rule))
    throw NewtonFailed("the flow is not accurate enough for multipliers", {});
  const auto n = Eigen::Index(2 * chain.sites);
  Matrix<T> map = Eigen::Map<Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
      tangent.entries.data(), n, n);
  const T off = phase_residual(chain, start, end, map);
  if (off > T(1e4) * std::max(rule.tolerance, std::numeric_limits<T>::epsilon()))
    throw NewtonFailed(
        number_label("the linearised flow does not reproduce a shift in time, by", double(off)) +
            ": the stiffness of a well or a contact is not minus the derivative of its force",
        {});
  return map;
}

/// The derivative in positions and momenta: velocities are multiplied by the masses.
template <class T>
static Matrix<T> in_momenta(const Chain& chain, Matrix<T> f) {
  const auto n = Eigen::Index(chain.sites);
  for (Eigen::Index i = 0; i < n && chain.variation; ++i) {
    f.row(n + i) *= T(chain.mass_of(std::size_t(i)));
    f.col(n + i) /= T(chain.mass_of(std::size_t(i)));
  }
  return f;
}

/// In positions and momenta the derivative of a Hamiltonian flow is symplectic, $F^T\Omega F = \Omega$ with
/// $\Omega = \bigl(\begin{smallmatrix} 0 & 1\\ -1 & 0\end{smallmatrix}\bigr)$. By how much it is not.
template <class T>
static T symplectic_error(const Matrix<T>& f) {
  const Eigen::Index n = f.rows() / 2;
  Matrix<T> turned(2 * n, 2 * n);
  turned << f.bottomRows(n), -f.topRows(n);
  Matrix<T> wrong = f.transpose() * turned;
  wrong.topRightCorner(n, n).diagonal().array() -= T(1);
  wrong.bottomLeftCorner(n, n).diagonal().array() += T(1);
  return sup<T>(wrong.reshaped());
}

/// K = B^T C of a half-period map in momenta.
template <class T>
static Matrix<T> pair_matrix(const Matrix<T>& half) {
  const Eigen::Index n = half.rows() / 2;
  const Matrix<T> above = half.topRightCorner(n, n), below = half.bottomLeftCorner(n, n);
  return above.transpose() * below;
}

std::complex<double> multiplier(std::complex<double> kappa, int sign) {
  const std::complex<double> root = std::sqrt(kappa * (1.0 + kappa));
  return 1.0 + 2.0 * (kappa + double(sign) * root);
}

// A reflection takes f to the axis nearest to it, and the other axes to a basis perpendicular to f
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

// A vector of length one that `matrix` multiplies by its simple, real eigenvalue `value`, by inverse iteration. The shift
// misses the value by a little, or there would be nothing to solve; the vector that we begin with has no symmetry
template <class T>
static Vector<T> eigenvector_of(const Matrix<T>& matrix, const T& value) {
  const Eigen::Index n = matrix.rows();
  const T shift = value + 8 * std::numeric_limits<T>::epsilon() * matrix.cwiseAbs().maxCoeff();
  const Matrix<T> shifted = matrix - shift * Matrix<T>::Identity(n, n);
  Vector<T> x = Vector<T>::LinSpaced(n, T(1), T(2));
  for (int pass = 0; pass < 3; ++pass) x = solve_square<T>(shifted, x).normalized();
  return x;
}

// Without the direction `f` of the phase the pinning pair is a simple eigenvalue
template <class T>
static MultiplierPairs<T> pairs_of(const Matrix<T>& k, const Vector<T>& f) {
  const Matrix<T> basis = perpendicular_to(f);
  const Matrix<T> rows = basis.transpose() * k, restricted = rows * basis;
  MultiplierPairs<T> pairs;
  pairs.kappa = eigenvalues_of(restricted);
  // The pinning pair is the one nearest to +1, with the smallest kappa; its mode is what shifts the breather
  std::stable_sort(pairs.kappa.begin(), pairs.kappa.end(),
                   [](const auto& a, const auto& b) { return std::norm(a) < std::norm(b); });
  pairs.mode = basis * eigenvector_of<T>(restricted, pairs.pinning());
  pairs.mode /= pairs.mode.norm();
  return pairs;
}

// An orbit at rest twice a period needs only half of it
template <class T>
MultiplierPairs<T> floquet_pairs(const Chain& chain, const State<T>& start,
                                 const std::type_identity_t<T>& period,
                                 const EventTolerance<T>& rule) {
  for (const T& v : start.v)
    if (v != T(0)) throw std::invalid_argument("the orbit must begin at rest");
  const Matrix<T> half = in_momenta(chain, monodromy<T>(chain, start, period / T(2), rule));
  const Progress progress("pairs of multipliers");
  // A shift in time changes the momenta along the force: this is the direction to leave out
  const std::vector<T> a = accelerations(chain, start.y);
  Vector<T> force(Eigen::Index(a.size()));
  for (std::size_t n = 0; n < a.size(); ++n) force[Eigen::Index(n)] = T(chain.mass_of(n)) * a[n];
  MultiplierPairs<T> pairs = pairs_of(pair_matrix(half), force);
  pairs.symplectic_error = symplectic_error(half);
  return pairs;
}

// Beside each kappa of the finer run, the nearest one of the coarser that is still free
template <class C, class T>
std::vector<MultiplierPair> pairs_with_errors(const MultiplierPairs<C>& coarse,
                                              const MultiplierPairs<T>& fine) {
  using Narrow = std::complex<double>;
  std::vector<std::complex<T>> left;
  for (const auto& k : coarse.kappa) left.emplace_back(T(k.real()), T(k.imag()));
  std::vector<MultiplierPair> out;
  for (const std::complex<T>& here : fine.kappa) {
    const auto nearest = std::min_element(left.begin(), left.end(), [&](auto a, auto b) {
      return std::norm(a - here) < std::norm(b - here);
    });
    const std::complex<T> apart = *nearest - here;
    left.erase(nearest);
    out.push_back({Narrow(double(here.real()), double(here.imag())),
                   std::abs(Narrow(double(apart.real()), double(apart.imag()))) +
                       double(fine.symplectic_error)});
  }
  return out;
}

// Of a pair the first multiplier is the larger one beyond +1, the second one beyond -1
Estimate excess(const std::vector<MultiplierPair>& pairs, std::size_t first) {
  double found = 0, least = 0, most = 0;
  for (std::size_t k = first; k < pairs.size(); ++k) {
    const double error = pairs[k].multiplier_error();
    for (int sign : {1, -1}) {
      const double beyond = std::abs(multiplier(pairs[k].kappa, sign)) - 1;
      found = std::max(found, beyond), least = std::max(least, beyond - error);
      most = std::max(most, beyond + error);
    }
  }
  return {found, std::max(found - least, most - found)};
}

#define LIST(T)                                                                           \
  template Matrix<T> monodromy<T>(const Chain&, const State<T>&, const T&,                \
                                  const EventTolerance<T>&);                              \
  template Matrix<T> perpendicular_to<T>(const Vector<T>&);                               \
  template MultiplierPairs<T> floquet_pairs<T>(const Chain&, const State<T>&, const T&,   \
                                               const EventTolerance<T>&);                 \
  template std::vector<MultiplierPair> pairs_with_errors<T, T>(const MultiplierPairs<T>&, \
                                                               const MultiplierPairs<T>&);
LATTICE_IN_EACH_PRECISION(LIST)
#undef LIST

}  // namespace lattice
