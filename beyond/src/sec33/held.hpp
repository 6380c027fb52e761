#pragma once
/**
# Breathers without a mirror, held at a centre

Breathers with their centre between a site and a bond (sec33_between.cpp) are at rest at $t = 0$ like the others and
obey $\dot y_n(T_b/2) = 0$, one equation per site; but the derivative of these equations is almost singular, because the
breather can be shifted along the chain almost freely. What is missing is a condition on its place. In return a
parameter $p$ of the chain, $s$ or $\omega_b$, may be left open. So we prescribe the centre $Q$, counted from the middle
of the chain, and solve for the positions and for $p$. The family is the curve $p(Q)$. A reflection about its centre
changes the sign of a bond-centred breather, and that of a site-centred one also exchanges the two times; in either case
$Q$ is exactly the bond or the site, and $p$ there is the branch point. */

#include <cstddef>

#include "lattice/orbits/continuation.hpp"

namespace lattice {

/**
The equations are those of rest after half a period and that of the centre. */
/// The unknowns are the positions at t = 0 and the parameter.
template <class T>
struct Held {
  Shooting<T> problem;   ///< even in time; its value of the parameter is not used
  Along<T> along;        ///< which parameter is unknown
  T centre{};            ///< Q, in sites from the middle of the chain
  double change = 1e-5;  ///< of the central difference in the parameter, see `differentiate`

  std::size_t sites() const { return problem.chain.sites; }
  /// The problem with the parameter among the unknowns.
  Shooting<T> at(const Vector<T>& x) const { return along.at(problem, x[x.size() - 1]); }
  /// The chain at rest at t = 0.
  State<T> start(const Vector<T>& x) const {
    State<T> state(sites());
    for (std::size_t n = 0; n < sites(); ++n) state.y[n] = x[Eigen::Index(n)];
    return state;
  }
  /// As those of `Shooting` (shooting.hpp).
  Sizes<T> sizes(const Vector<T>& x, bool scaled) const;
  Evaluation<T> evaluate(const Vector<T>& x, const EventTolerance<T>& rule,
                         bool with_jacobian = true) const;
  Equations<T> equations() const;

  /**
  `after_half` is the chain half a period after the unknowns; `place` counts from the middle of the chain. */
 private:
  void differentiate(const Vector<T>& x, const EventTolerance<T>& rule, const State<T>& end,
                     const Tangent<T>& tangent, const T& weight, Evaluation<T>& out) const;
  T place(std::size_t n) const { return T(double(n)) - T(double(sites() - 1)) / T(2); }
  State<T> after_half(const Vector<T>& x, const EventTolerance<T>& rule, FlowReport<T>& report,
                      Tangent<T>* tangent) const {
    const Shooting<T> there = at(x);
    State<T> z = start(x);
    report = try_flow(there.chain, z, there.period() / T(2), rule, tangent);
    return z;
  }
};

/**
If Newton's method began with a breather of another centre, its first step would throw the parameter far
away, since it would have to balance a residual that has nothing to do with it. Around a site or a bond the
parameter does not act along the pinning direction at all, and the matrix is even singular. So we first
move the breather at a fixed parameter, and allow the equations to fail along the gradient
$y_{n+1}-y_{n-1}$, which is almost the pinning direction. This failure is as small as the barrier, and
Newton's method on all equations can take over. In double precision it would find the parameter only as
well as rounding compares with the barrier, so callers continue in extended precision. */
/// The unknowns with the centre of `held` and the same parameter, from those near that centre.
template <class T>
Vector<T> moved_to_centre(const Held<T>& held, Vector<T> x, const EventTolerance<T>& rule = {});

}  // namespace lattice
