#pragma once
/**
# When an overlap passes through zero

Close to a zero of an overlap $x(t)$ we know its value, speed and acceleration at one instant, and ask for the time
$\tau$ to the zero: a root of $x + \dot x\,\tau + \tfrac12\ddot x\,\tau^2 = 0$ (`Overlap`). Between two instants $t$ and
$t + \Delta t$ we know values and speeds at both, and ask whether and where the overlap changed its sign, on the cubic
with the same four values (`Arc`),
$$x(t + s\,\Delta t) \simeq r^2\,[(1+2s)\,x_0 + s\,\Delta t\,\dot x_0]
 + s^2\,[(1+2r)\,x_1 - r\,\Delta t\,\dot x_1], \qquad r = 1 - s.$$ */

#include <cmath>
#include <limits>

#include "lattice/numerics/ieee.hpp"

namespace lattice {

/// 1, 0 or -1, written out for every number type.
template <class T>
int sign_of(T x) {
  return x > T(0) ? 1 : x < T(0) ? -1 : 0;
}
/// The modulus, likewise.
template <class T>
T magnitude(T x) {
  return x < T(0) ? -x : x;
}

/// Value `x`, speed `u` and acceleration `w`. The roots are computed in the form that loses no digits to cancellation.
template <class T>
struct Overlap {
  T x, u, w;

  /// Time from now to the root through which the overlap leaves `side` (+1 closed, -1 open), negative if
  /// it has passed; infinity if there is none.
  T leaves(int side) const {
    using std::sqrt;
    const T square = u * u - T(2) * x * w, none = std::numeric_limits<T>::infinity();
    if (!(square >= T(0))) return none;
    const bool departs = T(side) * u < T(0);
    const T q = u < T(0) ? sqrt(square) - u : -(u + sqrt(square));
    if (departs) return T(2) * x / q;
    return w != T(0) ? q / w : none;
  }
  /// Time from now to the extremum.
  T turns() const { return w != T(0) ? -u / w : std::numeric_limits<T>::infinity(); }
};

/// The cubic. If a contact closes and opens again within a step, both ends have the same sign, and the cubic has an
/// extremum of the opposite sign in between.
template <class T>
struct Arc {
  T x0, u0, x1, u1, dt;  ///< values and speeds at the beginning and at the end

  /// The cubic at the share `s` of the step, from 0 to 1.
  T value(T s) const {
    const T r = T(1) - s;
    return r * r * ((T(1) + T(2) * s) * x0 + s * dt * u0) +
           s * s * ((T(1) + T(2) * r) * x1 - r * dt * u1);
  }
  /// Its derivative by time there.
  T slope(T s) const {
    const T r = T(1) - s;
    return T(6) * s * r * (x1 - x0) / dt + r * (T(1) - T(3) * s) * u0 + s * (T(3) * s - T(2)) * u1;
  }
  /// First place in (0, end) after which `holds` fails, by bisection to 2^-24 of `end`: event
  /// location corrects the rest.
  template <class Holds>
  static T last(T end, Holds holds) {
    T low(0), high = end;
    for (int i = 0; i < 24; ++i) {
      const T middle = (low + high) / T(2);
      (holds(middle) ? low : high) = middle;
    }
    return high;
  }
};

}  // namespace lattice
