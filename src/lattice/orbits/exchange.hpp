#pragma once
/**
# Where two breathers exchange their stability

Section 3.3 of the article reports that a breather changes its stability at certain values of the
anharmonicity $s$. The pair of Floquet multipliers $\lambda$, $1/\lambda$ that decides this, the pinning
pair, is described by $\kappa = (\lambda+1/\lambda-2)/4$ (floquet.hpp), which is positive if the breather
is unstable and negative if it is stable. On a cut through the plane of $\omega_b$ and $s$ the sign changes
at a point. This file finds it: by regula falsi in double precision, and a last step in a wider type. */

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "lattice/numbers/criterion.hpp"
#include "lattice/numbers/estimate.hpp"
#include "lattice/orbits/breather.hpp"
#include "lattice/orbits/floquet.hpp"
#include "lattice/orbits/ladder.hpp"

namespace lattice {

/**
A chain is long enough if the bead missing at its end would be pushed by less than rounding
(`sites_needed`): up to $\omega_b = 2$ this means 21 sites, or 22 around a bond. `more` adds to them, as
a check. */
struct Spot {
  double omega = 1.1, s = 0;
};
inline BreatherProblem<double> problem_at(Centre centre, const Spot& spot, std::size_t more = 0) {
  return breather_problem(centre, spot.omega, spot.s, (centre == Centre::site ? 21 : 22) + more);
}

/// The breather of a problem near that of another. The guess scales positions with the square of
/// omega_b - 1, as in Eq. (20). Throws NoConvergence.
inline Orbit<double> follow(const BreatherProblem<double>& problem, const Orbit<double>& from,
                            const NewtonRule<double>& how = {}) {
  const double growth = (problem.omega - 1) / (from.omega - 1);
  return newton(problem, Vector<double>(growth * growth * from.x), how);
}

/**
No zero of $\kappa$ without its error: each spectrum comes from two computations whose tolerances differ by
a factor of 16, and the coarser one has to find the orbit again from a point beside it. */
struct Spectrum {
  std::vector<Pair> pairs;
  Vector<double> mode;  ///< of the pinning pair, positions at t = 0
  Estimate kappa() const { return {pairs.front().kappa.real(), pairs.front().error}; }
};

/// The pairs at the orbit of a problem, in type T, with their errors. Throws NoConvergence.
template <class T, class Onsite>
Spectrum spectrum(const BreatherProblem<double, Onsite>& problem, const Orbit<double>& orbit) {
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
The article says that four multipliers lie near $+1$, the others on the unit circle, and that these
accumulate at $e^{\pm2\pi i/\omega_b}$. The phase pair makes two of the four; a `Quadruplet` records how far
from $+1$ the others come and how many multipliers sit at the point of accumulation. */
struct Quadruplet {
  double fourth = 0, fifth = 0;  ///< distance from +1 of the fourth and the fifth multiplier
  bool others_stable = true;     ///< no pair but the first leaves the circle by more than its error
  int at_edge = 0;               ///< multipliers at the accumulation, within 1e-9 in kappa
};

/// The quadruplet of a spectrum at the frequency `omega`.
inline Quadruplet quadruplet(const Spectrum& all, double omega) {
  Quadruplet q{std::abs(multiplier(all.pairs[0].kappa, 1) - 1.0),
               std::abs(multiplier(all.pairs[1].kappa, 1) - 1.0)};
  const double edge = -std::pow(std::sin(circle_ratio<double>() / omega), 2);
  for (std::size_t k = 1; k < all.pairs.size(); ++k) {
    q.others_stable = q.others_stable && !all.pairs[k].is_unstable();
    q.at_edge += std::abs(all.pairs[k].kappa - edge) < 1e-9 ? 2 : 0;
  }
  return q;
}

/**
A fifth multiplier near one fails the statement, and so does a pair off the circle or an accumulation
elsewhere: ten more sites must add their twenty multipliers at the edge. Near one means within 0.01, and the
fifth must be farther away than 0.1; these bounds are ours. An instability is small if the multiplier
exceeds one by less than $10^{-3}$, and two breathers are told apart by the signs of their $\kappa$. */
/// From a chain and one that is ten sites longer.
inline Criterion four_near_one(const Quadruplet& chain, const Quadruplet& longer) {
  const bool stable = chain.others_stable && longer.others_stable;
  const int added = longer.at_edge - chain.at_edge;
  return {below("fourth", compare(longer.fourth, chain.fourth), 0.01),
          above("fifth", compare(longer.fifth, chain.fifth), 0.1),
          above("others_stable", exact(stable), 0.5),
          below("not_at_edge", exact(std::abs(20 - added)), 0.5)};
}

/// From the largest excess of a multiplier over one.
inline Criterion small_instability(const Estimate& excess) {
  return {below("largest", excess, 1e-3)};
}

/// From the kappa of both breathers: the one around a site unstable, that around a bond stable.
inline Criterion bond_alone_stable(const Estimate& site, const Estimate& bond) {
  return {above("site", site, 0), below("bond", bond, 0)};
}

/**
## A zero of $\kappa$

A cut runs along $s$ at fixed $\omega_b$, or along $\omega_b$ at fixed $s$. */
struct Cut {
  bool along_s = true;
  double fixed = 1.1;
  Spot at(double p) const { return along_s ? Spot{fixed, p} : Spot{p, fixed}; }
};

/// A zero of kappa on a cut, the slope of kappa there, and the breather.
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
one trial to the next. An end of the bracket that stays has its value halved, so that it cannot stay for
ever. The slope is that between the last two trials that are at least $10^{-4}$ apart; closer ones would
show rounding. */
struct Trial_kappa {
  double p, kappa;
};

/// The zero between two ends where kappa has opposite signs. The search ends when a step is shorter than
/// `close`; the error is the last step.
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
rounding allows. The error of the zero is that of $\kappa$ over the slope, plus a hundredth of the step,
because the slope is known no better than that. */
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

/// The exchange of stability between `low` and `high` on a cut, from an orbit nearby. Throws NoBranch if
/// kappa has the same sign at both ends, NoConvergence if an orbit is not found.
template <class T>
Exchange exchange(Centre centre, const Cut& cut, double low, double high, Orbit<double> orbit) {
  const Trial_kappa below{low, quick_kappa(centre, cut.at(low), orbit)};
  const Trial_kappa above{high, quick_kappa(centre, cut.at(high), orbit)};
  if (below.kappa * above.kappa >= 0)
    throw NoBranch("no exchange of stability between the two values");
  return polish_zero<T>(centre, cut, exchange_between(centre, cut, below, above, orbit, 1e-5));
}

}  // namespace lattice
