#pragma once
/**
# Potentials

A chain needs two kinds of energy: the well $W(y)$ that holds each bead and the
contact $V(r)$ that couples neighbours, with $r = y_{n+1} - y_n$. Both are small
value types with the same three members, so that a chain is composed at compile
time and its inner loop vectorises:

| member | meaning | well | contact |
|---|---|---|---|
| `energy(x)` | potential energy | $W(y)$ | $V(r)$ |
| `force(x)` | minus its derivative | $-W'(y)$ | $-V'(r) \ge 0$ where beads repel |
| `stiffness(x)` | second derivative | $W''(y)$ | $V''(r)$ |

Every member is a template on the scalar, so the same text serves `double`,
`long double` and 128-bit arithmetic. All quantities are dimensionless: the unit
of time is that of the linear well, the unit of length makes the contact
coefficient one. */

#include <cmath>
#include <variant>

namespace lattice {

/// Linear well, Eq. lp of the article: $W = y^2/2$.
struct Harmonic {
  template <class T>
  T energy(T y) const {
    return y * y / T(2);
  }
  template <class T>
  T force(T y) const {
    return -y;
  }
  template <class T>
  T stiffness(T) const {
    return T(1);
  }
};

/// Anharmonic well, Eq. anpot: $W = y^2/2 + s y^4/4$. For $s < 0$ it has a rim at
/// $|y| = (-s)^{-1/2}$ beyond which the motion runs away.
struct Quartic {
  double s = 0;
  template <class T>
  T energy(T y) const {
    const T y2 = y * y;
    return y2 / T(2) + T(s) / T(4) * (y2 * y2);
  }
  template <class T>
  T force(T y) const {
    return -(y + T(s) * (y * y * y));
  }
  template <class T>
  T stiffness(T y) const {
    return T(1) + T(3) * T(s) * (y * y);
  }
};

/// Gravity on a pendulum, section 3.4: $W = 1 - \cos y$, with rims at odd multiples of $\pi$.
struct Pendulum {
  template <class T>
  T energy(T y) const {
    using std::sin;
    const T half = sin(y / T(2));
    return T(2) * half * half;
  }
  template <class T>
  T force(T y) const {
    using std::sin;
    return -sin(y);
  }
  template <class T>
  T stiffness(T y) const {
    using std::cos;
    return cos(y);
  }
};

/**
Two spheres repel with the 3/2 power of their overlap and do not attract, Eq.
pothertz: $V(r) = \frac25 (-r)_+^{5/2}$. The power is written $x\sqrt x$, which
is one correctly rounded root and one product: the same bits on every machine.

The force carries an explicit `floor`: an overlap at or below it exerts no force
at all. Ahead of a front the displacements fall double-exponentially and would
otherwise crawl through subnormal numbers, which cost ten times as much. With
the default $10^{-60}$ the neglected force is $10^{-90}$, and beads ahead of the
front are at rest *exactly*, so that they need not be integrated. A static
breather whose tail is itself the subject sets `floor = 0`. */
struct Hertz {
  double floor = 1e-60;

  template <class T>
  T overlap(T r) const {
    const T x = -r;
    return x > T(floor) ? x : T(0);
  }
  template <class T>
  T energy(T r) const {
    using std::sqrt;
    const T x = overlap(r);
    return T(2) / T(5) * (x * x * sqrt(x));
  }
  template <class T>
  T force(T r) const {
    using std::sqrt;
    const T x = overlap(r);
    return x * sqrt(x);
  }
  template <class T>
  T stiffness(T r) const {
    using std::sqrt;
    return T(3) / T(2) * sqrt(overlap(r));
  }
  /// Relative displacement at which the beads separate.
  double opening() const { return 0; }
  /// Exponent of the force law.
  static constexpr double exponent = 1.5;
};

/**
A chain squeezed by $d$ at rest keeps its contacts closed under small motion and
gains a phonon band, Eq. pothertzp:
$V(r) = \frac25 (d-r)_+^{5/2} + d^{3/2} r - \frac25 d^{5/2}$. Only the first term
moves beads; the others make $V(0) = V'(0) = 0$. The contact now opens at
$r = d$ instead of $r = 0$. */
struct CompressedHertz {
  double d = 0;

  template <class T>
  T overlap(T r) const {
    const T x = T(d) - r;
    return x > T(0) ? x : T(0);
  }
  template <class T>
  T energy(T r) const {
    using std::sqrt;
    const T x = overlap(r), root = sqrt(T(d));
    return T(2) / T(5) * (x * x * sqrt(x) - T(d) * T(d) * root) + T(d) * root * r;
  }
  template <class T>
  T force(T r) const {
    using std::sqrt;
    const T x = overlap(r);
    return x * sqrt(x) - T(d) * sqrt(T(d));
  }
  template <class T>
  T stiffness(T r) const {
    using std::sqrt;
    return T(3) / T(2) * sqrt(overlap(r));
  }
  double opening() const { return d; }
  static constexpr double exponent = 1.5;
};

/**
Other contacts (cylinders, hollow spheres, rough tips) follow the same law with
another exponent $\alpha > 1$: $V(r) = (d-r)_+^{\alpha+1}/(\alpha+1)$, made
stationary at $r = 0$. The general power is slower and its last bit depends on
the mathematical library, so the 3/2 law has the types of its own. */
struct PowerContact {
  double exponent = 1.5;
  double d = 0;

  template <class T>
  T overlap(T r) const {
    const T x = T(d) - r;
    return x > T(0) ? x : T(0);
  }
  template <class T>
  T energy(T r) const {
    using std::pow;
    const T q = T(exponent) + T(1), x = overlap(r);
    return (pow(x, q) - pow(T(d), q)) / q + pow(T(d), T(exponent)) * r;
  }
  template <class T>
  T force(T r) const {
    using std::pow;
    return pow(overlap(r), T(exponent)) - pow(T(d), T(exponent));
  }
  template <class T>
  T stiffness(T r) const {
    using std::pow;
    const T x = overlap(r);
    return x > T(0) ? T(exponent) * pow(x, T(exponent) - T(1)) : T(0);
  }
  double opening() const { return d; }
};

/// A well chosen at run time; `std::visit` once at the edge of a program.
using AnyOnsite = std::variant<Harmonic, Quartic, Pendulum>;
/// A contact chosen at run time.
using AnyContact = std::variant<Hertz, CompressedHertz, PowerContact>;

}  // namespace lattice
