#pragma once
/**
# Wells

The well $W$ holds a bead at its place. Beside the members that every potential has
(potential.hpp) a well may have a `rim()`, the displacement at which a bead is lost to it. A new
well is a struct in this file and its entry in the list at the end; CONTRIBUTING.md adds one. */

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

#include "lattice/model/potential.hpp"

namespace lattice {

/// No well at all: beads that are held by their neighbours alone.
struct None {
  static constexpr const char* name = "none";
  template <class T>
  T energy(T) const {
    return T(0);
  }
  template <class T>
  T force(T) const {
    return T(0);
  }
  template <class T>
  T stiffness(T) const {
    return T(0);
  }
};

/**
The well of the cradle in most of the article, Eq. (8), $W = y^2/2$, is linear: all that is nonlinear
comes from the contacts. */
struct Harmonic {
  static constexpr const char* name = "harmonic";
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

/**
How much does the well itself matter? The article varies the sign of its first correction, Eq. (10):
$W = y^2/2 + s\,y^4/4$. For $s < 0$ the well has a rim at $|y| = (-s)^{-1/2}$ beyond which the motion
runs away. */
struct Quartic {
  double s = 0;
  static constexpr const char* name = "quartic";
  static constexpr auto parameters() {
    return std::array{Parameter<Quartic>{"s", "anharmonicity of the well", -10, 10, &Quartic::s}};
  }
  double rim() const { return s < 0 ? 1 / std::sqrt(-s) : std::numeric_limits<double>::infinity(); }

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

/**
Gravity on a pendulum, section 3.4, gives $W = 1 - \cos y$, with rims at odd multiples of $\pi$ and
another well beyond each. The energy is written with half the angle, which loses no digits near
the bottom. */
struct Pendulum {
  static constexpr const char* name = "pendulum";
  double rim() const { return std::numbers::pi; }

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
Whoever follows a bead wants to know whether it is lost, without asking which well it is in: the
displacement at which it leaves is infinite where there is no rim. */
template <class Onsite>
double rim_of(const Onsite& onsite) {
  if constexpr (requires { onsite.rim(); })
    return onsite.rim();
  else
    return std::numeric_limits<double>::infinity();
}

/// The wells that can be chosen by name; `std::visit` once at the edge of a program.
using AnyOnsite = std::variant<None, Harmonic, Quartic, Pendulum>;

inline double rim_of(const AnyOnsite& any) {
  return std::visit([](const auto& onsite) { return rim_of(onsite); }, any);
}

}  // namespace lattice
