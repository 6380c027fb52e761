#pragma once
/**
# Where two breathers exchange their stability

The pinning pair of a breather is described by $\kappa = (\lambda+1/\lambda-2)/4$ (floquet.hpp), which
changes its sign where the breather becomes stable. On a cut through the plane of $\omega_b$ and $s$ this
happens at a point, and this file finds it: by the regula falsi in double precision, and by two secant
steps in a wider type. */

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "lattice/numbers/estimate.hpp"
#include "lattice/orbits/breather.hpp"
#include "lattice/orbits/floquet.hpp"
#include "lattice/orbits/ladder.hpp"

namespace lattice {

/**
Chains are long enough when the missing bead would be pushed less than rounding: 21 or 22 sites up to
$\omega_b = 2$. */
struct Spot {
  double omega = 1.1, s = 0;
};
inline BreatherProblem<double> problem_at(Centre centre, const Spot& spot, std::size_t more = 0) {
  return breather_problem(centre, spot.omega, spot.s, (centre == Centre::site ? 21 : 22) + more);
}

/// The breather of a problem near that of another; positions grow with the square of omega_b - 1.
inline Orbit<double> follow(const BreatherProblem<double>& problem, const Orbit<double>& from) {
  const double growth = (problem.omega - 1) / (from.omega - 1);
  return newton(problem, Vector<double>(growth * growth * from.x));
}

/**
Each number comes from two computations whose tolerances differ by a factor of 16; the coarser one has
to find the orbit again from a point beside it. */
struct Spectrum {
  std::vector<Pair> pairs;
  Vector<double> mode;  ///< of the pinning pair, positions at t = 0
  Estimate kappa() const { return {pairs.front().kappa.real(), pairs.front().error}; }
};

template <class T>
Spectrum spectrum(const BreatherProblem<double>& problem, const Orbit<double>& orbit) {
  const auto in_t = in_precision<T>(problem);
  const auto pairs = [&](int coarser) {
    Orbit<double> guess = orbit;
    if (coarser) guess.x *= 1.000001;
    const auto how = rule<T>(coarser);
    const Orbit<T> there = polish(in_t, guess, how);
    return floquet_pairs(in_t.chain, there.start, there.period(), how.landing);
  };
  const Pairs<T> fine = pairs(0);
  return {compare_pairs(pairs(1), fine), fine.mode.template cast<double>()};
}

/**
## A zero of $\kappa$

A cut runs along $s$ or along $\omega_b$. The error of the zero is that of $\kappa$ over the slope. */
struct Cut {
  bool along_s = true;
  double fixed = 1.1;
  Spot at(double p) const { return along_s ? Spot{fixed, p} : Spot{p, fixed}; }
};

struct Exchange {
  Estimate place{};
  double slope = 0;
  Orbit<double> orbit{};
};

template <class T>
Exchange polish_zero(Centre centre, const Cut& cut, Exchange found) {
  for (int k = 0; k < 2; ++k) {
    const auto problem = problem_at(centre, cut.at(found.place.value));
    found.orbit = follow(problem, found.orbit);
    const Estimate kappa = spectrum<T>(problem, found.orbit).kappa();
    const double step = kappa.value / found.slope;
    found.place = {found.place.value - step,
                   kappa.error / std::abs(found.slope) + std::abs(step) * (k ? 1e-3 : 1.0) + 1e-15};
  }
  return found;
}

/**
The bracket comes with an orbit nearby. The value at an end that stays is halved, so that it cannot stay
for ever. */
/// In double precision and without an error; `orbit` is replaced by the one at `spot`.
inline double quick_kappa(Centre centre, const Spot& spot, Orbit<double>& orbit) {
  const auto problem = problem_at(centre, spot);
  orbit = follow(problem, orbit);
  return floquet_pairs(problem.chain, orbit.start, orbit.period()).pinning();
}

/**
Newton's method follows the orbit from one trial to the next. */
/// The exchange between `low` and `high`, from an orbit nearby. Throws NoBranch where kappa has the same
/// sign at both ends.
template <class T>
Exchange exchange(Centre centre, const Cut& cut, double low, double high, Orbit<double> orbit) {
  double below = quick_kappa(centre, cut.at(low), orbit);
  double above = quick_kappa(centre, cut.at(high), orbit), slope = 0, p = low;
  if (below * above >= 0) throw NoBranch("no exchange of stability between the two values");
  for (int k = 0, stays = 0; k < 30; ++k) {
    slope = (above - below) / (high - low);
    p = low - below / slope;
    const double value = quick_kappa(centre, cut.at(p), orbit);
    if (std::abs(value) < 1e-14 || high - low < 1e-10) break;
    const int side = (value > 0) == (above > 0) ? 1 : -1;
    if (side > 0)
      high = p, above = value, below /= stays == side ? 2 : 1;
    else
      low = p, below = value, above /= stays == side ? 2 : 1;
    stays = side;
  }
  return polish_zero<T>(centre, cut, {{p, high - low}, slope, orbit});
}

}  // namespace lattice
