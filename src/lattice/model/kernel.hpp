#pragma once
/**
# The inner loop

Nearly all of the computing time is spent in the two loops of this file, which evaluate the right-hand
side of the equations of motion in chain.hpp; so they are written for the machine. A first pass over a
block of sites computes the contact forces, a second one the accelerations. Each is a plain loop that
the compiler vectorises, the block stays in the first-level cache, and the speed is limited by the
square root in the contact law.

The loops are compiled several times, for wider and wider vectors, and the widest version that the
processor can run is chosen when the program starts. Every operation in them is a single IEEE operation
on one site (the build forbids fused multiply-adds), so all versions give the same bits. */

#include <cstddef>
#include <type_traits>

#include "lattice/numerics/ieee.hpp"

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

/// Sites handled between the two passes. With a block this short the processor begins the roots of the
/// next block while it is still updating the sites of the last; with 512 sites the measured rate was one
/// quarter lower.
inline constexpr std::size_t kernel_block = 64;

/**
Beads may differ in mass and contacts in stiffness, and what does not vary should cost nothing: so the
choice is part of the type. The numbers are kept as they were given, in `double`. A run in double
multiplies by the inverse mass; one in extended precision divides by the mass itself, so that it solves the
same chain to all of its digits. */
struct Varied {
  const double* eta = nullptr;           ///< eta[i]: stiffness of the contact between i - 1 and i
  const double* mass = nullptr;          ///< mu_n
  const double* inverse_mass = nullptr;  ///< 1 / mu_n, rounded

  /// The force of contact `i` from that of unit stiffness.
  template <class T>
  T contact(std::size_t i, T force) const {
    return T(eta[i]) * force;
  }
  /// The acceleration of bead `n` under this force.
  template <class T>
  T bead(std::size_t n, T force) const {
    if constexpr (std::is_same_v<T, double>)
      return force * inverse_mass[n];
    else
      return force / T(mass[n]);
  }
};

/**
In most of the article nothing varies, and both functions return the force unchanged. */
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
Both loops below need the contact forces of one block of sites, `lo` to `hi - 1`. `push[k]` receives
that of contact `lo + k`, between sites `lo + k - 1` and `lo + k` (boundary.hpp). The first entry is
known from the previous block, and at the end of the range the last one comes from the boundary
condition. */
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

/**
A splitting method alternates kicks of the velocities and drifts of the positions (schemes.hpp). A site
may be drifted as soon as its neighbours have read its old position, so a single sweep does both:
$v \leftarrow v + k\,\ddot y(y)$ and then $y \leftarrow y + d\,v$, with `kick` $k$ and `drift` $d$. */
template <class Along, class T, class Onsite, class Contact>
LATTICE_WIDE void sweep_kick_drift(const Onsite onsite, const Contact contact, T* __restrict__ y,
                                   T* __restrict__ v, const Along along, std::size_t n, T left,
                                   T right, T kick, T drift) {
  T push[kernel_block + 1];
  for (std::size_t lo = 0; lo < n; lo += kernel_block) {
    const std::size_t hi = lo + kernel_block < n ? lo + kernel_block : n;
    block_contacts(contact, y, along, lo, hi, n, left, right, push);
    left = push[hi - lo];
    for (std::size_t i = lo; i < hi; ++i) {
      const T a = along.bead(i, onsite.force(y[i]) + (push[i - lo] - push[i - lo + 1]));
      v[i] += kick * a;
      y[i] += drift * v[i];
    }
  }
}

/**
Methods that combine the accelerations of several stages, such as that of event_corrected.hpp, must keep
them. For these the same two passes write the accelerations at the positions `y` into `a`. */
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
