#pragma once
/**
# Compensated stepping

A splitting is symplectic only as far as its sums are exact. Every stage adds a small kick
to a large velocity and a small drift to a large position and rounds both, so that after
$n$ stages the state has wandered by some $\sqrt n$ units in its last place, and so has
the energy. In runs of $10^6$ steps and more, with steps short enough for the scheme, this
is the larger of the two errors, and shorter steps make it worse.

What a sum of two numbers loses is itself a number, and two additions and three or four
differences give it exactly, whichever of the two is larger (Knuth's two-sum). We keep it
and add it to the next term. These operations would vanish if the compiler were allowed to
treat sums as exact; it is not. A step takes twice the time of a plain one. */

#include <cstddef>
#include <type_traits>
#include <vector>

#include "lattice/stepping/integrate.hpp"

#ifdef __FAST_MATH__
#error "compensated sums need exact rounding: build without -ffast-math"
#endif

namespace lattice {

/// `sum += term`, where `low` is what earlier additions have lost.
template <class T>
inline __attribute__((always_inline)) void add_exactly(T& sum, T& low, T term) {
  const T more = term + low, total = sum + more, added = total - sum;
  low = (sum - (total - added)) + (more - added);
  sum = total;
}

/// The second pass of `sweep_kick_drift` with its two sums compensated.
template <bool varied, class T, class Onsite, class Contact>
LATTICE_WIDE void sweep_compensated(const Onsite onsite, const Contact contact, T* __restrict__ y,
                                    T* __restrict__ v, T* __restrict__ low_y, T* __restrict__ low_v,
                                    Variation<T> along, std::size_t n, T left, T right, T kick,
                                    T drift) {
  T push[kernel_block + 1];
  for (std::size_t lo = 0; lo < n; lo += kernel_block) {
    const std::size_t hi = lo + kernel_block < n ? lo + kernel_block : n;
    block_contacts<varied>(contact, y, along, lo, hi, n, left, right, push);
    left = push[hi - lo];
    for (std::size_t i = lo; i < hi; ++i) {
      T a = onsite.force(y[i]) + (push[i - lo] - push[i - lo + 1]);
      if constexpr (varied) a *= along.inverse_mass[i];
      add_exactly(v[i], low_v[i], kick * a);
      add_exactly(y[i], low_y[i], drift * v[i]);
    }
  }
}

/**
The stepper keeps the low parts during a call of `advance`. Between two calls they are
dropped: a run then rounds once a sample instead of twice a stage. */
struct Compensated {
  Scheme scheme;
  double step;

  /// Advances `state` by `count` steps of length `h`; returns the number of site-force evaluations.
  template <class T, class Onsite, class Contact>
  double advance(const Chain<Onsite, Contact>& chain, State<T>& state, Window& window, double h,
                 std::size_t count) const {
    std::vector<T> low_y(chain.sites, T(0)), low_v = low_y;
    double work = 0;
    for (std::size_t k = 0; k < stage_count(scheme, count); ++k) {
      const Stage<T> stage = stage_at<T>(scheme, h, count, k);
      with_edges(chain, state.y.data(), window, [&](T left, T right) {
        const std::size_t at = window.first, sites = window.last - at;
        T *y = state.y.data() + at, *v = state.v.data() + at;
        T *ly = low_y.data() + at, *lv = low_v.data() + at;
        if (!chain.varied())
          sweep_compensated<false, T>(chain.onsite, chain.contact, y, v, ly, lv, {}, sites, left,
                                      right, stage.kick, stage.drift);
        else if constexpr (std::is_same_v<T, double>)
          sweep_compensated<true, T>(chain.onsite, chain.contact, y, v, ly, lv,
                                     variation_from<T>(chain, at), sites, left, right, stage.kick,
                                     stage.drift);
      });
      work += double(window.last - window.first);
    }
    return work;
  }
};

}  // namespace lattice
