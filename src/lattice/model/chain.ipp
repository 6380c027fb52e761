#pragma once
#include "lattice/model/chain.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "lattice/model/kernel.hpp"

namespace lattice {

// Before the wave arrives there is nothing to compute: only the beads between the outermost two
// that have left their rest position are awake
template <class T>
Window waking(const Chain& chain, const State<T>& state) {
  if (chain.ends == Ends::periodic) return {0, chain.sites};
  std::size_t first = 0, last = chain.sites;
  const auto rests = [&](std::size_t n) { return state.y[n] == T(0) && state.v[n] == T(0); };
  while (first < last && rests(first)) ++first;
  while (last > first && rests(last - 1)) --last;
  return {first, last};
}

// Both moves, by a loop made for the chain's own pair of well and contact
template <class T>
detail::Accelerate<T> detail::accelerator(const Chain& chain) {
  return with_pair<T>(chain, []<class W, class C>(const W&, const C&) -> Accelerate<T> {
    return [](const Chain& c, const T* y, T* a, Window& window) {
      sweep_window<W, C>(c, y, a, window, Keep{});
    };
  });
}

template <class T>
detail::KickDrift<T> detail::kick_drifter(const Chain& chain) {
  return with_pair<T>(chain, []<class W, class C>(const W&, const C&) -> KickDrift<T> {
    return [](const Chain& c, State<T>& state, Window& window, const T& kick, const T& drift) {
      sweep_window<W, C>(c, state.y.data(), state.v.data(), window, KickAndDrift<T>{kick, drift});
    };
  });
}

template <class T>
void accelerate(const Chain& chain, const T* y, T* a, Window& window) {
  detail::accelerator<T>(chain)(chain, y, a, window);
}

template <class T>
void kick_drift(const Chain& chain, State<T>& state, Window& window, std::type_identity_t<T> kick,
                std::type_identity_t<T> drift) {
  detail::kick_drifter<T>(chain)(chain, state, window, kick, drift);
}

template <class T>
std::vector<T> accelerations(const Chain& chain, const std::vector<T>& y) {
  assert_fits(chain, y.size());
  std::vector<T> a(chain.sites, T(0));
  Window all{0, chain.sites};
  accelerate(chain, y.data(), a.data(), all);
  return a;
}

// The sites that can have an energy: those that are awake and the one before them, whose contact may be
// stretched. Where a bead or a contact at rest has an energy, these are all sites
template <class T>
static Window energetic(const Chain& chain, const State<T>& state) {
  if (chain.well.energy(T(0)) != T(0) || chain.contact.energy(T(0)) != T(0))
    return {0, chain.sites};
  const Window awake = waking(chain, state);
  return {awake.first > 0 ? awake.first - 1 : 0, awake.last};
}

/// Energies of beads and their wells, and what the contacts to their right add: two loops that the compiler
/// vectorises.
template <class Weights, class T, class W>
LATTICE_WIDE static void sweep_wells(const W well, const T* __restrict__ y, const T* __restrict__ v,
                                     T* __restrict__ e, const Weights weights, std::size_t count) {
  for (std::size_t n = 0; n < count; ++n)
    e[n] = weights.momentum(n, v[n]) * v[n] / T(2) + well.energy(y[n]);
}
template <class Weights, class T, class C>
LATTICE_WIDE static void sweep_contacts(const C contact, const T* __restrict__ y, T* __restrict__ e,
                                        const Weights weights, std::size_t count) {
  for (std::size_t n = 0; n < count; ++n)
    e[n] += weights.contact(n + 1, contact.energy(y[n + 1] - y[n]));
}

// One pass for the wells and one for the contacts, because each pass knows one potential. The sums are formed in one
// order: kinetic energy, well, contact to the right, and for the first site the contact to the left
template <class T>
std::vector<T> energy_density(const Chain& chain, const State<T>& state) {
  for (const auto* row : {&state.y, &state.v}) assert_fits(chain, row->size());
  std::vector<T> e(chain.sites, T(0));
  if (chain.sites == 0) return e;
  const auto [first, last] = energetic(chain, state);
  const std::size_t at = first, wells = last - first;
  const std::size_t contacts = std::max(at, std::min(last, chain.sites - 1)) - at;
  const T *y = state.y.data(), *v = state.v.data();
  detail::with_variation(chain, at, [&](const auto& weights) {
    const auto add_wells = [&](const auto& well) {
      sweep_wells(well, y + at, v + at, e.data() + at, weights, wells);
    };
    const auto add_contacts = [&](const auto& contact) {
      sweep_contacts(contact, y + at, e.data() + at, weights, contacts);
    };
    std::visit(add_wells, chain.well.kind);
    std::visit(add_contacts, chain.contact.kind);
  });
  // The last contact and the first are the boundary's
  if (last == chain.sites) e[last - 1] += contact_energy(chain, y, last);
  e[0] += contact_energy(chain, y, 0);
  return e;
}

// Every contact is counted with one bead only, so the densities add up to the energy
template <class T>
T energy(const Chain& chain, const State<T>& state) {
  T sum(0);
  for (const T& e : energy_density(chain, state)) sum += e;
  return sum;
}

}  // namespace lattice

/// The functions of this file in a number type.
#define LATTICE_CHAIN(T)                                                         \
  template detail::Accelerate<T> detail::accelerator<T>(const Chain&);           \
  template Window waking<T>(const Chain&, const State<T>&);                      \
  template detail::KickDrift<T> detail::kick_drifter<T>(const Chain&);           \
  template void accelerate<T>(const Chain&, const T*, T*, Window&);              \
  template void kick_drift<T>(const Chain&, State<T>&, Window&, T, T);           \
  template std::vector<T> accelerations<T>(const Chain&, const std::vector<T>&); \
  template std::vector<T> energy_density<T>(const Chain&, const State<T>&);      \
  template T energy<T>(const Chain&, const State<T>&);
