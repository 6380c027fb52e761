#pragma once
/**
# Where two breathers exchange their stability

The pinning pair of a breather is described by $\kappa = (\lambda+1/\lambda-2)/4$ (floquet.hpp), which
changes its sign where the breather becomes stable. On a cut through the plane of $\omega_b$ and $s$ this
happens at a point, and this file finds it: by the regula falsi in double precision, and by a last step
in a wider type. */

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
inline Orbit<double> follow(const BreatherProblem<double>& problem, const Orbit<double>& from,
                            const NewtonRule<double>& how = {}) {
  const double growth = (problem.omega - 1) / (from.omega - 1);
  return newton(problem, Vector<double>(growth * growth * from.x), how);
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

/// kappa in double precision and without an error; `orbit` is replaced by the one at `spot`.
inline double quick_kappa(Centre centre, const Spot& spot, Orbit<double>& orbit,
                          const NewtonRule<double>& how = {}) {
  const auto problem = problem_at(centre, spot);
  orbit = follow(problem, orbit, how);
  return floquet_pairs(problem.chain, orbit.start, orbit.period(), how.landing).pinning();
}

/**
The search needs $\kappa$ at both ends of a bracket and an orbit nearby, which Newton's method follows from
one trial to the next. The value at an end that stays is halved, so that it cannot stay for ever; the slope is
that between the last two trials which are far enough apart to show it. */
struct Trial_kappa {
  double p, kappa;
};

/// The zero between two ends of opposite sign, until a step is shorter than `close`; its error is the
/// last step.
inline Exchange exchange_between(Centre centre, const Cut& cut, Trial_kappa low, Trial_kappa high,
                                 Orbit<double> orbit, double close,
                                 const NewtonRule<double>& how = {}) {
  Trial_kappa last = low;
  double slope = (high.kappa - low.kappa) / (high.p - low.p), step = high.p - low.p;
  for (int k = 0, stays = 0; k < 30 && step > close; ++k) {
    const double p = low.p - low.kappa * (high.p - low.p) / (high.kappa - low.kappa);
    const Trial_kappa now{p, quick_kappa(centre, cut.at(p), orbit, how)};
    if (std::abs(now.p - last.p) > 1e-4) slope = (now.kappa - last.kappa) / (now.p - last.p);
    const int side = (now.kappa > 0) == (high.kappa > 0) ? 1 : -1;
    (side > 0 ? high : low) = last = now;
    if (stays == side) (side > 0 ? low : high).kappa /= 2;
    stays = side;
    step = std::abs(now.kappa / slope);
  }
  return {{last.p - last.kappa / slope, step}, slope, orbit};
}

/**
The last step is made with the wider type, from a point that double precision has brought as close as its
rounding allows. The slope is known to a hundredth. */
template <class T>
Exchange polish_zero(Centre centre, const Cut& cut, Exchange found) {
  found.place.value -= quick_kappa(centre, cut.at(found.place.value), found.orbit) / found.slope;
  const auto problem = problem_at(centre, cut.at(found.place.value));
  found.orbit = follow(problem, found.orbit);
  const Estimate kappa = spectrum<T>(problem, found.orbit).kappa();
  const double step = kappa.value / found.slope;
  found.place = {found.place.value - step,
                 kappa.error / std::abs(found.slope) + std::abs(step) * 1e-2 + 1e-15};
  return found;
}

/// The exchange between `low` and `high`, from an orbit nearby. Throws NoBranch where kappa has the same
/// sign at both ends.
template <class T>
Exchange exchange(Centre centre, const Cut& cut, double low, double high, Orbit<double> orbit) {
  const Trial_kappa below{low, quick_kappa(centre, cut.at(low), orbit)};
  const Trial_kappa above{high, quick_kappa(centre, cut.at(high), orbit)};
  if (below.kappa * above.kappa >= 0)
    throw NoBranch("no exchange of stability between the two values");
  return polish_zero<T>(centre, cut, exchange_between(centre, cut, below, above, orbit, 1e-5));
}

}  // namespace lattice
