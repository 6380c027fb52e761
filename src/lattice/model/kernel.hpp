#pragma once
/**
# The inner loop

Nearly all of the computing time is spent in the two loops of this file, so they
are written for the machine. A first pass over a block of sites evaluates the
contact forces, a second one the accelerations; each is a plain loop that the
compiler vectorises, the block stays in the first-level cache, and the square
root of the contact law is what limits the speed.

The loops are compiled several times, for wider and wider vectors, and the widest
one that the processor has is chosen when the program starts. Every operation in
them is a single IEEE operation on one site (the build forbids contracted
multiply-adds), so all the versions give the same bits. */

#include <cstddef>
#include <type_traits>

// Not every compiler and platform has function multiversioning; there the one portable version
// remains, with the same results.
#if !defined(LATTICE_WIDE)
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__linux__) && \
    !defined(__SANITIZE_ADDRESS__)
#define LATTICE_WIDE __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define LATTICE_WIDE
#endif
#endif

namespace lattice {

/// Sites handled between the two passes. With a block this short the processor takes the next
/// block's roots while it is still updating the last one's sites; at 512 the rate is a quarter less.
inline constexpr std::size_t kernel_block = 64;

/**
Beads may differ in mass and contacts in stiffness. What is not varied costs nothing: the choice
is part of the type. The numbers are kept as they were given, in `double`; a run in double
multiplies by the inverse mass, one in a wider type divides by the mass itself, so that it
solves the same chain to all of its digits. */
template <bool stiff, bool heavy>
struct Variation {
  const double* eta = nullptr;           ///< eta[i]: stiffness of the contact between i - 1 and i
  const double* mass = nullptr;          ///< mu_n
  const double* inverse_mass = nullptr;  ///< 1 / mu_n, rounded

  template <class T>
  T contact(std::size_t i, T force) const {
    if constexpr (stiff)
      return T(eta[i]) * force;
    else
      return force;
  }
  template <class T>
  T bead(std::size_t n, T force) const {
    if constexpr (heavy && std::is_same_v<T, double>)
      return force * inverse_mass[n];
    else if constexpr (heavy)
      return force / T(mass[n]);
    else
      return force;
  }
};

/**
In the article's own chain nothing varies, and both functions hand on the force as it is. */
struct Homogeneous {
  template <class T>
  T contact(std::size_t, T force) const {
    return force;
  }
  template <class T>
  T bead(std::size_t, T force) const {
    return force;
  }
};

/**
A program learns only when it runs what is varied; the loops want it as a type. So the choice is made
once a sweep, outside of the loops: `sweep(variation)` gets the type that fits, and null pointers stand
for what is not varied. */
template <class Sweep>
void with_variation(const double* eta, const double* mass, const double* inverse_mass,
                    Sweep sweep) {
  if (eta && mass)
    sweep(Variation<true, true>{eta, mass, inverse_mass});
  else if (eta)
    sweep(Variation<true, false>{eta, nullptr, nullptr});
  else if (mass)
    sweep(Variation<false, true>{nullptr, mass, inverse_mass});
  else
    sweep(Homogeneous{});
}

/**
Both loops below need the contact forces of one block. Contact `i` lies between
sites `i` and `i + 1`; `push[k]` receives that of contact `lo - 1 + k`, the first
entry being known from the block before and the last one, at the end of the
range, from the boundary condition. */
template <class Along, class T, class Contact>
inline __attribute__((always_inline)) void block_contacts(const Contact& contact, const T* y,
                                                          const Along& along, std::size_t lo,
                                                          std::size_t hi, std::size_t n, T left,
                                                          T right, T* push) {
  const std::size_t last = hi < n ? hi : n - 1;
  push[0] = left;
  for (std::size_t i = lo; i < last; ++i)
    push[i + 1 - lo] = along.contact(i + 1, contact.force(y[i + 1] - y[i]));
  if (hi == n) push[hi - lo] = right;
}

/// How a sweep adds a kick to velocity `i` and a drift to position `i`: here as the processor does,
/// elsewhere (compensated.hpp) together with what earlier sums have lost.
struct PlainSum {
  template <class T>
  __attribute__((always_inline)) void kick(T& v, std::size_t, T term) const {
    v += term;
  }
  template <class T>
  __attribute__((always_inline)) void drift(T& y, std::size_t, T term) const {
    y += term;
  }
  PlainSum from(std::size_t) const { return {}; }
};

/**
A splitting method alternates kicks and drifts. Both touch the same site once its
neighbours' old positions have been read, so one sweep does
$v \leftarrow v + k\,\ddot y(y)$ and then $y \leftarrow y + d\,v$. */
template <class Sum, class Along, class T, class Onsite, class Contact>
LATTICE_WIDE void sweep_kick_drift(const Onsite onsite, const Contact contact, T* __restrict__ y,
                                   T* __restrict__ v, const Sum sum, const Along along,
                                   std::size_t n, T left, T right, T kick, T drift) {
  T push[kernel_block + 1];
  for (std::size_t lo = 0; lo < n; lo += kernel_block) {
    const std::size_t hi = lo + kernel_block < n ? lo + kernel_block : n;
    block_contacts(contact, y, along, lo, hi, n, left, right, push);
    left = push[hi - lo];
    for (std::size_t i = lo; i < hi; ++i) {
      const T a = along.bead(i, onsite.force(y[i]) + (push[i - lo] - push[i - lo + 1]));
      sum.kick(v[i], i, kick * a);
      sum.drift(y[i], i, drift * v[i]);
    }
  }
}

/**
Methods that combine the accelerations of several stages, such as that of contact_rkn.hpp, must keep
them. For them the same two passes leave the accelerations `a` at positions `y`. */
template <class Along, class T, class Onsite, class Contact>
LATTICE_WIDE void sweep_acceleration(const Onsite onsite, const Contact contact,
                                     const T* __restrict__ y, T* __restrict__ a, const Along along,
                                     std::size_t n, T left, T right) {
  T push[kernel_block + 1];
  for (std::size_t lo = 0; lo < n; lo += kernel_block) {
    const std::size_t hi = lo + kernel_block < n ? lo + kernel_block : n;
    block_contacts(contact, y, along, lo, hi, n, left, right, push);
    left = push[hi - lo];
    for (std::size_t i = lo; i < hi; ++i)
      a[i] = along.bead(i, onsite.force(y[i]) + (push[i - lo] - push[i - lo + 1]));
  }
}

}  // namespace lattice
