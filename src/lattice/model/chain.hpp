#pragma once
/**
# The chain

Beads of mass $\mu_n$ sit in wells $W$ and push on their neighbours through
contacts $V$ of stiffness $\eta_n$, Eq. eqmnh of the article:
$$\mu_n \ddot y_n = -W'(y_n) + \eta_n V'(y_{n+1}-y_n) - \eta_{n-1} V'(y_n-y_{n-1}).$$
With $\mu_n = \eta_n = 1$ this is the chain of section 3, Eq. hamresc. Sites are
counted from zero in the code and from one in tables, as in the article. */

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <type_traits>
#include <vector>

#include "lattice/model/kernel.hpp"
#include "lattice/model/potential.hpp"

namespace lattice {

/// What lies beyond the first and last bead: nothing, a rigid bead at rest, or the other end.
enum class Ends { free, fixed, periodic };

/// Positions and velocities at time `t`; both vectors have one entry a site.
template <class T = double>
struct State {
  std::vector<T> y, v;
  T t = 0;
  State() = default;
  explicit State(std::size_t sites) : y(sites, T(0)), v(sites, T(0)) {}
};

/// The sites `first <= n < last` that have woken; all the others are exactly at rest.
struct Window {
  std::size_t first = 0, last = 0;
  friend bool operator==(const Window&, const Window&) = default;
};

/**
A chain is its two potentials, its length and its ends. Empty `mass` and `eta`
mean a homogeneous chain and select the shorter loop. */
template <class Onsite, class Contact>
struct Chain {
  std::size_t sites = 0;
  Onsite onsite{};
  Contact contact{};
  Ends ends = Ends::free;
  std::vector<double> inverse_mass{};  ///< 1 / mu_n, one entry a site
  std::vector<double> eta{};           ///< sites + 1 entries; eta[i] is the contact of i-1 with i

  bool varied() const { return !eta.empty() || !inverse_mass.empty(); }
  double eta_of(std::size_t contact_index) const { return eta.empty() ? 1 : eta[contact_index]; }
  double mass_of(std::size_t n) const { return inverse_mass.empty() ? 1 : 1 / inverse_mass[n]; }
};

/// Gives every bead a mass and every contact a stiffness. `mass` has one entry a site, `eta` one
/// more. Throws std::invalid_argument where the lengths do not fit or a mass is not positive.
template <class Onsite, class Contact>
void vary(Chain<Onsite, Contact>& chain, const std::vector<double>& mass,
          const std::vector<double>& eta) {
  if (mass.size() != chain.sites || eta.size() != chain.sites + 1)
    throw std::invalid_argument("a chain of N sites needs N masses and N + 1 contact stiffnesses");
  if (std::any_of(mass.begin(), mass.end(), [](double m) { return !(m > 0); }))
    throw std::invalid_argument("every mass must be > 0");
  chain.eta = eta;
  chain.inverse_mass.resize(chain.sites);
  std::transform(mass.begin(), mass.end(), chain.inverse_mass.begin(),
                 [](double m) { return 1 / m; });
}

/**
The boundary condition enters in one place: the push that the end contacts exert.
A free end exerts none, a fixed end acts like a bead that never moves, and a
periodic chain closes on itself. Contact `0` lies left of the first site and
contact `sites` right of the last. */
template <class T, class Onsite, class Contact>
T end_push(const Chain<Onsite, Contact>& chain, const T* y, bool first) {
  const std::size_t last = chain.sites - 1;
  const T eta = T(chain.eta_of(first ? 0 : chain.sites));
  if (chain.ends == Ends::periodic) return eta * chain.contact.force(y[0] - y[last]);
  if (chain.ends == Ends::fixed) return eta * chain.contact.force(first ? y[0] : -y[last]);
  return T(0);
}

/// Push of contact `i`, between sites i - 1 and i.
template <class T, class Onsite, class Contact>
inline T contact_push(const Chain<Onsite, Contact>& chain, const T* y, std::size_t i) {
  if (i == 0 || i == chain.sites) [[unlikely]]
    return end_push(chain, y, i == 0);
  return T(chain.eta_of(i)) * chain.contact.force(y[i] - y[i - 1]);
}

/**
Ahead of a front the beads are at rest exactly, so they need no work. The window
of woken sites grows by one whenever the contact at its edge begins to push: that
test happens inside every force evaluation, hence a windowed run has the same bits
as a run of the whole chain, and its cost does not depend on the chain's length. */
template <class T, class Onsite, class Contact>
void widen(const Chain<Onsite, Contact>& chain, const T* y, Window& window) {
  if (window.first > 0 && contact_push(chain, y, window.first) != T(0)) --window.first;
  if (window.last < chain.sites && contact_push(chain, y, window.last) != T(0)) ++window.last;
}

/// The smallest window that holds everything that moves; the whole chain if it is periodic.
template <class T, class Onsite, class Contact>
Window waking(const Chain<Onsite, Contact>& chain, const State<T>& state) {
  if (chain.ends == Ends::periodic) return {0, chain.sites};
  std::size_t first = 0, last = chain.sites;
  const auto rests = [&](std::size_t n) { return state.y[n] == T(0) && state.v[n] == T(0); };
  while (first < last && rests(first)) ++first;
  while (last > first && rests(last - 1)) --last;
  return {first, last};
}

/// Runs `sweep(left, right)` on the window with the pushes at its two edges, after widening it.
template <class T, class Onsite, class Contact, class Sweep>
void with_edges(const Chain<Onsite, Contact>& chain, const T* y, Window& window, Sweep sweep) {
  if (window.first == window.last) return;
  widen(chain, y, window);
  sweep(contact_push(chain, y, window.first), contact_push(chain, y, window.last));
}

/// Variation along the part of the chain that begins at site `first`.
template <class T, class Onsite, class Contact>
Variation<T> variation_from(const Chain<Onsite, Contact>& chain, std::size_t first) {
  static_assert(std::is_same_v<T, double>, "a varied chain is computed in double");
  return {chain.eta.data() + first, chain.inverse_mass.data() + first};
}

/// Kick by `kick`, then drift by `drift`, on all woken sites (see kernel.hpp).
template <class T, class Onsite, class Contact>
void kick_drift(const Chain<Onsite, Contact>& chain, State<T>& state, Window& window, T kick,
                T drift) {
  with_edges(chain, state.y.data(), window, [&](T left, T right) {
    const std::size_t at = window.first, count = window.last - at;
    T *y = state.y.data() + at, *v = state.v.data() + at;
    if (!chain.varied())
      sweep_kick_drift<false, T>(chain.onsite, chain.contact, y, v, {}, count, left, right, kick,
                                 drift);
    else if constexpr (std::is_same_v<T, double>)
      sweep_kick_drift<true, T>(chain.onsite, chain.contact, y, v, variation_from<T>(chain, at),
                                count, left, right, kick, drift);
  });
}

/// Accelerations `a` of all woken sites at positions `y`.
template <class T, class Onsite, class Contact>
void accelerate(const Chain<Onsite, Contact>& chain, const T* y, T* a, Window& window) {
  with_edges(chain, y, window, [&](T left, T right) {
    const std::size_t at = window.first, count = window.last - at;
    if (!chain.varied())
      sweep_acceleration<false, T>(chain.onsite, chain.contact, y + at, a + at, {}, count, left,
                                   right);
    else if constexpr (std::is_same_v<T, double>)
      sweep_acceleration<true, T>(chain.onsite, chain.contact, y + at, a + at,
                                  variation_from<T>(chain, at), count, left, right);
  });
}

/// Accelerations of the whole chain.
template <class T, class Onsite, class Contact>
std::vector<T> accelerations(const Chain<Onsite, Contact>& chain, const std::vector<T>& y) {
  std::vector<T> a(chain.sites, T(0));
  Window all{0, chain.sites};
  accelerate(chain, y.data(), a.data(), all);
  return a;
}

/**
The energy at a site is its kinetic and well energy and that of the contact to
its right, Eq. endens. (The factor $\gamma$ printed there is one in these units.)
With fixed ends the first site also counts the contact with the left wall, so
that the densities add up to the Hamiltonian, Eq. hamresc. */
template <class T, class Onsite, class Contact>
T contact_energy(const Chain<Onsite, Contact>& chain, const T* y, std::size_t i) {
  const std::size_t n = chain.sites;
  const T eta = T(chain.eta_of(i));
  if (i > 0 && i < n) return eta * chain.contact.energy(y[i] - y[i - 1]);
  if (chain.ends == Ends::fixed) return eta * chain.contact.energy(i == 0 ? y[0] : -y[n - 1]);
  if (chain.ends == Ends::periodic && i == n) return eta * chain.contact.energy(y[0] - y[n - 1]);
  return T(0);
}

/// Energy density e_n, one entry a site.
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

/// Total energy, Eq. hamresc, summed from the first site to the last.
template <class T, class Onsite, class Contact>
T energy(const Chain<Onsite, Contact>& chain, const State<T>& state) {
  T sum(0);
  for (const T& e : energy_density(chain, state)) sum += e;
  return sum;
}

/// Contact forces f_n of site n on n + 1 (>= 0 without precompression), `sites` entries.
template <class T, class Onsite, class Contact>
std::vector<T> contact_forces(const Chain<Onsite, Contact>& chain, const std::vector<T>& y) {
  std::vector<T> f(chain.sites);
  for (std::size_t n = 0; n < chain.sites; ++n) f[n] = contact_push(chain, y.data(), n + 1);
  return f;
}

/// Linearisation about `y`: the potential energy's second derivatives, a symmetric tridiagonal
/// matrix. `off[n]` couples n and n + 1; its last entry couples the ends of a periodic chain.
template <class T>
struct Hessian {
  std::vector<T> diagonal, off;
};

template <class T, class Onsite, class Contact>
Hessian<T> linearise(const Chain<Onsite, Contact>& chain, const std::vector<T>& y) {
  const std::size_t n = chain.sites;
  const bool wall = chain.ends == Ends::fixed, ring = chain.ends == Ends::periodic;
  Hessian<T> h{std::vector<T>(n), std::vector<T>(n, T(0))};
  for (std::size_t i = 0; i < n; ++i) h.diagonal[i] = chain.onsite.stiffness(y[i]);
  for (std::size_t i = 0; i <= n; ++i) {
    const bool inside = i > 0 && i < n;
    if (!inside && !wall && !(ring && i == n)) continue;
    const T left = i > 0 ? y[i - 1] : T(0), right = i < n ? y[i] : (ring ? y[0] : T(0));
    const T k = T(chain.eta_of(i)) * chain.contact.stiffness(right - left);
    if (i > 0) h.diagonal[i - 1] += k;
    if (i < n || ring) h.diagonal[i % n] += k;
    if (inside || ring) h.off[i - 1] = -k;
  }
  return h;
}

}  // namespace lattice
