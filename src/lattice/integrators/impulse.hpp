#pragma once
/**
# The impulse of a contact that switches

While its overlap $x$ is positive a contact pushes with $F = \eta\,x^\alpha$; otherwise it is open. What it
does to a bead of unit mass in a step of length one is
$$\Delta v = \int_0^1 F\,ds, \qquad \Delta y = \int_0^1 (1-s)\,F\,ds,$$
since a push at $s$ has the time $1-s$ left to move the bead. Both are computed from the overlap, its rate and its
acceleration at the two ends of the step: an interpolation, its roots, and a quadrature to which the singular point
of the force does no harm. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "lattice/numerics/ieee.hpp"

namespace lattice {

/**
Inside the step, at $t = s h$ with $0 \le s \le 1$, the overlap is the quintic with the right values
$x$, rates $w = dx/ds$ and accelerations $2g = d^2x/ds^2$ at both ends. The true overlap contains
$(t-t^*)_+^{\alpha+2}$, so for spheres the quintic errs by $O(h^{7/2})$, and the impulse of a step by $O(h^5)$. */
struct Quintic {
  double x0, w0, g0, x1, w1, g1;  ///< at s = 0 and at s = 1
  double d = x1 - (x0 + w0 + g0), e = w1 - (w0 + 2 * g0), f = g1 - g0;
  double c3 = 10 * d - 4 * e + f, c4 = 7 * e - 15 * d - 2 * f, c5 = 6 * d - 3 * e + f;
  /// The overlap at s.
  double operator()(double s) const {
    return x0 + s * (w0 + s * (g0 + s * (c3 + s * (c4 + s * c5))));
  }
  /// Its derivative by s.
  double slope(double s) const {
    return w0 + s * (2 * g0 + s * (3 * c3 + s * (4 * c4 + s * 5 * c5)));
  }
  /// Where it turns round in the step, by bisection.
  double turn() const {
    double low = 0, high = 1;
    const bool rises = slope(low) > 0;
    for (int i = 0; i < 24; ++i) {
      const double middle = (low + high) / 2;
      ((slope(middle) > 0) == rises ? low : high) = middle;
    }
    return low;
  }
};

/// The root of the quintic between `lo` and `hi`, where it is `below` and `above`: Newton's method, with bisection for
/// steps that would leave the bracket. After a move below 1e-5 the next one is of the order of its square.
inline double root_between(const Quintic& x, double lo, double hi, double below, double above) {
  double s = lo + (hi - lo) * (below / (below - above)), move = 1;
  for (int k = 0; k < 60 && std::abs(move) > 1e-5; ++k) {
    const double value = x(s), newton = s - value / x.slope(s);
    ((value > 0) == (above > 0) ? hi : lo) = s;
    const double next = newton > lo && newton < hi ? newton : (lo + hi) / 2;
    move = next - s;
    s = next;
  }
  return s;
}

/// What a force does to a bead in a step: $\int F\,ds$ to its velocity, $\int (1-s) F\,ds$ to its
/// position, and $\int \frac12 (1-s)^2 F\,ds$ to the integral of its position over the step.
struct Impulse {
  double velocity = 0, position = 0, shift = 0;
  double reach =
      0;  ///< the overlap where it turns round in the step, and any larger one that was met
};

/// Gauss-Legendre with eight nodes in (-1, 1), and their weights.
inline constexpr double gauss_node[]{
    -0.18343464249564981, -0.52553240991632899, -0.79666647741362674, -0.96028985649753623,
    0.18343464249564981,  0.52553240991632899,  0.79666647741362674,  0.96028985649753623};
inline constexpr double gauss_weight[]{
    0.36268378337836198, 0.31370664587788729, 0.22238103445337447, 0.10122853629037626,
    0.36268378337836198, 0.31370664587788729, 0.22238103445337447, 0.10122853629037626};

/**
Gauss quadrature would fail at the singular point, so the variable is changed. With $s = s^* \pm u^2$ the overlap is
$u^2$ times a smooth positive $q$, and $F\,ds = 2 u^{2\alpha+1} q^\alpha\,du$ is smooth whenever $2\alpha$ is an
integer. For any other exponent we take $u^4$ (`fourth`), which leaves at least seven derivatives. The
root $s^*$ of a piece $(a, b)$ may lie somewhat outside of it. */
template <class Push>
void add_piece(const Push& push, double a, double b, double root, bool fourth, Impulse& sum) {
  const double side = root <= a ? 1 : -1;
  double ua = std::sqrt(std::abs(a - root)), ub = std::sqrt(std::abs(b - root));
  if (fourth) ua = std::sqrt(ua), ub = std::sqrt(ub);
  const double middle = (ua + ub) / 2, half = std::abs(ub - ua) / 2;
  // Two loops, because the compiler vectorises the first one and the sums have one order
  double push_ds[8], rest[8];
  for (std::size_t k = 0; k < 8; ++k) {
    const double u = middle + half * gauss_node[k], u2 = u * u;
    const double s = root + side * (fourth ? u2 * u2 : u2);
    const double ds = half * gauss_weight[k] * (fourth ? 4 * u2 * u : 2 * u);
    push_ds[k] = push(s) * ds;
    rest[k] = 1 - s;
  }
  for (std::size_t k = 0; k < 8; ++k) {
    sum.velocity += push_ds[k];
    sum.position += rest[k] * push_ds[k];
    sum.shift += rest[k] * rest[k] / 2 * push_ds[k];
  }
}

/**
While the contact is closed, $x > 0$, it acts from one root of the quintic to the next. We look for changes of sign
between the `probe` points, and where the overlap turns round between two of them: a contact may be shorter than their
distance. Roots more than a step outside do not matter, since the force is smooth enough for the eight nodes. A piece
between two roots is cut in the middle, and each half is referred to its own root. */
/// The impulse over the whole step. `push(s)` is the force at s while the contact is closed; `fourth` where twice its
/// exponent is no integer.
template <class Push>
Impulse exact_impulse(const Quintic& x, const Push& push, bool fourth) {
  static constexpr double probe[]{-1, -0.5, 0, 0.25, 0.5, 0.75, 1, 1.5, 2};
  double at[std::size(probe)];
  for (std::size_t k = 0; k < std::size(probe); ++k) at[k] = x(probe[k]);
  // With both ends on one side it may be on the other one where it turns round
  const double out = x.x0 > 0 ? 1 : -1;
  double turn = 2;
  Impulse sum;
  if (out * x.x1 > 0 && out * x.w0 < 0 && out * x.w1 > 0) turn = x.turn(), sum.reach = x(turn);
  double left = -1;
  bool closed = at[0] > 0, left_root = false;
  const auto stretch = [&](double right, bool right_root) {
    const double a = left > 0 ? left : 0, b = right < 1 ? right : 1;
    if (!(a < b)) return;
    const double cut = !right_root ? b : (left_root ? (a + b) / 2 : a);
    if (a < cut) add_piece(push, a, cut, left, fourth, sum);
    if (cut < b) add_piece(push, cut, b, right, fourth, sum);
  };
  double low = probe[0], below = at[0];
  for (std::size_t k = 1; k < std::size(probe); ++k) {
    double high = probe[k], above = at[k];
    if (low < turn && turn < high && (sum.reach > 0) != closed && (above > 0) == closed)
      high = turn, above = sum.reach, --k;
    if ((above > 0) != closed) {
      const double root = root_between(x, low, high, below, above);
      if (closed) stretch(root, true);
      left = root, left_root = true, closed = !closed;
    }
    low = high, below = above;
  }
  if (closed) stretch(2, false);
  return sum;
}

}  // namespace lattice
