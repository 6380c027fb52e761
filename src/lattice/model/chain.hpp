#pragma once
/**
# The chain

The article studies a row of beads, each held by a well of its own (a pendulum, an elastic beam) and
pushing on its two neighbours. Bead $n$ has the mass $\mu_n$ and the displacement $y_n$; the wells have
the potential $W$ (well.hpp), the contacts the potential $V$ (contact.hpp), and $\eta_n$ is the stiffness
of the contact between the beads $n$ and $n+1$:
$$\mu_n \ddot y_n = -W'(y_n) + \eta_n V'(y_{n+1}-y_n) - \eta_{n-1} V'(y_n-y_{n-1}).$$
This is Eq. (32) with wells and contacts of any kind. With $\mu_n = \eta_n = 1$ the
Hamiltonian is that of Eq. (6):
$$\mathcal H = \sum_n \tfrac12\,\dot y_n^2 + W(y_n) + V(y_{n+1}-y_n).$$
Everything is dimensionless (cantilever.hpp has the units). Sites are counted from zero in the code and
from one in tables, as in the article. */

#include <cstddef>
#include <type_traits>
#include <vector>

#include "lattice/model/boundary.hpp"
#include "lattice/model/contact.hpp"
#include "lattice/model/well.hpp"

namespace lattice {

/// Positions and velocities at time `t`; both vectors have one entry per site.
template <class T = double>
struct State {
  std::vector<T> y, v;
  T t = 0;
  State() = default;
  /// All beads at rest in their places at t = 0.
  explicit State(std::size_t sites) : y(sites, T(0)), v(sites, T(0)) {}
};

/// The sites `first <= n < last` that have begun to move; all the others are exactly at rest.
struct Window {
  std::size_t first = 0, last = 0;
  friend bool operator==(const Window&, const Window&) = default;
};

/**
A chain is defined by its length, its two potentials and its ends (boundary.hpp); by default it is that of
Eq. (9), with harmonic wells, plain Hertzian contacts and free ends. It is a plain value, whatever its
potentials are: a loop along the chain asks once which they are and is then as fast as one written for them.
`vary`, below, sets masses and stiffnesses; without them the chain is homogeneous, and the inner loop is
shorter. */
struct Chain {
  std::size_t sites = 0;
  Well well{};
  Contact contact{};
  Ends ends = Ends::free;
  std::vector<double> mass{};          ///< mu_n, one entry per site
  std::vector<double> inverse_mass{};  ///< 1 / mu_n
  std::vector<double> eta{};           ///< sites + 1 entries; eta[i] is the contact of i-1 with i

  /// Which contacts there are, at the ends too.
  Boundary boundary() const { return {sites, ends, ends}; }
  /// mu_n of bead `n`, from 0.
  double mass_of(std::size_t n) const { return mass.empty() ? 1 : mass[n]; }
  /// eta of contact `i`, the one between i - 1 and i.
  double eta_of(std::size_t i) const { return eta.empty() ? 1 : eta[boundary().own(i)]; }
};

/**
A wrong mass would spoil a run without any sign of it, so every number is checked when it enters.
`mass` has one entry per site and `eta` one more; either may be empty, which means one everywhere. Throws
std::invalid_argument if the lengths do not fit, a mass is not positive, a stiffness is negative,
or a ring has two different stiffnesses for the contact of its last bead with its first. */
void vary(Chain& chain, const std::vector<double>& mass, const std::vector<double>& eta);

/**
A chain whose length is changed after `vary` no longer fits its masses. So whatever takes a chain and rows of numbers, an
energy with which every run begins, the accelerations or a linearisation, first asks whether all of them fit. */
/// Throws std::invalid_argument unless the chain has masses and stiffnesses as `vary` makes them, or none, and a row of
/// `entries` numbers has one for each site.
void assert_fits(const Chain& chain, std::size_t entries);

/**
Whatever is computed outside the inner loop (an energy, a linearisation, the instant at which a contact
opens) asks the chain the questions that follow, so that masses, stiffnesses and ends are treated alike
everywhere. The first one is how much a unit of force accelerates bead `n`: $1/\mu_n$, in the precision
of the run. */
template <class T>
T inverse_mass(const Chain& chain, std::size_t n) {
  if (chain.mass.empty()) return T(1);
  if constexpr (std::is_same_v<T, double>) return chain.inverse_mass[n];
  return T(1) / T(chain.mass[n]);
}

/// Stretch of contact `i` in the positions (or velocities, or accelerations) `q`.
template <class T>
T stretch(const Chain& chain, const T* q, std::size_t i) {
  return chain.boundary().stretch(q, i);
}

/// Whether there is a contact `i`, each contact counted once.
inline bool touches(const Chain& chain, std::size_t i) {
  return chain.boundary().counts(i);
}

/// Push of contact `i`, between sites i - 1 and i, on the bead to its right; zero where there is no
/// contact.
template <class T>
T contact_push(const Chain& chain, const T* y, std::size_t i) {
  if (!chain.boundary().pushes(i)) return T(0);
  return T(chain.eta_of(i)) * chain.contact.force(stretch(chain, y, i));
}

/**
This is the equation of motion of the beginning, as code. The inner loops (kernel.hpp) do the same operations for whole
rows of beads. */
/// Acceleration of bead `n` at the positions `y`, Eqs. (9) and (32).
template <class T>
T acceleration(const Chain& chain, const T* y, std::size_t n) {
  const T force =
      chain.well.force(y[n]) + (contact_push(chain, y, n) - contact_push(chain, y, n + 1));
  return force * inverse_mass<T>(chain, n);
}

/**
An impact at one end reaches the far end late, and until then most beads are exactly at rest and need
no work. So only a window of moving sites is computed. It grows by one site at either edge whenever the
contact there begins to push. This is tested in every force evaluation; hence a windowed run has the same
bits as a run of the whole chain, at a cost that does not depend on the chain's length. */
/// The smallest window that holds everything that is displaced or moves; the whole of a ring.
template <class T>
Window waking(const Chain& chain, const State<T>& state);

/**
All integrators move the chain by one of two calls. Splitting methods (schemes.hpp) kick and drift: they
change velocities by `kick` times the accelerations, then positions by `drift` times the velocities, at
all moving sites. The other methods ask for the accelerations `a` at the positions `y`. Like all functions
of this file that have a number type they exist in `double`, `long double` and quadruple precision. */
template <class T>
void kick_drift(const Chain& chain, State<T>& state, Window& window, std::type_identity_t<T> kick,
                std::type_identity_t<T> drift);

/// Writes the accelerations at the moving sites to `a`, one entry per site; wakes what is pushed.
template <class T>
void accelerate(const Chain& chain, const T* y, T* a, Window& window);

/// Accelerations of the whole chain at the positions `y`, one entry per site.
template <class T>
std::vector<T> accelerations(const Chain& chain, const std::vector<T>& y);

/**
A packet is followed by where its energy is. The energy of a site is its kinetic energy, that of its well
and that of the contact to its right, Eq. (23); without precompression and with $\eta_n = 1$
$$e_n = \tfrac12\,\dot y_n^2 + W(y_n) + \tfrac25\,(y_n-y_{n+1})_+^{5/2}.$$
(The factor $\gamma$ printed there is one in these units.) With fixed ends the first site also counts
the contact with the left wall, so that the densities add up to the Hamiltonian, Eq. (6). */
template <class T>
T contact_energy(const Chain& chain, const T* y, std::size_t i) {
  if (!touches(chain, i)) return T(0);
  return T(chain.eta_of(i)) * chain.contact.energy(stretch(chain, y, i));
}

/// Energy density e_n, one entry per site.
template <class T>
std::vector<T> energy_density(const Chain& chain, const State<T>& state);

/**
The Hamiltonian of Eq. (6) is the sum of these densities. It is always summed from the first site to
the last, because sums of rounded numbers depend on their order, and equal states are to report equal
bits. */
template <class T>
T energy(const Chain& chain, const State<T>& state);

/// Contact forces of site n on n + 1, `sites` entries: not negative without precompression, and
/// the article's f_n with the opposite sign.
template <class T>
std::vector<T> contact_forces(const Chain& chain, const std::vector<T>& y);

/**
Small motions about a state at rest, its phonons and its stability, follow from one matrix: the second
derivatives of the potential energy at `y`, symmetric and tridiagonal. `diagonal` and `off` have one
entry per site; `off[n]` couples n and n + 1, and its last entry couples the two ends of a ring. */
template <class T>
struct Hessian {
  std::vector<T> diagonal, off;
};

/// The second derivatives of the potential energy at the positions `y`.
template <class T>
Hessian<T> linearise(const Chain& chain, const std::vector<T>& y);

}  // namespace lattice
