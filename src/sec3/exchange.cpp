#include "sec3/exchange.hpp"

#include <algorithm>
#include <cmath>

#include "lattice/model/precisions.hpp"
#include "lattice/numerics/parallel.hpp"
#include "lattice/numerics/progress.hpp"
#include "sec3/resolutions.hpp"

namespace lattice {

// The size of a breather goes like the square of omega_b - 1
Orbit<double> newton_from(const Shooting<double>& problem, const Orbit<double>& from,
                          const NewtonRule<double>& how) {
  const double growth = (problem.omega - 1) / (from.omega - 1);
  return newton(problem, Vector<double>(growth * growth * from.x), how);
}

// At two tolerances
template <class T>
Spectrum spectrum(const Shooting<double>& problem, const Orbit<double>& orbit) {
  return spectrum<T>(in_precision<T>(problem), orbit, 0);
}

template <class T>
Spectrum spectrum(const Shooting<T>& in_t, const Orbit<double>& orbit, double rank) {
  Progress progress("tolerances", 2);
  const auto pairs = [&](Resolution resolution) {
    Orbit<double> guess = orbit;
    // Slightly off the orbit, so that the coarser run has to find it for itself
    if (resolution == Resolution::coarse) guess.x *= 1.000001;
    auto how = rule<T>(resolution);
    how.rank = rank, how.scale = rank > 0 ? 1 : 0;
    const Orbit<T> found = newton(in_t, guess, how);
    return floquet_pairs<T>(in_t.chain, found.start, found.period(), how.events);
  };
  const MultiplierPairs<T> fine = pairs(Resolution::fine);
  progress.tick();
  return {pairs_with_errors(pairs(Resolution::coarse), fine), fine.mode.template cast<double>()};
}

// A bead at rest turns with frequency one, which is its multiplier
int at_edge(const std::vector<MultiplierPair>& pairs, double omega_b) {
  const double sine = std::sin(pi<double>() / omega_b), edge = -sine * sine;
  return 2 * int(std::count_if(pairs.begin() + 1, pairs.end(), [&](const MultiplierPair& pair) {
           return std::abs(pair.kappa - edge) < 1e-4;
         }));
}

Orbit<double> lengthened(const Shooting<double>& longer, const Orbit<double>& orbit) {
  return newton(longer, longer.reduce(resized(orbit.start, longer.chain.sites)));
}

Estimate distance_from_one(const MultiplierPair& pair) {
  return {std::abs(multiplier(pair.kappa, 1) - 1.0), pair.multiplier_error()};
}

double quick_kappa(Centre centre, const PlanePoint& spot, Orbit<double>& orbit,
                   const NewtonRule<double>& how) {
  const auto problem = problem_at(centre, spot);
  orbit = newton_from(problem, orbit, how);
  return floquet_pairs(problem.chain, orbit.start, orbit.period(), how.events).pinning();
}

// Regula falsi for the sign change of kappa, each orbit followed from the one before
Exchange exchange_between(Centre centre, const Cut& cut, TrialKappa low, TrialKappa high,
                          Orbit<double> orbit, double close, const NewtonRule<double>& how) {
  TrialKappa last = low;
  double slope = (high.kappa - low.kappa) / (high.p - low.p), step = std::abs(high.p - low.p);
  for (int k = 0, stays = 0; k < 30 && step > close; ++k) {
    const double p = low.p - low.kappa * (high.p - low.p) / (high.kappa - low.kappa);
    const TrialKappa now{p, quick_kappa(centre, cut.at(p), orbit, how)};
    // Two trials give a slope only if they are far enough apart to rise above rounding
    if (std::abs(now.p - last.p) > 1e-4) slope = (now.kappa - last.kappa) / (now.p - last.p);
    const int side = (now.kappa > 0) == (high.kappa > 0) ? 1 : -1;
    (side > 0 ? high : low) = last = now;
    // An end that stays counts half the next time, so that the bracket closes from both sides
    if (stays == side) (side > 0 ? low : high).kappa /= 2;
    stays = side;
    step = std::abs(now.kappa / slope);
  }
  return {{last.p - last.kappa / slope, step}, slope, orbit};
}

// A step in double precision, then two in extended precision; the second one has its own slope, and is the error
template <class T>
Exchange refined_zero(Centre centre, const Cut& cut, Exchange found) {
  double& place = found.place.value;
  place -= quick_kappa(centre, cut.at(place), found.orbit) / found.slope;
  const auto kappa_here = [&] {
    const auto problem = problem_at(centre, cut.at(place));
    found.orbit = newton_from(problem, found.orbit);
    return spectrum<T>(problem, found.orbit).kappa();
  };
  const Estimate first = kappa_here();
  const double step = first.value / found.slope, from = place;
  place -= step;
  const Estimate last = kappa_here();
  if (std::abs(first.value - last.value) > 10 * (first.error + last.error))
    found.slope = (last.value - first.value) / (place - from);
  const double correction = last.value / found.slope;
  place -= correction;
  found.place.error = last.error / std::abs(found.slope) + std::abs(correction) + 1e-15;
  return found;
}

template <class T>
Exchange exchange(Centre centre, const Cut& cut, double low, double high, Orbit<double> orbit) {
  const TrialKappa below{low, quick_kappa(centre, cut.at(low), orbit)};
  const TrialKappa above{high, quick_kappa(centre, cut.at(high), orbit)};
  if (below.kappa * above.kappa >= 0)
    throw NoBranch("no exchange of stability between the two values");
  return refined_zero<T>(centre, cut, exchange_between(centre, cut, below, above, orbit, 1e-5));
}

#define LIST(T)                                                                    \
  template Spectrum spectrum<T>(const Shooting<double>&, const Orbit<double>&);    \
  template Spectrum spectrum<T>(const Shooting<T>&, const Orbit<double>&, double); \
  template Exchange refined_zero<T>(Centre, const Cut&, Exchange);                 \
  template Exchange exchange<T>(Centre, const Cut&, double, double, Orbit<double>);
LATTICE_IN_EACH_PRECISION(LIST)
#undef LIST

}  // namespace lattice
