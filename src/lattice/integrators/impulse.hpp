#pragma once
/**
# The impulse of a contact that switches

While its overlap $x$ is positive a contact pushes with $F = \eta\,x^\alpha$; otherwise it is open. What it
does to a bead of unit mass in a step of length one is
$$\Delta v = \int_0^1 F\,ds, \qquad \Delta y = \int_0^1 (1-s)\,F\,ds,$$
since a push at $s$ has the time $1-s$ left to move the bead. Weights made for smooth forces give neither
well if $x$ passes through zero at some $s^*$, where $F \sim (s-s^*)_+^\alpha$. Here both are computed from
the overlap, its rate and its acceleration at the two ends of the step, in three parts: an interpolation,
its roots, and a quadrature to which the singular point does no harm. event_corrected.hpp puts such impulses
into its steps. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "lattice/numerics/ieee.hpp"

namespace lattice {

/**
Inside the step, at $t = s h$ with $0 \le s \le 1$, we take the overlap from the quintic with the right values
$x$, rates $w = dx/ds$ and accelerations $2g = d^2x/ds^2$ at both ends. The true overlap contains
$(t-t^*)_+^{\alpha+2}$, so for spheres the quintic errs by $O(h^{7/2})$. Near $t^*$ the slope of the force
is $O(h^{1/2})$; over a step the impulse therefore errs by $O(h^5)$ only. */
template <class T>
struct Quintic {
  T x0, w0, g0, x1, w1, g1;  ///< at s = 0 and at s = 1
  T d = x1 - (x0 + w0 + g0), e = w1 - (w0 + T(2) * g0), f = g1 - g0;
  T c3 = T(10) * d - T(4) * e + f, c4 = T(7) * e - T(15) * d - T(2) * f;
  T c5 = T(6) * d - T(3) * e + f;
  /// The overlap at s.
  T operator()(T s) const { return x0 + s * (w0 + s * (g0 + s * (c3 + s * (c4 + s * c5)))); }
  /// Its derivative by s.
  T slope(T s) const {
    return w0 + s * (T(2) * g0 + s * (T(3) * c3 + s * (T(4) * c4 + s * T(5) * c5)));
  }
  /// Where it turns round between `low` and `high`, by bisection.
  T turn(T low, T high) const {
    const bool rises = slope(low) > T(0);
    for (int i = 0; i < 24; ++i) {
      const T middle = (low + high) / T(2);
      ((slope(middle) > T(0)) == rises ? low : high) = middle;
    }
    return low;
  }
  /// The largest modulus in the step, in which it turns round once at most.
  T farthest() const {
    const T ends = std::max(std::abs(x0), std::abs(x1));
    return (w0 > T(0)) != (w1 > T(0)) ? std::max(ends, std::abs((*this)(turn(T(0), T(1))))) : ends;
  }
};

/**
The contact switches at the root $s^*$ of the quintic, where its impulse begins or ends. Newton's method
finds it in a few steps, and bisection replaces every step that would leave the bracket (`lo`, `hi`). A
last move below $10^{-5}$ is enough, because the next one would be of the order of its square. */
/// `below` and `above` are the overlaps at `lo` and `hi`.
template <class T>
T root_between(const Quintic<T>& x, T lo, T hi, T below, T above) {
  T s = lo + (hi - lo) * (below / (below - above)), move(1);
  for (int k = 0; k < 60 && std::abs(double(move)) > 1e-5; ++k) {
    const T value = x(s), newton = s - value / x.slope(s);
    ((value > T(0)) == (above > T(0)) ? hi : lo) = s;
    const T next = newton > lo && newton < hi ? newton : (lo + hi) / T(2);
    move = next - s;
    s = next;
  }
  return s;
}

/// What a force does to a bead in a step: $\int F\,ds$ to its velocity, $\int (1-s) F\,ds$ to its
/// position, and $\int \frac12 (1-s)^2 F\,ds$ to the integral of its position over the step.
template <class T>
struct Impulse {
  T velocity{}, position{}, shift{};
  T reach{};  ///< the overlap where it turns round in the step, and any larger one that was met
};

/// Gauss-Legendre with eight nodes in (-1, 1), and their weights.
inline constexpr double gauss_node[]{
    -0.18343464249564981, -0.52553240991632899, -0.79666647741362674, -0.96028985649753623,
    0.18343464249564981,  0.52553240991632899,  0.79666647741362674,  0.96028985649753623};
inline constexpr double gauss_weight[]{
    0.36268378337836198, 0.31370664587788729, 0.22238103445337447, 0.10122853629037626,
    0.36268378337836198, 0.31370664587788729, 0.22238103445337447, 0.10122853629037626};

/**
These integrals are computed by Gauss quadrature. At the singular point it would fail for the same reason
as the scheme, but here we may change the variable. With $s = s^* \pm u^2$ the overlap is $u^2$ times a
smooth positive $q$, so that $F\,ds = 2 u^{2\alpha+1} q^\alpha\,du$ is smooth whenever $2\alpha$ is an
integer. For any other exponent we take $u^4$ (`fourth`), which leaves at least seven derivatives. The
same change of variable serves a piece $(a, b)$ whose root $s^*$ lies somewhat outside. */
template <class T, class Push>
void add_piece(const Push& push, T a, T b, T root, bool fourth, Impulse<T>& sum) {
  using std::abs;
  using std::sqrt;
  const T side = root <= a ? T(1) : T(-1);
  T ua = sqrt(abs(a - root)), ub = sqrt(abs(b - root));
  if (fourth) ua = sqrt(ua), ub = sqrt(ub);
  const T middle = (ua + ub) / T(2), half = abs(ub - ua) / T(2);
  // Two loops, because the compiler vectorises the first one and the sums have one order
  T push_ds[8], rest[8];
  for (std::size_t k = 0; k < 8; ++k) {
    const T u = middle + half * T(gauss_node[k]), u2 = u * u;
    const T s = root + side * (fourth ? u2 * u2 : u2);
    const T ds = half * T(gauss_weight[k]) * (fourth ? T(4) * u2 * u : T(2) * u);
    push_ds[k] = push(s) * ds;
    rest[k] = T(1) - s;
  }
  for (std::size_t k = 0; k < 8; ++k) {
    sum.velocity += push_ds[k];
    sum.position += rest[k] * push_ds[k];
    sum.shift += rest[k] * rest[k] / T(2) * push_ds[k];
  }
}

/**
Now the impulse over the whole step is put together. While the contact is closed, $x > 0$, it acts from
one root of the quintic to the next. We look for changes of sign between the `probe` points, and inside the
step also where it turns round between two of them: a contact may be shorter than their distance. Roots more
than a step outside do not matter, since the force is smooth enough for the eight nodes. A piece between
two roots is cut in the middle, and each half is referred to its own root. */
/// `push(s)` is the force at s while the contact is closed; `fourth` where twice its exponent is no integer.
template <class T, class Push>
Impulse<T> exact_impulse(const Quintic<T>& x, const Push& push, bool fourth) {
  static constexpr double probe[]{-1, -0.5, 0, 0.25, 0.5, 0.75, 1, 1.5, 2};
  T at[std::size(probe)];
  for (std::size_t k = 0; k < std::size(probe); ++k) at[k] = x(T(probe[k]));
  // With both ends on one side it may be on the other one where it turns round
  const T out = x.x0 > T(0) ? T(1) : T(-1);
  T turn(2);
  Impulse<T> sum;
  if (out * x.x1 > T(0) && out * x.w0 < T(0) && out * x.w1 > T(0))
    turn = x.turn(T(0), T(1)), sum.reach = x(turn);
  T left(-1);
  bool closed = at[0] > T(0), left_root = false;
  const auto stretch = [&](T right, bool right_root) {
    const T a = left > T(0) ? left : T(0), b = right < T(1) ? right : T(1);
    if (!(a < b)) return;
    const T cut = !right_root ? b : (left_root ? (a + b) / T(2) : a);
    if (a < cut) add_piece(push, a, cut, left, fourth, sum);
    if (cut < b) add_piece(push, cut, b, right, fourth, sum);
  };
  T low(probe[0]), below = at[0];
  for (std::size_t k = 1; k < std::size(probe); ++k) {
    T high(probe[k]), above = at[k];
    if (low < turn && turn < high && (sum.reach > T(0)) != closed && (above > T(0)) == closed)
      high = turn, above = sum.reach, --k;
    if ((above > T(0)) != closed) {
      const T root = root_between(x, low, high, below, above);
      if (closed) stretch(root, true);
      left = root, left_root = true, closed = !closed;
    }
    low = high, below = above;
  }
  if (closed) stretch(T(2), false);
  return sum;
}

}  // namespace lattice
