#pragma once
#include "lattice/integrators/integrate.hpp"

#include "lattice/model/kernel.hpp"

namespace lattice {

// Where one step ends and the next begins, the last kick and the first become one
template <class T>
Stage<T> stage_at(const Scheme& scheme, double h, std::size_t steps, std::size_t k) {
  const std::size_t last = scheme.kick.size() - 1, i = k == steps * last ? last : k % last;
  const bool merged = i == 0 && k > 0;
  const T kick = T(scheme.kick[i] * h), before = merged ? T(scheme.kick[last] * h) : T(0);
  return {kick + before, T(scheme.drift[i] * h)};
}

// Kick and drift, stage after stage; the work counts the sites inside the moving window
template <class T>
double Splitting::advance(const Chain& chain, State<T>& state, Window& window, double h,
                          std::size_t count) const {
  const auto move = detail::kick_drifter<T>(chain);
  double work = 0;
  for (std::size_t k = 0; k < stage_count(scheme, count); ++k) {
    const Stage<T> stage = stage_at<T>(scheme, h, count, k);
    move(chain, state, window, stage.kick, stage.drift);
    work += double(window.last - window.first);
  }
  return work;
}

}  // namespace lattice

/// The functions of this file in a number type.
#define LATTICE_STEPPING(T)                                                                    \
  template Stage<T> stage_at<T>(const Scheme&, double, std::size_t, std::size_t);              \
  template double Splitting::advance<T>(const Chain&, State<T>&, Window&, double, std::size_t) \
      const;
