#pragma once
/**
# Periodic orbits by least squares

The direct way to a periodic orbit is to ask that $Y(T) = Y(0)$ and nothing else. Starting from
rest there are twice as many equations as unknowns, which are solved in the sense of least
squares. This file keeps that method for comparison with the symmetric one of periodic.hpp,
together with the few measures by which the two are compared. */

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "lattice/orbits/shooting.hpp"
#include "lattice/stepping/reference.hpp"

namespace lattice {

/// Largest difference of two states.
template <class T>
T largest_difference(const State<T>& a, const State<T>& b) {
  T most(0);
  for (std::size_t n = 0; n < a.y.size(); ++n)
    most = std::max({most, magnitude<T>(a.y[n] - b.y[n]), magnitude<T>(a.v[n] - b.v[n])});
  return most;
}

/// A chain at rest.
inline State<double> resting(const std::vector<double>& y) {
  State<double> state(y.size());
  state.y = y;
  return state;
}

/// Cosine of the angle between two directions, without sign.
inline double alignment(const Vector<double>& a, const Vector<double>& b) {
  return std::abs(a.dot(b)) / (a.norm() * b.norm());
}

/// Discrete gradient of a profile.
inline Vector<double> gradient(const State<double>& state) {
  const long n = long(state.y.size());
  Vector<double> g = Vector<double>::Zero(n);
  for (long i = 1; i + 1 < n; ++i) g[i] = state.y[std::size_t(i + 1)] - state.y[std::size_t(i - 1)];
  return g;
}

/// Condition number of a matrix.
inline double condition(const Matrix<double>& matrix) {
  const Vector<double> s = Eigen::JacobiSVD<Matrix<double>>(matrix).singularValues();
  return s[0] / s[s.size() - 1];
}

/**
The singular value decomposition of the period map's matrix gives the step and shows in which
direction the equations say least. */
struct LeastSquares {
  History history{};
  State<double> start{};
  Eigen::JacobiSVD<Matrix<double>> svd{};  ///< of the last matrix

  long last() const { return long(start.y.size()) - 1; }
  double condition() const { return svd.singularValues()[0] / svd.singularValues()[last()]; }
  /// Positions of the direction that costs least.
  Vector<double> softest() const { return svd.matrixV().col(last()); }
};

template <class Onsite, class Contact>
LeastSquares gauss_newton(const Shooting<double, Onsite, Contact>& problem, State<double> start,
                          int most) {
  const std::size_t n = problem.chain.sites;
  LeastSquares out;
  for (int k = 0;; ++k) {
    State<double> end = start;
    Tangent<double> tangent(n, n);
    flow(problem.chain, end, problem.period(), {}, &tangent);
    Matrix<double> jacobian(2 * n, n);
    Vector<double> miss(2 * n);
    for (std::size_t i = 0; i < 2 * n; ++i) {
      miss[long(i)] = i < n ? end.y[i] - start.y[i] : end.v[i - n];
      for (std::size_t j = 0; j < n; ++j) jacobian(long(i), long(j)) = tangent(i, j) - (i == j);
    }
    out.svd.compute(jacobian, Eigen::ComputeThinU | Eigen::ComputeThinV);
    const Vector<double> step = out.svd.solve(miss);
    out.history.push_back({sup(miss) / largest(start), sup(step) / largest(start)});
    out.start = start;
    if (k == most) return out;
    for (std::size_t j = 0; j < n; ++j) start.y[j] -= step[long(j)];
  }
}

/**
What becomes of a breather if it is computed with an adaptive integration that knows nothing of the
switchings? Newton's method for the symmetric equations or, if `full`, for the period map begins at
the exact orbit and uses its matrix. Returns the energy and the residual it is left with. */
template <class Onsite, class Contact>
std::pair<double, double> plain_newton(const Shooting<double, Onsite, Contact>& problem,
                                       const Orbit<double>& orbit, bool full,
                                       const Tolerance& tolerance) {
  const std::size_t n = problem.chain.sites;
  const LeastSquares exact = gauss_newton(problem, orbit.start, 0);
  const auto lu = shoot(problem, orbit.x, {}).jacobian.partialPivLu();
  State<double> start = orbit.start;
  double residual = 0;
  for (int k = 0; k < 6; ++k) {
    State<double> end = start;
    evolve_reference(problem.chain, end, problem.period() / (full ? 1 : problem.parts()),
                     tolerance);
    std::vector<double> z = end.y, z0 = start.y;
    z.insert(z.end(), end.v.begin(), end.v.end());
    z0.resize(2 * n, 0.0);
    const auto pairs = equations_of(problem.centre, n);
    Vector<double> miss(full ? 2 * n : pairs.size());
    for (std::size_t i = 0; i < std::size_t(miss.size()); ++i)
      miss[long(i)] = full ? z[i] - z0[i] : z[pairs[i].first] + pairs[i].sign * z[pairs[i].second];
    residual = sup(miss) / orbit.amplitude;
    const Vector<double> x = problem.fold(start.y);
    if (!full) start = problem.unfold(x - lu.solve(miss));
    if (!full) continue;
    const Vector<double> step = exact.svd.solve(miss);
    for (std::size_t j = 0; j < n; ++j) start.y[j] -= step[long(j)];
  }
  return {energy(problem.chain, start), residual};
}

}  // namespace lattice
