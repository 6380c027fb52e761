#pragma once
/**
# Compensated stepping

A splitting (schemes.hpp) is symplectic only as far as its sums are exact. Every stage adds a small kick
to a large velocity and a small drift to a large position and rounds both, so that after $n$ stages the
state has wandered by some $\sqrt n$ units in its last place, and so has the energy. In runs of $10^6$
steps or more, with steps short enough for the scheme, rounding is the larger of the two errors, and
shorter steps make it worse.

What the sum of two numbers loses to rounding is itself a floating-point number, and a few more additions
and differences give it exactly, whichever of the two is larger (Knuth's two-sum). We keep it and add it
to the next term. A compiler that was allowed to treat sums as exact would remove these operations; ours
is not. A step takes twice the time of a plain one. */

#include <cstddef>

#include "lattice/integrators/integrate.hpp"

#ifdef __FAST_MATH__
#error "compensated sums need exact rounding: build without -ffast-math"
#endif

namespace lattice {

/// `sum += term`, where `low` holds what earlier additions have lost and is brought up to date.
template <class T>
inline __attribute__((always_inline)) void add_exactly(T& sum, T& low, T term) {
  const T more = term + low, total = sum + more, added = total - sum;
  low = (sum - (total - added)) + (more - added);
  sum = total;
}

/**
The stepper is a splitting with such sums. It keeps the lost parts during a call of `advance` and drops
them between two calls: a run then rounds once per sample instead of twice per stage. */
struct Compensated {
  Scheme scheme;
  double step;  ///< the largest that it may take

  /// Advances `state` by `count` steps of length `h`; returns the number of site-force evaluations.
  double advance(const Chain& chain, State<double>& state, Window& window, double h,
                 std::size_t count) const;
};

}  // namespace lattice
