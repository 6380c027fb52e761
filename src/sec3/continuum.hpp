#pragma once
/**
# How good the quasi-continuum profile is

Beside the stationary DpS breather, the limit of a small breather of the chain. */

#include <cmath>
#include <cstddef>

#include "lattice/standing/stationary.hpp"

namespace lattice {

/// Largest displacement.
template <class T>
T largest(const Stationary<T>& state) {
  using std::abs;
  T top(0);
  for (const T& x : state.u)
    if (abs(x) > top) top = abs(x);
  return top;
}

/// Largest difference from the quasi-continuum profile, relative to the largest displacement.
template <class T>
T continuum_difference(const Stationary<T>& state) {
  using std::abs;
  T apart(0);
  for (std::size_t i = 0; i < state.u.size(); ++i) {
    const T near = quasi_continuum<T>(state.centre, site_number(i, state.u.size()));
    const T difference = abs(state.u[i] - near);
    if (difference > apart) apart = difference;
  }
  return apart / largest(state);
}

}  // namespace lattice
