#pragma once
/**
# Localized starts in a chain without wells, and how near they come to them again

A periodic motion returns to its start. With $d(t)$ the largest change of a displacement or velocity since then, the
least value of $d(t)/\max_{t'\le t}d(t')$ is one for a motion that only goes away and zero for a periodic one. Every
motion is close to its start at first, so it counts once $d$ has exceeded a thousandth. */

#include <cstddef>
#include <string>

#include "lattice/model/chain.hpp"

namespace lattice {

/// A start in the middle of a chain: a bead `displaced` or `kicked` by one, a `pair` of neighbours pushed together, the
/// `breather`, or displacements that rise in 20 random steps, all up (`increasing`) or one down (`step_down`).
State<double> localized(const std::string& name, const State<double>& breather, std::size_t sites);

/// The largest distance d, and the least ratio if there is one.
struct Return {
  double away = 0, back = 1;
  bool moved = false;
};

/// That of a run, seen after each time `every`. Throws like `assert_isolated`.
Return closest_return(const Chain& chain, const State<double>& start, double step, double every,
                      double time);

/// Throws std::runtime_error if the ends of a chain have moved, or unless the relative change of its energy is small.
void assert_isolated(const State<double>& end, double energy_drift);

}  // namespace lattice
