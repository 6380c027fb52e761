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
from one in tables, as in the article. All functions with a number type exist in `double`, `long double` and quadruple
precision. */

#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

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
Contact $i$ lies between the beads $i - 1$ and $i$, so a chain of $N$ beads has $N + 1$ places for one. What is found at
the first and the last place is the boundary condition:

        free       .   o---o---o   .        contacts 1 .. N-1
        fixed      |---o---o---o---|        0 and N lead to a wall, a bead that never moves
        periodic   (---o---o---o---)        0 and N are one contact, between last and first bead */
enum class Ends { free, fixed, periodic };

/// The names of the ends, in the order of `Ends`.
inline constexpr const char* ends_names[] = {"free", "fixed", "periodic"};

/// What differs from bead to bead and from contact to contact, as `vary` sets it.
struct Variation {
  std::vector<double> mass;          ///< mu_n, one entry per site
  std::vector<double> inverse_mass;  ///< 1 / mu_n
  std::vector<double> eta;           ///< one entry more; eta[i] is the contact of i-1 with i
};

/**
A chain is defined by its length, its two potentials and its ends; by default it is that of Eq. (9), with harmonic wells,
plain Hertzian contacts and free ends. It is a plain value, whatever its potentials are. `vary`, below, sets masses and
stiffnesses; without them the chain is homogeneous, and the inner loop (kernel.hpp) is shorter. */
struct Chain {
  std::size_t sites = 0;
  Well well{};
  Contact contact{};
  Ends ends = Ends::free;
  std::optional<Variation> variation{};  ///< nothing where all masses and stiffnesses are one

  /// The same chain of `n` sites. Throws std::invalid_argument if its masses and stiffnesses are those of another number,
  /// since how they go on is not known.
  Chain with_sites(std::size_t n) const;
  /// Whether contact `i` lies between two beads that are neighbours in the row.
  bool inside(std::size_t i) const { return i > 0 && i < sites; }
  /// Whether contact `i`, 0 <= i <= sites, exists and acts on the bead or beads next to it.
  bool has_contact(std::size_t i) const { return inside(i) || ends != Ends::free; }
  /// mu_n of bead `n`, from 0.
  double mass_of(std::size_t n) const { return variation ? variation->mass[n] : 1; }
  /// eta of contact `i`; contact 0 of a ring is its contact `sites`.
  double eta_of(std::size_t i) const {
    return variation ? variation->eta[i == 0 && ends == Ends::periodic ? sites : i] : 1;
  }
};

/// Gives the chain masses, one per site, and stiffnesses, one more; either may be empty, which means one everywhere.
/// Throws std::invalid_argument if the lengths do not fit, a mass is not positive, a stiffness is negative, or a ring has
/// two different stiffnesses for the contact of its last bead with its first.
void vary(Chain& chain, const std::vector<double>& mass, const std::vector<double>& eta);

/// Throws std::invalid_argument unless the chain has masses and stiffnesses as `vary` makes them, or none, and a row of
/// `entries` numbers has one for each site: the length of a chain may have been changed since.
void assert_fits(const Chain& chain, std::size_t entries);

/**
Whatever is computed outside the inner loop asks the chain the questions that follow, so that masses, stiffnesses and ends
are treated alike everywhere. */
/// How much a unit of force accelerates bead `n`, 1 / mu_n in the precision of the run.
template <class T>
T inverse_mass(const Chain& chain, std::size_t n) {
  if (!chain.variation) return T(1);
  if constexpr (std::is_same_v<T, double>) return chain.variation->inverse_mass[n];
  return T(1) / T(chain.variation->mass[n]);
}

/// Stretch of contact `i`, q[i] - q[i - 1], in the positions (or velocities, or accelerations) `q`; a wall counts as a
/// bead at rest.
template <class T>
T stretch(const Chain& chain, const T* q, std::size_t i) {
  if (chain.inside(i)) [[likely]]
    return q[i] - q[i - 1];
  if (chain.ends == Ends::periodic) return q[0] - q[chain.sites - 1];
  return i == 0 ? q[0] : -q[chain.sites - 1];
}

/// Whether contact `i` exists and is not another one once more: that of last and first bead of a ring counts as `sites`.
inline bool is_distinct_contact(const Chain& chain, std::size_t i) {
  return chain.inside(i) || chain.ends == Ends::fixed || (chain.ends == Ends::periodic && i > 0);
}

/// Push of contact `i` on the bead to its right; zero where there is no contact.
template <class T>
T contact_push(const Chain& chain, const T* y, std::size_t i) {
  if (!chain.has_contact(i)) return T(0);
  return T(chain.eta_of(i)) * chain.contact.force(stretch(chain, y, i));
}

/// Acceleration of bead `n` at the positions `y`, Eqs. (9) and (32): the equation of motion of the beginning, as code.
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
All integrators move the chain by one of two calls, at the moving sites; both wake what is pushed. */
/// Changes velocities by `kick` times the accelerations, then positions by `drift` times the velocities.
template <class T>
void kick_drift(const Chain& chain, State<T>& state, Window& window, std::type_identity_t<T> kick,
                std::type_identity_t<T> drift);

/// Writes the accelerations at the positions `y` to `a`, both with one entry per site.
template <class T>
void accelerate(const Chain& chain, const T* y, T* a, Window& window);

/// Accelerations of the whole chain at the positions `y`, one entry per site.
template <class T>
std::vector<T> accelerations(const Chain& chain, const std::vector<T>& y);

/// Energy of contact `i`, each contact counted once.
template <class T>
T contact_energy(const Chain& chain, const T* y, std::size_t i) {
  if (!is_distinct_contact(chain, i)) return T(0);
  return T(chain.eta_of(i)) * chain.contact.energy(stretch(chain, y, i));
}

/**
A packet is followed by where its energy is. The energy of a site is its kinetic energy, that of its well
and that of the contact to its right, Eq. (23); without precompression and with $\eta_n = 1$
$$e_n = \tfrac12\,\dot y_n^2 + W(y_n) + \tfrac25\,(y_n-y_{n+1})_+^{5/2}.$$
(The factor $\gamma$ printed there is one in these units.) With fixed ends the first site also counts
the contact with the left wall, so that the densities add up to the Hamiltonian. */
/// Energy density e_n, one entry per site.
template <class T>
std::vector<T> energy_density(const Chain& chain, const State<T>& state);

/// The Hamiltonian of Eq. (6), summed from the first site to the last: equal states have equal bits.
template <class T>
T energy(const Chain& chain, const State<T>& state);

/// Contact forces of site n on n + 1, `sites` entries: not negative without precompression, and
/// the article's f_n with the opposite sign.
std::vector<double> contact_forces(const Chain& chain, const std::vector<double>& y);

/// A symmetric, tridiagonal matrix with one entry of `diagonal` and `off` per site: off[n] couples n and n + 1, and its
/// last entry the two ends of a ring.
struct Hessian {
  std::vector<double> diagonal, off;
};

/// The second derivatives of the potential energy at the positions `y`, of which phonons and stability follow.
Hessian linearise(const Chain& chain, const std::vector<double>& y);

}  // namespace lattice
