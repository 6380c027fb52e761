#pragma once
/**
# The inner loop

Nearly all of the computing time is spent in one loop, which evaluates the right-hand side of the equations of motion
(chain.hpp) and moves the beads; so it is written for the machine. For a block of sites a first pass computes the contact
forces, a second one the accelerations. Both are plain loops that the compiler vectorises, the block stays in the
first-level cache, and the speed is limited by the square root in the contact law.

The loop wants to know which well and which contact it computes with, so the choice is made once, for a sweep or for a
run. It is compiled for every pair, and each time for wider and wider vectors, of which the processor's widest is chosen
when the program starts. Every operation is a single IEEE operation on one site (the build forbids fused multiply-adds), so all
versions give the same bits. This header is not installed: it is for the sources of this repository. */

#include <cstddef>
#include <type_traits>
#include <utility>
#include <variant>

#include "lattice/model/chain.hpp"

// Where there is no function multiversioning, one portable version remains, with the same results.
#if !defined(LATTICE_WIDE)
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__linux__) && \
    !defined(__SANITIZE_ADDRESS__)
#define LATTICE_WIDE __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define LATTICE_WIDE
#endif
#endif

namespace lattice::detail {

/// Sites handled between the two passes: so few that the processor begins the roots of the next block while it is
/// still updating the last one (with 512 sites the measured rate was one quarter lower).
inline constexpr std::size_t kernel_block = 64;

/**
What does not vary along the chain should cost nothing: so whether it does is part of the type. A run in double
multiplies by the inverse mass; one in extended precision divides by the mass itself, so that it solves the
same chain to all of its digits. */
struct Varied {
  const double* eta;           ///< eta[i]: stiffness of the contact between i - 1 and i
  const double* mass;          ///< mu_n
  const double* inverse_mass;  ///< 1 / mu_n, rounded

  /// Force or energy of contact `i` from that of unit stiffness.
  template <class T>
  T contact(std::size_t i, T unit) const {
    return T(eta[i]) * unit;
  }
  template <class T>
  T acceleration(std::size_t n, T force) const {
    if constexpr (std::is_same_v<T, double>)
      return force * inverse_mass[n];
    else
      return force / T(mass[n]);
  }
  template <class T>
  T momentum(std::size_t n, T velocity) const {
    return T(mass[n]) * velocity;
  }
};

/// The same where nothing varies, as in most of the article.
struct Homogeneous {
  template <class T>
  T contact(std::size_t, T unit) const {
    return unit;
  }
  template <class T>
  T acceleration(std::size_t, T force) const {
    return force;
  }
  template <class T>
  T momentum(std::size_t, T velocity) const {
    return velocity;
  }
};

/// Calls `use` with the masses and stiffnesses from site `at` on.
template <class Use>
void with_variation(const Chain& chain, std::size_t at, Use use) {
  if (!chain.variation) return use(Homogeneous{});
  const Variation& all = *chain.variation;
  use(Varied{all.eta.data() + at, all.mass.data() + at, all.inverse_mass.data() + at});
}

/**
What becomes of the acceleration `a` of a bead? A splitting method (schemes.hpp) kicks the velocity and drifts the
position. A site may be drifted as soon as its neighbours have read its old position, so a single sweep does both. Methods
that combine the accelerations of several stages keep them. */
template <class T>
struct KickAndDrift {
  T kick, drift;
  void operator()(T a, T& y, T& v) const {
    v += kick * a;
    y += drift * v;
  }
};
struct Keep {
  template <class T>
  void operator()(T a, const T&, T& kept) const {
    kept = a;
  }
};

/// Moves `n` sites by `move(acceleration, y[i], out[i])`; `left` and `right` are the pushes of the contacts at the edges, and
/// push[k] that of the contact between the sites lo + k - 1 and lo + k.
template <class Weights, class Y, class T, class W, class C, class Move>
LATTICE_WIDE void sweep(const W well, const C contact, Y* __restrict__ y, T* __restrict__ out,
                        const Weights weights, std::size_t n, T left, T right, const Move move) {
  T push[kernel_block + 1];
  for (std::size_t lo = 0; lo < n; lo += kernel_block) {
    const std::size_t hi = lo + kernel_block < n ? lo + kernel_block : n;
    const std::size_t last = hi < n ? hi : n - 1;
    push[0] = left;
    for (std::size_t i = lo; i < last; ++i)
      push[i + 1 - lo] = weights.contact(i + 1, contact.force(y[i + 1] - y[i]));
    if (hi == n) push[hi - lo] = right;
    left = push[hi - lo];
    for (std::size_t i = lo; i < hi; ++i)
      move(weights.acceleration(i, well.force(y[i]) + (push[i - lo] - push[i - lo + 1])), y[i],
           out[i]);
  }
}

/**
A potential of the caller's own is known by what it does to a row of numbers (potential.hpp). A chain with such a one chooses
anew for every block, and so does one whose arithmetic takes longer than the choice: with contacts of any exponent, or in
a type wider than `double`. */
template <class Weights, class Y, class T, class Move>
void sweep_blocks(const Well& well, const Contact& contact, Y* y, T* out, const Weights& weights,
                  std::size_t n, T left, T right, const Move& move) {
  T push[kernel_block + 1], pull[kernel_block];
  for (std::size_t lo = 0; lo < n; lo += kernel_block) {
    const std::size_t hi = lo + kernel_block < n ? lo + kernel_block : n;
    const std::size_t inner = (hi < n ? hi : n - 1) - lo;
    push[0] = left;
    for (std::size_t i = 0; i < inner; ++i) push[i + 1] = y[lo + i + 1] - y[lo + i];
    std::visit([&](const auto& c) { forces_of(c, push + 1, push + 1, inner); }, contact.kind);
    for (std::size_t i = 0; i < inner; ++i) push[i + 1] = weights.contact(lo + i + 1, push[i + 1]);
    if (hi == n) push[hi - lo] = right;
    left = push[hi - lo];
    std::visit([&](const auto& w) { forces_of(w, y + lo, pull, hi - lo); }, well.kind);
    for (std::size_t i = lo; i < hi; ++i)
      move(weights.acceleration(i, pull[i - lo] + (push[i - lo] - push[i - lo + 1])), y[i], out[i]);
  }
}

/// `contact_push` of chain.hpp for a contact whose type is known.
template <class T, class C>
T push_at(const Chain& chain, const C& contact, const T* y, std::size_t i) {
  if (!chain.has_contact(i)) return T(0);
  return T(chain.eta_of(i)) * contact.force(stretch(chain, y, i));
}

/// Adds a site to the window at either edge where the contact there pushes; returns the pushes at its edges.
template <class T, class C>
std::pair<T, T> widen(const Chain& chain, const C& contact, const T* y, Window& window) {
  const auto push = [&](std::size_t i) { return push_at(chain, contact, y, i); };
  T left = push(window.first), right = push(window.last);
  if (window.first > 0 && left != T(0)) left = push(--window.first);
  if (window.last < chain.sites && right != T(0)) right = push(++window.last);
  return {left, right};
}

/// The potential of a chain as one of type `P`, which it is.
template <class P, class Any>
const P& known(const Any& any) {
  if constexpr (std::is_same_v<P, Any>)
    return any;
  else
    return *std::get_if<P>(&any.kind);
}

/// A sweep over the window, widened where it is pushed, in a chain with the well W and the contact C.
template <class W, class C, class Y, class T, class Move>
void sweep_window(const Chain& chain, Y* y, T* out, Window& window, const Move& move) {
  if (window.first == window.last) return;
  const W& well = known<W>(chain.well);
  const C& contact = known<C>(chain.contact);
  const std::pair<T, T> edges = widen<T>(chain, contact, y, window);
  const std::size_t at = window.first, n = window.last - window.first;
  with_variation(chain, at, [&](const auto& weights) {
    if constexpr (std::is_same_v<W, Well>)
      sweep_blocks(well, contact, y + at, out + at, weights, n, edges.first, edges.second, move);
    else
      sweep(well, contact, y + at, out + at, weights, n, edges.first, edges.second, move);
  });
}

/// Calls `use(well, contact)` with the two potentials by their own types if the loop is made for the pair, and
/// otherwise by those of the chain.
template <class T, class Use>
auto with_pair(const Chain& chain, Use use) {
  if constexpr (std::is_same_v<T, double>)
    return std::visit(
        [&]<class W, class C>(const W& well, const C& contact) {
          if constexpr (std::is_same_v<W, OwnWell> || std::is_same_v<C, OwnContact> ||
                        std::is_same_v<C, PowerContact>)
            return use(chain.well, chain.contact);
          else
            return use(well, contact);
        },
        chain.well.kind, chain.contact.kind);
  else
    return use(chain.well, chain.contact);
}

/**
A run of many short sweeps chooses once, by taking the function that fits the chain. */
template <class T>
using Accelerate = void (*)(const Chain&, const T* y, T* a, Window&);
template <class T>
using KickDrift = void (*)(const Chain&, State<T>&, Window&, const T& kick, const T& drift);

/// `accelerate` and `kick_drift` of chain.hpp for this chain.
template <class T>
Accelerate<T> accelerator(const Chain& chain);
template <class T>
KickDrift<T> kick_drifter(const Chain& chain);

}  // namespace lattice::detail
