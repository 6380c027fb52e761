#pragma once
/**
# Where two breathers exchange their stability

At certain anharmonicities $s$ a breather changes its stability: the pinning pair of Floquet multipliers passes $+1$,
and its $\kappa$ (floquet.hpp) changes its sign. On a cut through the plane of $\omega_b$ and $s$ this happens at a
point. This file finds it: by regula falsi in double precision, and a last step in extended precision. */

#include <cstddef>
#include <string>
#include <vector>

#include "lattice/numerics/estimate.hpp"
#include "lattice/orbits/breather.hpp"
#include "lattice/orbits/floquet.hpp"
#include "sec3/article_chains.hpp"

namespace lattice {

/// A place in the plane, and how many sites more than necessary: up to omega_b = 2 a bead missing at the ends of 21
/// sites, or 22 around a bond, would be pushed by less than rounding.
struct PlanePoint {
  double omega_b, s;
  std::size_t more = 0;
};
/// The problem of a breather in quartic wells at that place of the plane.
inline Shooting<double> problem_at(Centre centre, const PlanePoint& spot) {
  return breather_problem(centre, spot.omega_b, spot.s,
                          sites_of(centre, Length::shortest) + spot.more);
}

/// The breather of a problem near that of another. The guess scales positions with the square of
/// omega_b - 1, as in Eq. (20). Throws NewtonFailed.
Orbit<double> newton_from(const Shooting<double>& problem, const Orbit<double>& from,
                          const NewtonRule<double>& how = {});

/// The pairs of a breather from two computations: their tolerances differ by a factor of 16, and the coarser one has to
/// find the orbit again from a point beside it.
struct Spectrum {
  std::vector<MultiplierPair> pairs;
  Vector<double> mode;  ///< of the pinning pair, positions at t = 0
  /// That of the pinning pair.
  Estimate kappa() const { return {pairs.front().kappa.real(), pairs.front().error}; }
  /// Of all multipliers.
  Estimate largest_modulus() const {
    const Estimate beyond = excess(pairs);
    return {1 + beyond.value, beyond.error};
  }
};

/// The pairs at the orbit of a problem, in type T, with their errors. Throws NewtonFailed.
template <class T>
Spectrum spectrum(const Shooting<double>& problem, const Orbit<double>& orbit);
/// The same for a problem in type T; `rank` is that of Newton's rule.
template <class T>
Spectrum spectrum(const Shooting<T>& problem, const Orbit<double>& orbit, double rank);

/// How many multipliers but the first two lie within 1e-4 in kappa of their accumulation, exp(+-2 pi i / omega_b).
int at_edge(const std::vector<MultiplierPair>& pairs, double omega_b);

/// The breather of a longer chain near that of a shorter one, with beads at rest beyond the old ends. Throws NewtonFailed.
Orbit<double> lengthened(const Shooting<double>& longer, const Orbit<double>& orbit);

/// How far the multipliers of a pair are from +1.
Estimate distance_from_one(const MultiplierPair& pair);

/// A cut runs along s at fixed omega_b, or along omega_b at fixed s.
struct Cut {
  bool along_s;          ///< or along omega_b
  double fixed;          ///< the other one of the two
  std::size_t more = 0;  ///< sites
  /// The place on the cut with this parameter.
  PlanePoint at(double p) const {
    return along_s ? PlanePoint{fixed, p, more} : PlanePoint{p, fixed, more};
  }
};

/// A zero of kappa on a cut, the slope of kappa there, and the breather.
struct Exchange {
  Estimate place{};
  double slope = 0;
  Orbit<double> orbit{};
};

/// kappa in double precision and without an error; `orbit` is replaced by the one at `spot`.
double quick_kappa(Centre centre, const PlanePoint& spot, Orbit<double>& orbit,
                   const NewtonRule<double>& how = {});

/// The parameter of a cut, and kappa there.
struct TrialKappa {
  double p, kappa;
};

/// The zero between two ends where kappa has opposite signs, from an orbit nearby. The search ends when a step is shorter
/// than `close`; the error is the last step.
Exchange exchange_between(Centre centre, const Cut& cut, TrialKappa low, TrialKappa high,
                          Orbit<double> orbit, double close, const NewtonRule<double>& how = {});

/// The zero after a last step with extended precision. Its error is that of kappa over the slope, plus the last
/// correction. Throws NewtonFailed.
template <class T>
Exchange refined_zero(Centre centre, const Cut& cut, Exchange found);

/// The exchange of stability between `low` and `high` on a cut, from an orbit nearby. Throws NoBranch if
/// kappa has the same sign at both ends, NewtonFailed if an orbit is not found.
template <class T>
Exchange exchange(Centre centre, const Cut& cut, double low, double high, Orbit<double> orbit);

}  // namespace lattice
