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

/** Not every compiler and platform has function multiversioning; there the one
portable version remains, with the same results. */
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

/// Optional variation along the chain. Null pointers mean a homogeneous chain.
template <class T>
struct Variation {
  const T* eta = nullptr;           ///< eta[i]: stiffness factor of the contact between i-1 and i
  const T* inverse_mass = nullptr;  ///< 1 / mu_n
};

/**
Both loops below need the contact forces of one block. Contact `i` lies between
sites `i` and `i + 1`; `push[k]` receives that of contact `lo - 1 + k`, the first
entry being known from the block before and the last one, at the end of the
range, from the boundary condition. */
template <bool varied, class T, class Contact>
inline __attribute__((always_inline)) void block_contacts(const Contact& contact, const T* y,
                                                          Variation<T> along, std::size_t lo,
                                                          std::size_t hi, std::size_t n, T left,
                                                          T right, T* push) {
  const std::size_t last = hi < n ? hi : n - 1;
  push[0] = left;
  for (std::size_t i = lo; i < last; ++i) {
    const T force = contact.force(y[i + 1] - y[i]);
    if constexpr (varied)
      push[i + 1 - lo] = along.eta[i + 1] * force;
    else
      push[i + 1 - lo] = force;
  }
  if (hi == n) push[hi - lo] = right;
}

/**
A splitting method alternates kicks and drifts. Both touch the same site once its
neighbours' old positions have been read, so one sweep does
$v \leftarrow v + k\,\ddot y(y)$ and then $y \leftarrow y + d\,v$. */
template <bool varied, class T, class Onsite, class Contact>
LATTICE_WIDE void sweep_kick_drift(const Onsite onsite, const Contact contact, T* __restrict__ y,
                                   T* __restrict__ v, Variation<T> along, std::size_t n, T left,
                                   T right, T kick, T drift) {
  T push[kernel_block + 1];
  for (std::size_t lo = 0; lo < n; lo += kernel_block) {
    const std::size_t hi = lo + kernel_block < n ? lo + kernel_block : n;
    block_contacts<varied>(contact, y, along, lo, hi, n, left, right, push);
    left = push[hi - lo];
    for (std::size_t i = lo; i < hi; ++i) {
      T a = onsite.force(y[i]) + (push[i - lo] - push[i - lo + 1]);
      if constexpr (varied) a *= along.inverse_mass[i];
      v[i] += kick * a;
      y[i] += drift * v[i];
    }
  }
}

/// Accelerations `a` at positions `y`, for the methods that keep several of them.
template <bool varied, class T, class Onsite, class Contact>
LATTICE_WIDE void sweep_acceleration(const Onsite onsite, const Contact contact,
                                     const T* __restrict__ y, T* __restrict__ a, Variation<T> along,
                                     std::size_t n, T left, T right) {
  T push[kernel_block + 1];
  for (std::size_t lo = 0; lo < n; lo += kernel_block) {
    const std::size_t hi = lo + kernel_block < n ? lo + kernel_block : n;
    block_contacts<varied>(contact, y, along, lo, hi, n, left, right, push);
    left = push[hi - lo];
    for (std::size_t i = lo; i < hi; ++i) {
      a[i] = onsite.force(y[i]) + (push[i - lo] - push[i - lo + 1]);
      if constexpr (varied) a[i] *= along.inverse_mass[i];
    }
  }
}

}  // namespace lattice
