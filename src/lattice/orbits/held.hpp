#pragma once
/**
# Breathers without a mirror, held at a centre

Where the breather around a site and the one around a bond exchange their stability, breathers in
between may exist, around no symmetric point of the chain. They rest at $t = 0$ like the others and
obey $\dot y_n(T_b/2) = 0$, one equation a site; but the derivative of these equations is almost singular,
because the breather can be shifted along the chain almost freely. What it lacks is a condition on the
place, and what is determined in return is a parameter $p$ of the chain, $s$ or $\omega_b$. So we
prescribe the centre
$$Q = \frac{\sum_n n\,\bigl(y_n(0)^2 + y_n(T_b/2)^2\bigr)}{\sum_n \bigl(y_n(0)^2+y_n(T_b/2)^2\bigr)},$$
counted from the middle of the chain, and solve for the positions and for $p$. The family is the
curve $p(Q)$. Around a site and around a bond the reflection exchanges the two times up to the sign of
$y$, so that $Q$ is the site or the bond exactly; there $p$ is the branch point. */

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "lattice/orbits/continuation.hpp"

namespace lattice {

/**
The unknowns are the positions at $t = 0$ and the parameter, the equations those of rest after half a
period and that of the centre. */
/// A problem in the sense of newton.hpp. The unknowns are the positions at t = 0 and the parameter.
template <class P>
struct Held {
  using Scalar = typename P::Scalar;
  using T = Scalar;
  P problem;             ///< even in time; its value of the parameter is not used
  Along<P> along;        ///< which parameter is unknown
  T centre{};            ///< Q, in sites from the middle of the chain
  double change = 1e-5;  ///< of the central difference in the parameter

  std::string name() const { return "breather held at a centre"; }
  std::size_t sites() const { return problem.chain.sites; }
  P at(const Vector<T>& x) const { return along.at(problem, x[x.size() - 1]); }
  State<T> start(const Vector<T>& x) const {
    State<T> state(sites());
    for (std::size_t n = 0; n < sites(); ++n) state.y[n] = x[Eigen::Index(n)];
    return state;
  }
  Sizes<T> sizes(const Vector<T>& x, bool graded) const;
  Shot<T> shoot(const Vector<T>& x, const Landing<T>& rule, bool with_jacobian = true) const;

  /**
  Half a period from the unknowns; places are counted from the middle of the chain. */
 private:
  void differentiate(const Vector<T>& x, const Landing<T>& rule, const State<T>& end,
                     const Tangent<T>& tangent, const T& weight, Shot<T>& shot) const;
  T place(std::size_t n) const { return T(double(n)) - T(double(sites() - 1)) / T(2); }
  State<T> fly(const Vector<T>& x, const Landing<T>& rule, Flow<T>& report,
               Tangent<T>* tangent) const {
    const P there = at(x);
    State<T> z = start(x);
    report = flow(there.chain, z, there.period() / T(2), rule, tangent);
    return z;
  }
};

/**
Positions and their equations are measured as in any other problem, the parameter and the centre in
units of one. */
template <class P>
Sizes<typename P::Scalar> Held<P>::sizes(const Vector<T>& x, bool graded) const {
  const Sizes<T> inner = problem.sizes(x.head(x.size() - 1), graded);
  Sizes<T> out{Vector<T>::Ones(x.size()), Vector<T>::Ones(x.size())};
  out.unknown.head(x.size() - 1) = inner.unknown;
  out.equation.head(x.size() - 1) = inner.equation;
  return out;
}

/**
The last equation is that of the centre. Its derivative needs the positions at $T_b/2$ as well, and
these are in the same columns of the tangent. */
template <class P>
Shot<typename P::Scalar> Held<P>::shoot(const Vector<T>& x, const Landing<T>& rule,
                                        bool with_jacobian) const {
  const std::size_t n = sites();
  const auto last = Eigen::Index(n);
  Tangent<T> tangent(n, with_jacobian ? n : 0);
  Shot<T> shot;
  const State<T> end = fly(x, rule, shot.flow, with_jacobian ? &tangent : nullptr);
  T weight(0), moment(0);
  for (std::size_t i = 0; i < n; ++i) {
    const T w = x[Eigen::Index(i)] * x[Eigen::Index(i)] + end.y[i] * end.y[i];
    weight += w;
    moment += w * place(i);
  }
  shot.miss.resize(last + 1);
  for (std::size_t i = 0; i < n; ++i) shot.miss[Eigen::Index(i)] = end.v[i];
  shot.miss[last] = moment / weight - centre;
  if (with_jacobian) differentiate(x, rule, end, tangent, weight, shot);
  return shot;
}

/**
For a parameter other than the frequency the chain offers no derivative, and we take a central
difference. Its step is small, because almost nothing in these equations fixes $p$: their derivative
along the pinning direction is as small as the barrier. */
template <class P>
void Held<P>::differentiate(const Vector<T>& x, const Landing<T>& rule, const State<T>& end,
                            const Tangent<T>& tangent, const T& weight, Shot<T>& shot) const {
  const std::size_t n = sites();
  const auto last = Eigen::Index(n);
  Vector<T> more = x, less = x;
  more[last] += T(change);
  less[last] -= T(change);
  Flow<T> unused;
  const State<T> up = fly(more, rule, unused, nullptr), down = fly(less, rule, unused, nullptr);
  shot.jacobian = Matrix<T>::Zero(last + 1, last + 1);
  for (std::size_t i = 0; i < n; ++i) {
    const auto row = Eigen::Index(i);
    const T lever = T(2) * (place(i) - centre - shot.miss[last]) / weight;
    for (std::size_t k = 0; k < n; ++k) {
      shot.jacobian(row, Eigen::Index(k)) = tangent(n + i, k);
      shot.jacobian(last, Eigen::Index(k)) += lever * end.y[i] * tangent(i, k);
    }
    shot.jacobian(last, row) += lever * x[row];
    shot.jacobian(row, last) = (up.v[i] - down.v[i]) / (T(2) * T(change));
    shot.jacobian(last, last) += lever * end.y[i] * (up.y[i] - down.y[i]) / (T(2) * T(change));
  }
}

/**
From a breather with another centre Newton's first step would throw the parameter far away, since it is
asked to balance a residual that has nothing to do with it; around a site or a bond, where the
parameter does not act along the pinning direction at all, the matrix is even singular. So we first move
the breather with the parameter as it is, and leave open what remains of the equations along the
gradient $y_{n+1}-y_{n-1}$, almost the pinning direction. What remains is as small as the barrier, and
Newton's method on all equations takes over. In double precision it finds the parameter only as well as
rounding compares with the barrier; so a wider type takes over as soon as the breather is moved. */
/// The unknowns with the centre of `held` and the same parameter, from those near that centre.
template <class P, class T = typename P::Scalar>
Vector<T> moved_to_centre(const Held<P>& held, Vector<T> x, const Landing<T>& landing = {}) {
  const Eigen::Index n = x.size() - 1;
  for (int k = 0; k < 4; ++k) {
    const Shot<T> shot = held.shoot(x, landing);
    Matrix<T> matrix = shot.jacobian;
    for (Eigen::Index i = 0; i < n; ++i)
      matrix(i, n) = i > 0 && i + 1 < n ? x[i + 1] - x[i - 1] : T(0);
    matrix(n, n) = T(0);
    const Vector<T> step = solve_scaled<T>(matrix, shot.miss, held.sizes(x, true), 0);
    x.head(n) -= step.head(n);
  }
  return x;
}

}  // namespace lattice
