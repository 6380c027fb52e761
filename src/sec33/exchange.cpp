#include "sec33/exchange.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "lattice/numerics/parallel.hpp"
#include "lattice/numerics/progress.hpp"

namespace lattice {

Orbit<double> follow(const Shooting<double>& problem, const Orbit<double>& from,
                     const NewtonRule<double>& how) {
  const double growth = (problem.omega - 1) / (from.omega - 1);
  return newton(problem, Vector<double>(growth * growth * from.x), how);
}

template <class T>
Spectrum spectrum(const Shooting<double>& problem, const Orbit<double>& orbit) {
  const auto in_t = in_precision<T>(problem);
  Progress progress("tolerances", 2);
  const auto pairs = [&](int coarser) {
    Orbit<double> guess = orbit;
    // Slightly off the orbit, so that the coarser run has to find it for itself
    if (coarser) guess.x *= 1.000001;
    const auto how = rule<T>(coarser);
    const Orbit<T> there = newton(in_t, guess, how);
    return floquet_pairs(in_t.chain, there.start, there.period(), how.events);
  };
  const Pairs<T> fine = pairs(0);
  progress.tick();
  return {compare_pairs(pairs(1), fine), fine.mode.template cast<double>()};
}

// A bead at rest turns with frequency one, which is its multiplier
int at_edge(const std::vector<Pair>& pairs, double omega_b, double close) {
  const double edge = -std::pow(std::sin(pi<double>() / omega_b), 2);
  return 2 * int(std::count_if(pairs.begin() + 1, pairs.end(), [&](const Pair& pair) {
           return std::abs(pair.kappa - edge) < close;
         }));
}

// The same breather on a longer chain, with beads at rest beyond the old ends
static Orbit<double> lengthened(const Shooting<double>& longer, const Orbit<double>& orbit,
                                const NewtonRule<double>& how = {}) {
  const std::size_t more = longer.chain.sites - orbit.start.y.size();
  State<double> start(longer.chain.sites);
  std::copy(orbit.start.y.begin(), orbit.start.y.end(), start.y.begin() + long(more / 2));
  return newton(longer, longer.reduce(start), how);
}

int added_at_edge(Centre centre, const Spot& spot, const Orbit<double>& orbit,
                  const std::vector<Pair>& pairs, const NewtonRule<double>& how) {
  const auto longer = problem_at(centre, spot, 10);
  const Orbit<double> there = lengthened(longer, orbit, how);
  const auto found = floquet_pairs(longer.chain, there.start, there.period(), how.events);
  std::vector<Pair> more;
  for (const auto& kappa : found.kappa) more.push_back({kappa, found.defect});
  const double close = 1e-4;
  return at_edge(more, spot.omega_b, close) - at_edge(pairs, spot.omega_b, close);
}

Quadruplet quadruplet(const Spectrum& all, double omega_b) {
  Quadruplet q{from_one(all.pairs[0]).value, from_one(all.pairs[1]).value};
  for (std::size_t k = 1; k < all.pairs.size(); ++k) q.off_circle += all.pairs[k].is_unstable();
  q.at_edge = at_edge(all.pairs, omega_b);
  return q;
}

Estimate from_one(const Pair& pair) {
  return {std::abs(multiplier(pair.kappa, 1) - 1.0), pair.multiplier_error()};
}

double quick_kappa(Centre centre, const Spot& spot, Orbit<double>& orbit,
                   const NewtonRule<double>& how) {
  const auto problem = problem_at(centre, spot);
  orbit = follow(problem, orbit, how);
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

// A step in double precision, then two in extended precision, where rounding no longer matters; the second one has the
// slope between its two points, and is the error
template <class T>
Exchange refined_zero(Centre centre, const Cut& cut, Exchange found) {
  double& place = found.place.value;
  place -= quick_kappa(centre, cut.at(place), found.orbit) / found.slope;
  const auto kappa_here = [&] {
    const auto problem = problem_at(centre, cut.at(place));
    found.orbit = follow(problem, found.orbit);
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

namespace {

// A well that was looked at
struct Look {
  double s, kappa;
  Orbit<double> orbit;
};

// Where the parabola through three looks is flat, between the outer two
double flat_between(const Look& a, const Look& b, const Look& c) {
  const double left = b.s - a.s, right = c.s - b.s;
  const double up = (c.kappa - b.kappa) / right, down = (b.kappa - a.kappa) / left;
  const double bend = (up - down) / (left + right);
  return bend == 0
             ? b.s
             : std::clamp(b.s - (up * left + down * right) / (left + right) / (2 * bend), a.s, c.s);
}

}  // namespace

// Where the cubic through the looks around an interval does not tell what is in its middle, it is halved
template <class Find>
static void look_closer(std::vector<Look>& all, Find look) {
  for (std::size_t k = 0; k + 1 < all.size();) {
    const double low = all[k].s, high = all[k + 1].s, s = (low + high) / 2;
    if (std::abs(high - low) < 2e-4) {
      ++k;
      continue;
    }
    double told = 0;
    const std::size_t end = std::min(k + 3, all.size()),
                      begin = std::min(k ? k - 1 : 0, end - std::min<std::size_t>(4, end));
    for (std::size_t i = begin; i < end; ++i) {
      double weight = 1;
      for (std::size_t j = begin; j < end; ++j)
        if (j != i) weight *= (s - all[j].s) / (all[i].s - all[j].s);
      told += weight * all[i].kappa;
    }
    const Look middle = look(s, all[k].orbit);
    const double size = std::max(std::abs(all[k].kappa), std::abs(all[k + 1].kappa));
    const bool known = std::abs(middle.kappa - told) < 0.1 * size;
    all.insert(all.begin() + long(k) + 1, middle);
    k += known ? 2 : 0;
  }
}

// From the linear well to either end of the family, on the article's chain as long as it holds the tail. No step goes so
// far that the breather grows by more than three per cent at once, or Newton's method may leap to another family
static std::vector<Look> looks_along(Centre centre, const Cut& cut, int side) {
  const auto look = [&](double s, const Orbit<double>& near) {
    const auto problem = problem_at(centre, cut.at(s));
    const Orbit<double> orbit = follow(problem, near);
    return Look{s, floquet_pairs(problem.chain, orbit.start, orbit.period()).pinning(), orbit};
  };
  Progress progress(side > 0 ? "s up to 1" : "s down to -1", 20);
  const Orbit<double> shorter = find_breather(problem_at(centre, {cut.fixed, 0}));
  std::vector<Look> all{look(0, lengthened(problem_at(centre, cut.at(0)), shorter))};
  for (double h = 0.025; h > 0.025 / 16 && std::abs(all.back().s) < 1;) {
    const double next = std::min(std::abs(all.back().s) + h, 1.0);
    try {
      Look there = look(side * next, all.back().orbit);
      const double grown = std::abs(there.orbit.amplitude / all.back().orbit.amplitude - 1);
      if (grown < 0.03) {
        if (sites_needed(there.orbit, 1e-17) > there.orbit.start.y.size()) break;
        all.push_back(std::move(there));
        progress.reach(next);
        if (grown < 0.01) h = std::min(2 * h, 0.025);
        continue;
      }
    } catch (const NewtonFailed&) {  // it ends, or the step is too long
    }
    h /= 2;
  }
  look_closer(all, look);
  return all;
}

InWells exchanges_in_wells(Centre centre, double omega_b) {
  const Cut cut{true, omega_b, 10};
  std::array<std::vector<Look>, 2> sides;
  parallel_for(2, [&](std::size_t k) { sides[k] = looks_along(centre, cut, k ? 1 : -1); });
  std::vector<Look>&all = sides[0], &harder = sides[1];
  std::reverse(all.begin(), all.end());
  all.insert(all.end(), harder.begin() + 1, harder.end());
  // Does kappa dip through zero and back beside the least of three?
  const auto look = [&](double s, Orbit<double> near) {
    const double kappa = quick_kappa(centre, cut.at(s), near);
    return Look{s, kappa, std::move(near)};
  };
  for (std::size_t k = 1; k + 1 < all.size(); ++k) {
    const double here = all[k].kappa;
    const auto larger = [&](const Look& l) { return l.kappa / here >= 1; };
    if (!larger(all[k - 1]) || !larger(all[k + 1])) continue;
    Look left = all[k - 1], middle = all[k], right = all[k + 1];
    for (double h = (right.s - left.s) / 2; middle.kappa * here > 0 && h > 1e-4; h /= 10) {
      middle = look(flat_between(left, middle, right), middle.orbit);
      left = look(middle.s - h / 10, middle.orbit), right = look(middle.s + h / 10, middle.orbit);
    }
    if (middle.kappa * here < 0) all.insert(all.begin() + long(k) + (middle.s > all[k].s), middle);
  }
  std::vector<std::array<const Look*, 2>> pairs;  // the one nearer to the linear well first
  for (std::size_t k = 1; k < all.size(); ++k)
    if (all[k - 1].kappa * all[k].kappa < 0) {
      pairs.push_back({&all[k - 1], &all[k]});
      if (all[k].s <= 0) std::swap(pairs.back()[0], pairs.back()[1]);
    }
  InWells out{all.front().s, all.back().s, std::vector<Estimate>(pairs.size())};
  parallel_for("intervals of s", pairs.size(), [&](std::size_t k) {
    // From the nearer end, where the family changes less
    const auto& [near, far] = pairs[k];
    const Exchange found =
        refined_zero<Wide>(centre, cut,
                           exchange_between(centre, cut, {near->s, near->kappa},
                                            {far->s, far->kappa}, near->orbit, 1e-5));
    // A zero lies where it was looked for, and has opposite signs on its sides
    out.places[k] = found.place;
    const double s = found.place.value, aside = std::max(4 * found.place.error, 1e-4);
    const auto sign_at = [&](double at) { return look(at, found.orbit).kappa > 0; };
    const bool inside = (s - near->s) * (s - far->s) < 0;
    if (!inside || sign_at(s - aside) == sign_at(s + aside))
      throw NewtonFailed("kappa changes its sign between s = " + std::to_string(near->s) + " and " +
                             std::to_string(far->s) + ", and no zero is found there",
                         {});
  });
  return out;
}

#define LATTICE_INSTANCES(T)                                                    \
  template Spectrum spectrum<T>(const Shooting<double>&, const Orbit<double>&); \
  template Exchange refined_zero<T>(Centre, const Cut&, Exchange);              \
  template Exchange exchange<T>(Centre, const Cut&, double, double, Orbit<double>);
#include "lattice/model/instances.hpp"

}  // namespace lattice
