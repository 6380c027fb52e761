#pragma once
/**
# The chain

The article studies a row of beads, each held by a well of its own (a pendulum, an elastic beam) and
pushing on its two neighbours. Bead $n$ has the mass $\mu_n$ and the displacement $y_n$; the wells have
the potential $W$ (well.hpp), the contacts the potential $V$ (contact.hpp), and $\eta_n$ is the stiffness
of the contact between the beads $n$ and $n+1$:
$$\mu_n \ddot y_n = -W'(y_n) + \eta_n V'(y_{n+1}-y_n) - \eta_{n-1} V'(y_n-y_{n-1}).$$
This is Eq. (32) with wells and contacts of any kind. With $\mu_n = \eta_n = 1$ it is the chain of
section 3, whose Hamiltonian is Eq. (6):
$$\mathcal H = \sum_n \tfrac12\,\dot y_n^2 + W(y_n) + V(y_{n+1}-y_n).$$
Everything is dimensionless (cantilever.hpp has the units). Sites are counted from zero in the code and
from one in tables, as in the article. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "lattice/model/boundary.hpp"
#include "lattice/model/contact.hpp"
#include "lattice/model/kernel.hpp"
#include "lattice/model/well.hpp"

namespace lattice {

/// Positions and velocities at time `t`; both vectors have one entry per site.
template <class T = double>
struct State {
  std::vector<T> y, v;
  T t = 0;
  State() = default;
  explicit State(std::size_t sites) : y(sites, T(0)), v(sites, T(0)) {}
};

/// The sites `first <= n < last` that have begun to move; all the others are exactly at rest.
struct Window {
  std::size_t first = 0, last = 0;
  friend bool operator==(const Window&, const Window&) = default;
};

/**
A chain is defined by its two potentials, its length and its ends (boundary.hpp). `vary`, below, sets
masses and stiffnesses; where their lists are empty the chain is homogeneous, and the inner loop is
shorter. */
template <class Onsite, class Contact>
struct Chain {
  std::size_t sites = 0;
  Onsite onsite{};
  Contact contact{};
  Ends ends = Ends::free;
  std::vector<double> mass{};          ///< mu_n, one entry per site
  std::vector<double> inverse_mass{};  ///< 1 / mu_n
  std::vector<double> eta{};           ///< sites + 1 entries; eta[i] is the contact of i-1 with i

  Boundary boundary() const { return {sites, ends, ends}; }
  double mass_of(std::size_t n) const { return mass.empty() ? 1 : mass[n]; }
  double eta_of(std::size_t i) const { return eta.empty() ? 1 : eta[boundary().own(i)]; }
};

/**
A wrong mass would spoil a run without any sign of it, so every number is checked when it enters.
`mass` has one entry per site and `eta` one more; either may be empty, which means one everywhere. Throws
std::invalid_argument if the lengths do not fit, a mass is not positive, a stiffness is negative,
or a ring has two different stiffnesses for the contact of its last bead with its first. */
template <class Onsite, class Contact>
void vary(Chain<Onsite, Contact>& chain, const std::vector<double>& mass,
          const std::vector<double>& eta) {
  if ((!mass.empty() && mass.size() != chain.sites) ||
      (!eta.empty() && eta.size() != chain.sites + 1))
    throw std::invalid_argument("a chain of N sites needs N masses and N + 1 contact stiffnesses");
  if (!std::all_of(mass.begin(), mass.end(), [](double m) { return m > 0 && std::isfinite(m); }))
    throw std::invalid_argument("every mass must be finite and > 0");
  if (!std::all_of(eta.begin(), eta.end(), [](double k) { return k >= 0 && std::isfinite(k); }))
    throw std::invalid_argument("every contact stiffness must be finite and >= 0");
  if (chain.ends == Ends::periodic && !eta.empty() && eta.front() != eta.back())
    throw std::invalid_argument("the first and last stiffness of a ring are those of one contact");
  chain.eta = eta;
  chain.mass = mass;
  chain.inverse_mass.resize(mass.size());
  std::transform(mass.begin(), mass.end(), chain.inverse_mass.begin(),
                 [](double m) { return 1 / m; });
}

/**
Whatever is computed outside the inner loop (an energy, a linearisation, the instant at which a contact
opens) asks the chain the questions that follow, so that masses, stiffnesses and ends are treated alike
everywhere. The first one is how much a unit of force accelerates bead `n`: $1/\mu_n$, in the precision
of the run. */
template <class T, class Onsite, class Contact>
T lightness(const Chain<Onsite, Contact>& chain, std::size_t n) {
  if (chain.mass.empty()) return T(1);
  if constexpr (std::is_same_v<T, double>) return chain.inverse_mass[n];
  return T(1) / T(chain.mass[n]);
}

/// Stretch of contact `i` in the positions (or velocities, or accelerations) `q`.
template <class T, class Onsite, class Contact>
T stretch(const Chain<Onsite, Contact>& chain, const T* q, std::size_t i) {
  return chain.boundary().stretch(q, i);
}

/// Whether there is a contact `i`, each contact counted once.
template <class Onsite, class Contact>
bool touches(const Chain<Onsite, Contact>& chain, std::size_t i) {
  return chain.boundary().counts(i);
}

/// Push of contact `i`, between sites i - 1 and i, on the bead to its right; zero where there is no
/// contact.
template <class T, class Onsite, class Contact>
inline T contact_push(const Chain<Onsite, Contact>& chain, const T* y, std::size_t i) {
  if (!chain.boundary().pushes(i)) return T(0);
  return T(chain.eta_of(i)) * chain.contact.force(stretch(chain, y, i));
}

/**
An impact at one end reaches the far end late, and until then most beads are exactly at rest and need
no work. So only a window of moving sites is computed. It grows by one site at either edge whenever the
contact there begins to push. This is tested in every force evaluation; hence a windowed run has the same
bits as a run of the whole chain, at a cost that does not depend on the chain's length. */
template <class T, class Onsite, class Contact>
void widen(const Chain<Onsite, Contact>& chain, const T* y, Window& window) {
  if (window.first > 0 && contact_push(chain, y, window.first) != T(0)) --window.first;
  if (window.last < chain.sites && contact_push(chain, y, window.last) != T(0)) ++window.last;
}

/// The smallest window that holds everything that is displaced or moves; the whole of a ring.
template <class T, class Onsite, class Contact>
Window waking(const Chain<Onsite, Contact>& chain, const State<T>& state) {
  if (chain.ends == Ends::periodic) return {0, chain.sites};
  std::size_t first = 0, last = chain.sites;
  const auto rests = [&](std::size_t n) { return state.y[n] == T(0) && state.v[n] == T(0); };
  while (first < last && rests(first)) ++first;
  while (last > first && rests(last - 1)) --last;
  return {first, last};
}

/**
The loops of kernel.hpp know nothing of windows and ends; they want a range of sites, the pushes at its
two edges, and the masses and stiffnesses in between. So before each sweep the window is widened and the
pushes `left` and `right` at its edges are evaluated. */
template <class T, class Onsite, class Contact, class Sweep>
void with_edges(const Chain<Onsite, Contact>& chain, const T* y, Window& window, Sweep sweep) {
  if (window.first == window.last) return;
  widen(chain, y, window);
  sweep(contact_push(chain, y, window.first), contact_push(chain, y, window.last));
}

/// Calls `sweep(variation, at, count, left, right)` for the `count` moving sites from `at` on, with the
/// pushes at both edges and the masses and stiffnesses that are not one (`Variation` in kernel.hpp).
template <class T, class Onsite, class Contact, class Sweep>
void sweep_window(const Chain<Onsite, Contact>& chain, const T* y, Window& window, Sweep sweep) {
  with_edges(chain, y, window, [&](T left, T right) {
    const auto from = [&](const std::vector<double>& all) {
      return all.empty() ? nullptr : all.data() + window.first;
    };
    with_variation(from(chain.eta), from(chain.mass), from(chain.inverse_mass),
                   [&](const auto& along) {
                     sweep(along, window.first, window.last - window.first, left, right);
                   });
  });
}

/**
All integrators move the chain by one of two calls. Splitting methods (schemes.hpp) kick and drift: they
change velocities by `kick` times the accelerations, then positions by `drift` times the velocities, at
all moving sites; `sum` says how a small number is added to a large one (kernel.hpp). The other methods
ask for the accelerations `a` at the positions `y`. */
template <class T, class Onsite, class Contact, class Sum = PlainSum>
void kick_drift(const Chain<Onsite, Contact>& chain, State<T>& state, Window& window, T kick,
                T drift, const Sum& sum = {}) {
  sweep_window(chain, state.y.data(), window,
               [&](const auto& along, std::size_t at, std::size_t count, T left, T right) {
                 sweep_kick_drift(chain.onsite, chain.contact, state.y.data() + at,
                                  state.v.data() + at, sum.from(at), along, count, left, right,
                                  kick, drift);
               });
}

template <class T, class Onsite, class Contact>
void accelerate(const Chain<Onsite, Contact>& chain, const T* y, T* a, Window& window) {
  sweep_window(
      chain, y, window, [&](const auto& along, std::size_t at, std::size_t count, T left, T right) {
        sweep_acceleration(chain.onsite, chain.contact, y + at, a + at, along, count, left, right);
      });
}

/// Accelerations of the whole chain at the positions `y`, one entry per site.
template <class T, class Onsite, class Contact>
std::vector<T> accelerations(const Chain<Onsite, Contact>& chain, const std::vector<T>& y) {
  std::vector<T> a(chain.sites, T(0));
  Window all{0, chain.sites};
  accelerate(chain, y.data(), a.data(), all);
  return a;
}

/**
A packet is followed by where its energy is. The energy of a site is its kinetic energy, that of its well
and that of the contact to its right, Eq. (23); without precompression and with $\eta_n = 1$
$$e_n = \tfrac12\,\dot y_n^2 + W(y_n) + \tfrac25\,(y_n-y_{n+1})_+^{5/2}.$$
(The factor $\gamma$ printed there is one in these units.) With fixed ends the first site also counts
the contact with the left wall, so that the densities add up to the Hamiltonian, Eq. (6). */
template <class T, class Onsite, class Contact>
T contact_energy(const Chain<Onsite, Contact>& chain, const T* y, std::size_t i) {
  if (!touches(chain, i)) return T(0);
  return T(chain.eta_of(i)) * chain.contact.energy(stretch(chain, y, i));
}

/// Energy density e_n, one entry per site.
template <class T, class Onsite, class Contact>
std::vector<T> energy_density(const Chain<Onsite, Contact>& chain, const State<T>& state) {
  std::vector<T> e(chain.sites);
  for (std::size_t n = 0; n < chain.sites; ++n) {
    e[n] = T(chain.mass_of(n)) * state.v[n] * state.v[n] / T(2) + chain.onsite.energy(state.y[n]) +
           contact_energy(chain, state.y.data(), n + 1);
    if (n == 0) e[n] += contact_energy(chain, state.y.data(), 0);
  }
  return e;
}

/**
The Hamiltonian of Eq. (6) is the sum of these densities. It is always summed from the first site to
the last, because sums of rounded numbers depend on their order, and equal states are to report equal
bits. */
template <class T, class Onsite, class Contact>
T energy(const Chain<Onsite, Contact>& chain, const State<T>& state) {
  T sum(0);
  for (const T& e : energy_density(chain, state)) sum += e;
  return sum;
}

/// Contact forces of site n on n + 1, `sites` entries: not negative without precompression, and
/// the article's f_n with the opposite sign.
template <class T, class Onsite, class Contact>
std::vector<T> contact_forces(const Chain<Onsite, Contact>& chain, const std::vector<T>& y) {
  std::vector<T> f(chain.sites);
  for (std::size_t n = 0; n < chain.sites; ++n) f[n] = contact_push(chain, y.data(), n + 1);
  return f;
}

/**
Small motions about a state at rest, its phonons and its stability, follow from one matrix: the second
derivatives of the potential energy at `y`, symmetric and tridiagonal. `diagonal` and `off` have one
entry per site; `off[n]` couples n and n + 1, and its last entry couples the two ends of a ring. */
template <class T>
struct Hessian {
  std::vector<T> diagonal, off;
};

/// The second derivatives of the potential energy at the positions `y`.
template <class T, class Onsite, class Contact>
Hessian<T> linearise(const Chain<Onsite, Contact>& chain, const std::vector<T>& y) {
  const std::size_t n = chain.sites;
  const bool ring = chain.ends == Ends::periodic;
  Hessian<T> h{std::vector<T>(n), std::vector<T>(n, T(0))};
  for (std::size_t i = 0; i < n; ++i) h.diagonal[i] = chain.onsite.stiffness(y[i]);
  for (std::size_t i = 0; i <= n; ++i) {
    if (!touches(chain, i)) continue;
    const T k = T(chain.eta_of(i)) * chain.contact.stiffness(stretch(chain, y.data(), i));
    if (i > 0) h.diagonal[i - 1] += k;
    if (i < n || ring) h.diagonal[i % n] += k;
    if (chain.boundary().inside(i) || ring) h.off[i - 1] = -k;
  }
  return h;
}

}  // namespace lattice
