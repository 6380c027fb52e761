#pragma once
/**
# Wells

The well $W$ holds a bead near its place: gravity on a pendulum, or the elasticity of a beam. Apart from
the members that every potential has (potential.hpp), a well may have a `rim()`, the displacement beyond
which it no longer pulls a bead back. A new well is a struct in this file and an entry in the list at its
end; CONTRIBUTING.md shows one being added. A struct that is in no list serves as well. */

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <variant>

#include "lattice/model/potential.hpp"

namespace lattice {

/// No well at all, W = 0: beads that only their neighbours hold.
struct NoWell {
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
In most of the article the well is harmonic, Eq. (8), $W = y^2/2$. Its force is linear, so that whatever
is nonlinear comes from the contacts. */
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
How much does the shape of the well matter? The article adds the first symmetric correction, of either
sign, Eq. (10): $W = y^2/2 + s\,y^4/4$. A well with $s > 0$ is called hard, one with $s < 0$ soft; the
soft one has a rim at $|y| = (-s)^{-1/2}$, beyond which a bead runs away. */
struct Quartic {
  double s = 0;  ///< anharmonicity
  static constexpr const char* name = "quartic";
  static constexpr auto parameters() {
    return std::array{Parameter<Quartic>{"s", "anharmonicity s of the well W = y^2/2 + s y^4/4",
                                         -10, 10, &Quartic::s}};
  }
  /// (-s)^(-1/2) in a soft well, otherwise infinity.
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
Gravity on a pendulum gives $W = 1 - \cos y$, with rims at the odd multiples of $\pi$ and
another well beyond each. The energy is computed as $2\sin^2(y/2)$, which loses no digits near the
bottom. */
struct Pendulum {
  static constexpr const char* name = "pendulum";
  /// The nearest of the rims.
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

/// The displacement at which a bead leaves this well; infinity if the well has no rim.
template <class Onsite>
double rim_of(const Onsite& onsite) {
  if constexpr (requires { onsite.rim(); })
    return onsite.rim();
  else
    return std::numeric_limits<double>::infinity();
}

/// A well that the list does not know, with its rim. Throws std::invalid_argument where
/// `require_well` does.
struct OwnWell : OwnPotential {
  OwnWell() = default;
  template <class P>
  explicit OwnWell(P well) : OwnPotential(well), edge_(rim_of(well)) {
    require_well(*this, edge_);
  }
  double rim() const { return edge_; }

 private:
  double edge_ = std::numeric_limits<double>::infinity();
};

/**
The wells that have a name, and the caller's own: `chain.well = Quartic{0.5}` sets one and
`chain.well.get_if<Quartic>()->s` reads it (potential.hpp). */
struct Well : OneOf<OwnWell, NoWell, Harmonic, Quartic, Pendulum> {
  using OneOf::OneOf;
  Well() : OneOf(Harmonic{}) {}

  /// The displacement at which a bead leaves the well; infinity if it cannot.
  double rim() const {
    return std::visit([](const auto& w) { return rim_of(w); }, kind);
  }
};

/// The same well by its simplest type: without anharmonicity the quartic one is `Harmonic`, with the same bits.
inline Well simplest(const Well& well) {
  const auto* quartic = well.get_if<Quartic>();
  return quartic && quartic->s == 0 ? Well{} : well;
}

/// Whether the force of an own well loses its digits near zero, where the tail of a breather is.
inline bool loses_digits(const Well& well) {
  const auto* own = well.get_if<OwnWell>();
  return own && loses_digits(static_cast<const OwnPotential&>(*own));
}

/// What its author is told.
inline constexpr const char* digits_hint =
    "the force of the well loses digits near zero, in the tail of a breather: write it with expm1, "
    "log1p, 2 sin^2(y/2) or the like";

}  // namespace lattice
