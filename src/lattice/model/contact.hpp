#pragma once
/**
# Contacts

Beads that touch repel. Beside the members that every potential has (potential.hpp) a contact
names its `opening()`, the relative displacement at which the beads separate, and the `exponent`
with which the force begins there. A new contact is a struct in this file and its entry in the
list at the end. */

#include <array>
#include <cmath>
#include <variant>

#include "lattice/model/potential.hpp"

namespace lattice {

/// The power 3/2 with the sign of `x`, by a root that is rounded correctly everywhere.
template <class T>
T three_halves(T x) {
  using std::abs, std::sqrt;
  return x * sqrt(abs(x));
}

/**
Two spheres repel with the 3/2 power of their overlap and do not attract, Eq. (7):
$V(r) = \frac25 (-r)_+^{5/2}$. The power is written $x\sqrt x$, which is one correctly rounded root
and one product: the same bits on every machine.

The force carries an explicit `floor`: an overlap at or below it exerts no force
at all. Ahead of a front the displacements fall double-exponentially and would
otherwise crawl through subnormal numbers, which cost ten times as much. With
the default $10^{-60}$ the neglected force is $10^{-90}$, and beads ahead of the
front are at rest *exactly*, so that they need not be integrated. A static
breather whose tail is itself the subject sets `floor = 0`. */
struct Hertz {
  double floor = 1e-60;
  static constexpr const char* name = "hertz";

  template <class T>
  T overlap(T r) const {
    const T x = -r;
    return x > T(floor) ? x : T(0);
  }

  /**
  Energy, force and stiffness all see this overlap, so that one at the floor counts in none of them. */
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
gains a phonon band, Eq. (33):
$V(r) = \frac25 (d-r)_+^{5/2} + d^{3/2} r - \frac25 d^{5/2}$. Only the first term
moves beads; the others make $V(0) = V'(0) = 0$. The contact now opens at
$r = d$ instead of $r = 0$. */
struct CompressedHertz {
  double d = 0;
  static constexpr const char* name = "hertz";
  static constexpr auto parameters() {
    return std::array{Parameter<CompressedHertz>{
        "precompression", "compression d of the contacts at rest", 0, 10, &CompressedHertz::d}};
  }

  template <class T>
  T overlap(T r) const {
    const T x = T(d) - r;
    return x > T(0) ? x : T(0);
  }

  /**
  For a small $r$ the constant nearly cancels the power, so the two are subtracted before anything else
  is added. */
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
another exponent $\alpha \ge 1$: $V(r) = (d-r)_+^{\alpha+1}/(\alpha+1)$, made
stationary at $r = 0$. The general power is slower and its last bit depends on
the mathematical library; with $\alpha = 3/2$ it is the root of the other laws. */
struct PowerContact {
  double exponent = 1.5;
  double d = 0;
  static constexpr const char* name = "power";
  static constexpr auto parameters() {
    using P = Parameter<PowerContact>;
    return std::array{
        P{"alpha", "exponent of the contact force", 1, 10, &PowerContact::exponent},
        P{"precompression", "compression d of the contacts at rest", 0, 10, &PowerContact::d}};
  }

  /**
  The choice between the root and the general power depends on the parameter alone; it is the same for
  all contacts of a chain. */
  template <class T>
  T power(T x) const {
    using std::pow, std::sqrt;
    return exponent == 1.5 ? x * sqrt(x) : pow(x, T(exponent));
  }
  template <class T>
  T overlap(T r) const {
    const T x = T(d) - r;
    return x > T(0) ? x : T(0);
  }
  template <class T>
  T energy(T r) const {
    const T x = overlap(r), rest = power(T(d));
    return (x * power(x) - T(d) * rest) / (T(exponent) + T(1)) + rest * r;
  }
  template <class T>
  T force(T r) const {
    return power(overlap(r)) - power(T(d));
  }

  /**
  The stiffness of an open contact must be set to zero, because the general power of zero is one where
  its exponent, $\alpha-1$, is zero. */
  template <class T>
  T stiffness(T r) const {
    using std::pow, std::sqrt;
    const T x = overlap(r);
    if (!(x > T(0))) return T(0);
    return T(exponent) * (exponent == 1.5 ? sqrt(x) : pow(x, T(exponent) - T(1)));
  }
  double opening() const { return d; }
};

/**
A reader chooses a contact by name. Two types share the name `hertz`: the plain law, and the one that
also has a precompression. */
using AnyContact = std::variant<Hertz, CompressedHertz, PowerContact>;

/// The same law by its simplest type: without precompression the 3/2 law is that of Hertz, bit by
/// bit, and a power of 3/2 is no general power.
inline AnyContact simplest(const AnyContact& contact) {
  const auto hertz = [](double d) { return d == 0 ? AnyContact{Hertz{}} : CompressedHertz{d}; };
  if (const auto* c = std::get_if<CompressedHertz>(&contact)) return hertz(c->d);
  if (const auto* c = std::get_if<PowerContact>(&contact); c && c->exponent == 1.5)
    return hertz(c->d);
  return contact;
}

}  // namespace lattice
