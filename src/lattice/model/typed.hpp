#pragma once
/**
# A chain whose potentials are known

A chain is one type, and its inner loops (kernel.hpp) want to know which well and which contact they compute
with. Here the choice becomes a pair of types, once for a sweep or once for a run. Only the `.cpp` files of
this library include this file: for every pair the compiler makes a copy of what it is given, and so what it
is given should be small. */

#include <cstddef>
#include <type_traits>
#include <utility>
#include <variant>

#include "lattice/model/chain.hpp"
#include "lattice/model/kernel.hpp"

namespace lattice::detail {

/**
Potentials of the caller's own are known by what they do to a row of numbers (potential.hpp). A chain with
such a one is swept block by block, and well and contact are chosen once for a block. So is a chain whose
arithmetic takes longer than the choice: with contacts of any exponent, or in a type wider than `double`. */
/// Calls `use` with the potential by its own type.
template <class P, class Use>
void with_kind(const P& potential, Use use) {
  std::visit([&](const auto& known) { use(known); }, potential);
}

/// As `sweep_acceleration` of kernel.hpp, for potentials of any kind: `apply(i, acceleration)` is called for
/// every site.
template <class T, class Along, class Apply>
void sweep_blocks(const Well& well, const Contact& contact, const T* y, const Along& along,
                  std::size_t n, T left, T right, Apply apply) {
  T push[kernel_block + 1], pull[kernel_block];
  for (std::size_t lo = 0; lo < n; lo += kernel_block) {
    const std::size_t hi = lo + kernel_block < n ? lo + kernel_block : n;
    const std::size_t inner = (hi < n ? hi : n - 1) - lo;
    push[0] = left;
    for (std::size_t i = 0; i < inner; ++i) push[i + 1] = y[lo + i + 1] - y[lo + i];
    with_kind(contact, [&](const auto& c) { forces_of(c, push + 1, push + 1, inner); });
    for (std::size_t i = 0; i < inner; ++i) push[i + 1] = along.contact(lo + i + 1, push[i + 1]);
    if (hi == n) push[hi - lo] = right;
    left = push[hi - lo];
    with_kind(well, [&](const auto& w) { forces_of(w, y + lo, pull, hi - lo); });
    for (std::size_t i = lo; i < hi; ++i)
      apply(i, along.bead(i, pull[i - lo] + (push[i - lo] - push[i - lo + 1])));
  }
}

/**
The loops of kernel.hpp know nothing of windows and ends; they want a range of sites, the pushes at its
two edges, and the masses and stiffnesses in between. So before each sweep the window is widened and the
pushes `left` and `right` at its edges are evaluated. */
/// `contact_push` of chain.hpp for a contact whose type is known.
template <class T, class C>
T push_at(const Chain& chain, const C& contact, const T* y, std::size_t i) {
  if (!chain.boundary().pushes(i)) return T(0);
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

/// Calls `sweep(variation, at, count, left, right)` for the `count` moving sites from `at` on, with the
/// pushes at both edges and the masses and stiffnesses that are not one (`Varied` in kernel.hpp).
template <class T, class C, class Sweep>
void sweep_window(const Chain& chain, const C& contact, const T* y, Window& window, Sweep sweep) {
  if (window.first == window.last) return;
  const auto [left, right] = widen(chain, contact, y, window);
  const auto from = [&](const std::vector<double>& all) {
    return all.empty() ? nullptr : all.data() + window.first;
  };
  const std::size_t at = window.first, count = window.last - window.first;
  if (chain.mass.empty())
    sweep(Homogeneous{}, at, count, left, right);
  else
    sweep(Varied{from(chain.eta), from(chain.mass), from(chain.inverse_mass)}, at, count, left,
          right);
}

/// Whether the loops of kernel.hpp are made for this pair.
template <class T, class W, class C>
inline constexpr bool has_loop =
    std::is_same_v<T, double> && !std::is_same_v<W, Well> && !std::is_same_v<C, Contact>;

/**
Both moves of an integrator, for a pair of potentials. Where there is no pair, well and contact stand for
themselves. */
template <class T, class W, class C>
void accelerate(const Chain& chain, const W& well, const C& contact, const T* y, T* a,
                Window& window) {
  sweep_window(chain, contact, y, window,
               [&](const auto& along, std::size_t at, std::size_t count, T left, T right) {
                 if constexpr (has_loop<T, W, C>)
                   sweep_acceleration(well, contact, y + at, a + at, along, count, left, right);
                 else
                   sweep_blocks(well, contact, y + at, along, count, left, right,
                                [&](std::size_t i, const T& value) { a[at + i] = value; });
               });
}

/// The call of chain.hpp for one well and one contact.
template <class T, class W, class C>
void kick_drift(const Chain& chain, const W& well, const C& contact, State<T>& state,
                Window& window, const T& kick, const T& drift) {
  sweep_window(chain, contact, state.y.data(), window,
               [&](const auto& along, std::size_t at, std::size_t count, T left, T right) {
                 T *y = state.y.data() + at, *v = state.v.data() + at;
                 if constexpr (has_loop<T, W, C>)
                   sweep_kick_drift(well, contact, y, v, along, count, left, right, kick, drift);
                 else
                   sweep_blocks(well, contact, y, along, count, left, right,
                                [&](std::size_t i, const T& a) {
                                  v[i] += kick * a;
                                  y[i] += drift * v[i];
                                });
               });
}

/**
Here the choice is made. A run of many short sweeps makes it once: `accelerator` and `kick_drifter` give the
function that fits the chain. */
template <class T>
using Accelerate = void (*)(const Chain&, const T* y, T* a, Window&);
template <class T>
using KickDrift = void (*)(const Chain&, State<T>&, Window&, const T& kick, const T& drift);

/// Calls `use(well, contact)` with the two potentials of the chain by their own types if there is a loop for
/// the pair, and otherwise by those of the chain.
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
        chain.well, chain.contact);
  else
    return use(chain.well, chain.contact);
}

/// The potential of a chain as one of type `P`, which it is.
template <class P, class Any>
const P& known(const Any& any) {
  if constexpr (std::is_same_v<P, Any>)
    return any;
  else
    return *std::get_if<P>(&any);
}

/// `accelerate` for this chain (chain.cpp).
template <class T>
Accelerate<T> accelerator(const Chain& chain);

/// `kick_drift` for this chain (kick_drift.cpp).
template <class T>
KickDrift<T> kick_drifter(const Chain& chain);

}  // namespace lattice::detail
