#pragma once
/**
# Contacts

Beads that touch repel each other, and beads that do not touch ignore each other. It is this one-sided
force that makes the chains of the article unlike other nonlinear lattices. Apart from the members that
every potential has (potential.hpp), a contact names its `opening()`, the relative displacement
$r = y_{n+1}-y_n$ at which the beads separate, and the `exponent` with which the force grows from there.
A new contact is a struct in this file and an entry in the list at its end. */

#include <array>
#include <cmath>
#include <variant>

#include "lattice/model/potential.hpp"

namespace lattice {

/// $|x|^{\alpha-1}$, the force $x|x|^{\alpha-1}$ of a contact over its strain `x`; for spheres by a square root.
template <class T>
T secant_stiffness(T x, double alpha) {
  using std::abs, std::pow, std::sqrt;
  return alpha == 1.5 ? T(sqrt(abs(x))) : T(pow(abs(x), T(alpha) - T(1)));
}

/**
Two elastic spheres repel with the 3/2 power of their overlap $-r$ and do not attract, Eq. (7):
$V(r) = \frac25 (-r)_+^{5/2}$, where $(x)_+$ is $x$ if positive and zero otherwise. The power is
written $x\sqrt x$, one correctly rounded root and one product: the same bits on every machine.

An overlap up to `negligible` exerts no force at all. Ahead of a front the displacements fall double-exponentially and would otherwise crawl through the subnormal numbers
near $10^{-308}$, which cost the processor ten times as much. With the default of $10^{-60}$ the
neglected force is $10^{-90}$, and beads ahead of the front are at rest *exactly*, so that they need not
be integrated. Where the tail of a static breather is itself the subject, we set `negligible = 0`. */
struct Hertz {
  double negligible = 1e-60;  ///< the largest overlap that counts as none
  static constexpr const char* name = "hertz";

  /// (-r)_+, or zero where that is negligible.
  template <class T>
  T overlap(T r) const {
    const T x = -r;
    return x > T(negligible) ? x : T(0);
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
  double opening() const { return 0; }
  static constexpr double exponent = 1.5;
};

/**
If neighbours are pressed together by $d$ at rest, small motions leave the contacts closed, and the potential is that of
Eq. (33): $V(r) = \frac25 (d-r)_+^{5/2} + d^{3/2} r - \frac25 d^{5/2}$. The linear term subtracts the constant force of
the precompression, which cancels on every bead inside the chain, so that $V(0) = V'(0) = 0$. Ahead of a front the
displacements fall as fast as between uncompressed beads, and a displacement up to `negligible` exerts no force. */
struct CompressedHertz {
  double d = 0;               ///< compression at rest, not negative
  double negligible = 1e-60;  ///< the largest change of the distance that counts as none
  static constexpr const char* name = "hertz";
  static constexpr auto parameters() {
    return std::array{Parameter<CompressedHertz>{
        "precompression", "static compression d of the contacts", 0, 10, &CompressedHertz::d}};
  }

  template <class T>
  T overlap(T r) const {
    const T x = T(d) - r;
    return x > T(0) ? x : T(0);
  }

  /**
  For small $r$ all terms but one of order $r^2$ cancel, and of $10^{-6}$ the rounding of the others would leave
  four digits. With $w = (d-r)^{1/2}$ and $p = d^{1/2}$ the terms of a closed contact are
  $\frac25(w^5 - \frac52p^3w^2 + \frac32p^5)$, which has the factor $(w-p)^2$, and $w-p = -r/(w+p)$. */
  template <class T>
  T energy(T r) const {
    using std::sqrt;
    const T x = overlap(r), p = sqrt(T(d));
    if (!(x > T(0))) return T(d) * p * (r - T(2) / T(5) * T(d));
    const T w = sqrt(x), s = r / (w + p);
    return T(2) / T(5) * s * s * (x * (w + T(2) * p) + T(d) * (T(3) * w + T(3) / T(2) * p));
  }
  /// $w^3 - p^3$ has the factor $w-p$.
  template <class T>
  T force(T r) const {
    using std::abs, std::sqrt;
    const T x = overlap(r), p = sqrt(T(d)), w = sqrt(x);
    const T push = d > 0 ? -r * ((x + w * p + T(d)) / (w + p)) : x * w;
    return x > T(0) ? abs(r) > T(negligible) ? push : T(0) : -(T(d) * p);
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
Other contacts (cylinders, hollow spheres, rough tips) follow the same law with another exponent
$\alpha \ge 1$: $V(r) = (d-r)_+^{\alpha+1}/(\alpha+1)$, plus the terms that make $V(0) = V'(0) = 0$. The
general power is slower, and its last bit depends on the mathematical library; for $\alpha = 3/2$ the
square root of the other laws is used instead. */
struct PowerContact {
  double exponent = 1.5;      ///< alpha, at least one
  double d = 0;               ///< compression at rest, not negative
  double negligible = 1e-60;  ///< the largest change of the distance that counts as none
  static constexpr const char* name = "power";
  static constexpr auto parameters() {
    using P = Parameter<PowerContact>;
    return std::array{
        P{"alpha", "exponent of the contact force", 1, 10, &PowerContact::exponent},
        P{"precompression", "static compression d of the contacts", 0, 10, &PowerContact::d}};
  }

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

  /// (1 - u)^p without its terms below u^from, which cancel where `u` is small; |u| < 1/8.
  template <class T>
  static T binomial_rest(T u, T p, int from) {
    T term(1), sum(0);
    for (int k = 1; k <= from || sum + term != sum; ++k) {
      if (k > from) sum += term;
      term *= (T(k - 1) - p) / T(k) * u;
    }
    return sum;
  }
  template <class T>
  T energy(T r) const {
    using std::abs;
    if (exponent == 1.5) return CompressedHertz{d}.energy(r);
    const T x = overlap(r), rest = power(T(d)), more = T(exponent) + T(1);
    if (abs(r) < T(d) / T(8)) return rest * T(d) / more * binomial_rest(r / T(d), more, 2);
    return (x * power(x) - T(d) * rest) / more + rest * r;
  }
  template <class T>
  T force(T r) const {
    using std::abs;
    if (!(abs(r) > T(negligible))) return T(0);
    if (exponent == 1.5) return CompressedHertz{d, negligible}.force(r);
    const T rest = power(T(d));
    if (abs(r) < T(d) / T(8)) return rest * binomial_rest(r / T(d), T(exponent), 1);
    return power(overlap(r)) - rest;
  }

  /// An open contact has none, which needs saying for alpha = 1: the formula would give 0^0.
  template <class T>
  T stiffness(T r) const {
    using std::pow, std::sqrt;
    const T x = overlap(r);
    if (!(x > T(0))) return T(0);
    return T(exponent) * (exponent == 1.5 ? sqrt(x) : pow(x, T(exponent) - T(1)));
  }
  double opening() const { return d; }
};

/// A contact law that the list does not know, with its opening and its exponent, named like those of the list. Throws std::invalid_argument where `require_contact` does.
struct OwnContact : OwnPotential {
  double exponent = 1.5;
  OwnContact() = default;
  template <class P>
  explicit OwnContact(P contact)
      : OwnPotential(contact), exponent(contact.exponent), opening_(contact.opening()) {
    require_contact(*this, opening_, exponent);
  }
  double opening() const { return opening_; }

 private:
  double opening_ = 0;
};

/// Like a well, a contact is one of a list or of the caller's own. Two types share the name `hertz`: the plain law, and
/// the one with a precompression.
struct Contact : OneOf<OwnContact, Hertz, CompressedHertz, PowerContact> {
  using OneOf::OneOf;

  /// The overlap at rest: a contact opens where the beads are that much further apart.
  double opening() const {
    return std::visit([](const auto& c) { return c.opening(); }, kind);
  }
  /// The power of the overlap in the force, 3/2 for spheres.
  double exponent() const {
    return std::visit([](const auto& c) { return c.exponent; }, kind);
  }
};

/// The same law by its simplest type: without precompression the 3/2 law is plain `Hertz`, with the
/// same bits, and `PowerContact` with exponent 3/2 is one of the two laws of Hertz.
inline Contact simplest(const Contact& contact) {
  const auto hertz = [](double d, double negligible) {
    return d == 0 ? Contact{Hertz{negligible}} : Contact{CompressedHertz{d, negligible}};
  };
  if (const auto* c = contact.get_if<CompressedHertz>()) return hertz(c->d, c->negligible);
  if (const auto* c = contact.get_if<PowerContact>(); c && c->exponent == 1.5)
    return hertz(c->d, c->negligible);
  return contact;
}

/// The same law by its simplest type, with no overlap negligible, lest the tail of a breather be cut off.
inline Contact without_cutoff(const Contact& contact) {
  Contact simple = simplest(contact);
  std::visit(
      [](auto& c) {
        if constexpr (requires { c.negligible; }) c.negligible = 0;
      },
      simple.kind);
  return simple;
}

}  // namespace lattice
