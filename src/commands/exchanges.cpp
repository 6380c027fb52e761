#include "commands/exchanges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "lattice/numerics/parallel.hpp"
#include "lattice/numerics/progress.hpp"
#include "sec3/resolutions.hpp"

namespace lattice {
using namespace report;

namespace {

// The breather in one well, and its kappa
struct Trial {
  double s, kappa;
  Orbit<double> orbit;
};

// Where the parabola through three trials is flat, between the outer two
double flat_between(const Trial& a, const Trial& b, const Trial& c) {
  const double left = b.s - a.s, right = c.s - b.s;
  const double up = (c.kappa - b.kappa) / right, down = (b.kappa - a.kappa) / left;
  const double bend = (up - down) / (left + right);
  return bend == 0
             ? b.s
             : std::clamp(b.s - (up * left + down * right) / (left + right) / (2 * bend), a.s, c.s);
}

}  // namespace

// An interval is halved where the cubic through the trials around it does not predict kappa in its middle
template <class Find>
static void refine(std::vector<Trial>& all, Find trial_at) {
  for (std::size_t k = 0; k + 1 < all.size();) {
    const double low = all[k].s, high = all[k + 1].s, s = (low + high) / 2;
    if (std::abs(high - low) < 2e-4) {
      ++k;
      continue;
    }
    double predicted = 0;
    const std::size_t end = std::min(k + 3, all.size()),
                      begin = std::min(k ? k - 1 : 0, end - std::min<std::size_t>(4, end));
    for (std::size_t i = begin; i < end; ++i) {
      double weight = 1;
      for (std::size_t j = begin; j < end; ++j)
        if (j != i) weight *= (s - all[j].s) / (all[i].s - all[j].s);
      predicted += weight * all[i].kappa;
    }
    const Trial middle = trial_at(s, all[k].orbit);
    const double size = std::max(std::abs(all[k].kappa), std::abs(all[k + 1].kappa));
    const bool known = std::abs(middle.kappa - predicted) < 0.1 * size;
    all.insert(all.begin() + long(k) + 1, middle);
    k += known ? 2 : 0;
  }
}

// From the linear well to either end of the family, on the article's chain as long as it holds the tail. No step goes so
// far that the breather grows by more than three per cent at once, or Newton's method may leap to another family
static std::vector<Trial> trials_along(Centre centre, const Cut& cut, int side) {
  const auto trial_at = [&](double s, const Orbit<double>& near) {
    const auto problem = problem_at(centre, cut.at(s));
    const Orbit<double> orbit = newton_from(problem, near);
    return Trial{s, floquet_pairs(problem.chain, orbit.start, orbit.period()).pinning(), orbit};
  };
  Progress progress(side > 0 ? "s up to 1" : "s down to -1", 20);
  const Orbit<double> shorter = find_breather(problem_at(centre, {cut.fixed, 0}));
  std::vector<Trial> all{trial_at(0, lengthened(problem_at(centre, cut.at(0)), shorter))};
  for (double h = 0.025; h > 0.025 / 16 && std::abs(all.back().s) < 1;) {
    const double next = std::min(std::abs(all.back().s) + h, 1.0);
    try {
      Trial there = trial_at(side * next, all.back().orbit);
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
  refine(all, trial_at);
  return all;
}

InWells exchanges_in_wells(Centre centre, double omega_b) {
  const Cut cut{true, omega_b, 10};
  std::array<std::vector<Trial>, 2> sides;
  parallel_for(2, [&](std::size_t k) { sides[k] = trials_along(centre, cut, k ? 1 : -1); });
  std::vector<Trial>&all = sides[0], &harder = sides[1];
  std::reverse(all.begin(), all.end());
  all.insert(all.end(), harder.begin() + 1, harder.end());
  // Does kappa dip through zero and back beside the least of three?
  const auto trial_at = [&](double s, Orbit<double> near) {
    const double kappa = quick_kappa(centre, cut.at(s), near);
    return Trial{s, kappa, std::move(near)};
  };
  for (std::size_t k = 1; k + 1 < all.size(); ++k) {
    const double here = all[k].kappa;
    const auto larger = [&](const Trial& l) { return l.kappa / here >= 1; };
    if (!larger(all[k - 1]) || !larger(all[k + 1])) continue;
    Trial left = all[k - 1], middle = all[k], right = all[k + 1];
    for (double h = (right.s - left.s) / 2; middle.kappa * here > 0 && h > 1e-4; h /= 10) {
      middle = trial_at(flat_between(left, middle, right), middle.orbit);
      left = trial_at(middle.s - h / 10, middle.orbit),
      right = trial_at(middle.s + h / 10, middle.orbit);
    }
    if (middle.kappa * here < 0) all.insert(all.begin() + long(k) + (middle.s > all[k].s), middle);
  }
  std::vector<std::array<const Trial*, 2>> pairs;  // the one nearer to the linear well first
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
    // A zero lies where it was sought, and has opposite signs on its sides
    out.places[k] = found.place;
    const double s = found.place.value, aside = std::max(4 * found.place.error, 1e-4);
    const auto sign_at = [&](double at) { return trial_at(at, found.orbit).kappa > 0; };
    const bool inside = (s - near->s) * (s - far->s) < 0;
    if (!inside || sign_at(s - aside) == sign_at(s + aside))
      throw NewtonFailed("kappa changes sign between s = " + std::to_string(near->s) + " and " +
                             std::to_string(far->s) + ", but no zero is found there",
                         {});
  });
  return out;
}

Table Exchanges::table() const {
  auto [from, to, found] = exchanges_in_wells(centre, omega_b);
  if (found.empty())
    throw Failure("no exchange of stability between s = " + short_text(from) + " and " +
                  short_text(to) + " at omega_b = " + short_text(omega_b));
  const auto nearer = [](const Estimate& a, const Estimate& b) {
    return std::abs(a.value) < std::abs(b.value);
  };
  std::sort(found.begin(), found.end(), nearer);
  Answers q;
  for (std::size_t k = 0; k < found.size(); ++k)
    q.add_small(
        k ? "s0_" + std::to_string(k + 1) : "s0", found[k], "",
        "anharmonicity s at which kappa of the pinning pair changes sign; searched from s = " +
            short_text(from) + " to " + short_text(to) +
            ", in steps over which the amplitude changes by less than three per cent; two zeros "
            "within one step may be missed");
  return q.table;
}

}  // namespace lattice
