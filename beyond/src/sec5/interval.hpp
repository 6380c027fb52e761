#pragma once
/**
# Numbers with two ends

A proof by computer needs bounds that no rounding can break. An interval $[a, b]$ stands for every number
between its ends, and each operation returns an interval that holds all possible results.

We round to nearest, as everywhere in this repository, and step outwards: if $x$ is the rounded result of one
operation, the exact result lies between the neighbours of $x$ among the numbers of the format, and
`std::nextafter` finds them. That costs one unit in the last place and needs no rounding mode of the
processor. Libraries that switch the rounding mode are only as good as the compiler's respect for the switch:
unless `-frounding-math` is given, GCC evaluates constants and merges equal expressions as if there were one
mode, and both ends of the interval for $1/3$ become the same number. A test shows this for Boost.Interval and
shows that ours stays sound.

What is assumed: the four operations are rounded correctly (IEEE 754, no fast mathematics, subnormal numbers
kept). The square root is not trusted: its bounds are verified by squaring. */

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>

namespace lattice {

/// The next number of the format below `x`.
template <std::floating_point T>
T below(T x) {
  return std::nextafter(x, -std::numeric_limits<T>::infinity());
}

/// The next number of the format above `x`.
template <std::floating_point T>
T above(T x) {
  return std::nextafter(x, std::numeric_limits<T>::infinity());
}

/**
An interval is made of a number that is meant exactly. A fraction such as 1/10 is not a number of the format:
it is written as a quotient of two intervals, never as `0.1`. Exact numbers may stand among intervals in an
expression, unless they are of a wider format.

Overflow is answered by all numbers, so that no inequality is ever concluded from it. The extremes of a product or
quotient lie at the corners; one that is no number (zero times infinity) makes it all numbers, and so does a divisor
that may be zero. Statements are made only of what is certain: `a < b` holds if every number of `a` is less than every
number of `b`. Hence `a < b` and `a >= b` may both be false, and a proof that needs either then fails. */
template <std::floating_point T>
struct Interval {
  T lower = 0, upper = 0;

  constexpr Interval() = default;
  constexpr Interval(T exact) : lower(exact), upper(exact) {}
  constexpr Interval(T from, T to) : lower(from), upper(to) {}
  template <std::floating_point U>
  requires(sizeof(U) > sizeof(T)) Interval(U)
  = delete;

  /// All numbers: the answer where there is no other.
  static constexpr Interval all() {
    return {-std::numeric_limits<T>::infinity(), std::numeric_limits<T>::infinity()};
  }
  /// Whether all of `x` is inside, ends included.
  constexpr bool contains(T x) const { return lower <= x && x <= upper; }
  constexpr bool contains(const Interval& x) const { return lower <= x.lower && x.upper <= upper; }
  /// Whether both ends are numbers of the format.
  constexpr bool finite() const {
    return lower >= std::numeric_limits<T>::lowest() && upper <= std::numeric_limits<T>::max();
  }
  /// A number inside, about in the middle.
  constexpr T middle() const { return lower + (upper - lower) / 2; }
  /// At least as large as the distance of the middle from both ends.
  T radius() const { return above(std::max(above(upper - middle()), above(middle() - lower))); }

  friend constexpr Interval operator-(const Interval& a) { return {-a.upper, -a.lower}; }
  friend Interval operator+(const Interval& a, const Interval& b) {
    return outwards(a.lower + b.lower, a.upper + b.upper);
  }
  friend Interval operator-(const Interval& a, const Interval& b) {
    return outwards(a.lower - b.upper, a.upper - b.lower);
  }
  friend Interval operator*(const Interval& a, const Interval& b) {
    return hull_of(a.lower * b.lower, a.lower * b.upper, a.upper * b.lower, a.upper * b.upper);
  }
  friend Interval operator/(const Interval& a, const Interval& b) {
    if (!(b.lower > 0 || b.upper < 0)) return all();
    return hull_of(a.lower / b.lower, a.lower / b.upper, a.upper / b.lower, a.upper / b.upper);
  }
  Interval& operator+=(const Interval& b) { return *this = *this + b; }
  Interval& operator-=(const Interval& b) { return *this = *this - b; }

  friend constexpr bool operator<(const Interval& a, const Interval& b) {
    return a.upper < b.lower;
  }
  friend constexpr bool operator<=(const Interval& a, const Interval& b) {
    return a.upper <= b.lower;
  }
  friend constexpr bool operator>(const Interval& a, const Interval& b) { return b < a; }
  friend constexpr bool operator>=(const Interval& a, const Interval& b) { return b <= a; }

 private:
  /// Both ends moved outwards by one number of the format.
  static Interval outwards(T lower, T upper) {
    const Interval wider{below(lower), above(upper)};
    return wider.finite() ? wider : all();
  }
  static Interval hull_of(T p, T q, T r, T s) {
    if (!(p - p == 0 && q - q == 0 && r - r == 0 && s - s == 0)) return all();
    return outwards(std::min(std::min(p, q), std::min(r, s)),
                    std::max(std::max(p, q), std::max(r, s)));
  }
};

/// The largest modulus, a number of the format.
template <class T>
constexpr T magnitude(const Interval<T>& a) {
  return std::max(std::abs(a.lower), std::abs(a.upper));
}
/// All moduli.
template <class T>
constexpr Interval<T> abs(const Interval<T>& a) {
  if (a.lower >= 0) return a;
  if (a.upper <= 0) return -a;
  return {T(0), magnitude(a)};
}
/// The least interval that holds both.
template <class T>
constexpr Interval<T> hull(const Interval<T>& a, const Interval<T>& b) {
  return {std::min(a.lower, b.lower), std::max(a.upper, b.upper)};
}
/// What both have in common; empty (`lower > upper`) where that is nothing.
template <class T>
constexpr Interval<T> common(const Interval<T>& a, const Interval<T>& b) {
  return {std::max(a.lower, b.lower), std::min(a.upper, b.upper)};
}
/// Whether it holds no number.
template <class T>
constexpr bool empty(const Interval<T>& a) {
  return !(a.lower <= a.upper);
}
/// The numbers x_+ = max(x, 0).
template <class T>
constexpr Interval<T> positive_part(const Interval<T>& a) {
  return {std::max(a.lower, T(0)), std::max(a.upper, T(0))};
}

/**
A root is guessed by the processor and then verified: its lower bound must have a power that is certainly
not larger than the radicand, its upper bound one that is certainly not smaller. Where one fails, its
distance from the guess is doubled until it does not. */
/// The root of `a`, from guesses for those of its ends; `power` undoes it.
template <class T, class Power>
Interval<T> verified_root(const Interval<T>& a, T low, T high, Power power) {
  if (a.upper == 0) return {};
  T lower = below(low), upper = above(high);
  while (lower > 0 && !(power(Interval<T>(lower)).upper <= a.lower)) lower -= T(2) * (low - lower);
  while (upper <= std::numeric_limits<T>::max() && !(power(Interval<T>(upper)).lower >= a.upper))
    upper += T(2) * (upper - high);
  return {std::max(lower, T(0)), upper};
}

/// sqrt(x_+).
template <class T>
Interval<T> root(const Interval<T>& x) {
  const Interval<T> a = positive_part(x);
  if (!a.finite()) return Interval<T>::all();
  return verified_root(a, std::sqrt(a.lower), std::sqrt(a.upper),
                       [](const Interval<T>& s) { return s * s; });
}

/// The cube root of x_+.
template <class T>
Interval<T> cube_root(const Interval<T>& x) {
  const Interval<T> a = positive_part(x);
  if (!a.finite()) return Interval<T>::all();
  return verified_root(a, std::cbrt(a.lower), std::cbrt(a.upper),
                       [](const Interval<T>& s) { return s * s * s; });
}

/**
The force of a contact, $x_+^{3/2}$, increases with $x$; its ends are those of the argument. */
/// x_+^(3/2).
template <class T>
Interval<T> hertz(const Interval<T>& x) {
  const Interval<T> a = positive_part(x);
  return {std::max((Interval<T>(a.lower) * root(Interval<T>(a.lower))).lower, T(0)),
          (Interval<T>(a.upper) * root(Interval<T>(a.upper))).upper};
}
/// Its derivative, 3/2 x_+^(1/2).
template <class T>
Interval<T> hertz_slope(const Interval<T>& x) {
  return Interval<T>(3) / Interval<T>(2) * root(x);
}

}  // namespace lattice
