#include "sec33/plane.hpp"

#include <algorithm>
#include <string>

#include "lattice/numerics/parallel.hpp"

namespace lattice {

namespace {

// Newton's method from a neighbour, which gives up soon: its orbits are only passed
NewtonRule<double> passing_rule() {
  NewtonRule<double> rule;
  rule.events.tolerance = 1e-12;
  rule.most_steps = 8;
  rule.reuse_below = 1e-6;
  return rule;
}

// From a breather to that in the well `end`, in steps of s that change it by less than a tenth. Throws NewtonFailed where
// they would have to be tiny, because the family ends.
void continue_in_s(Centre centre, BreatherAt& at, double end) {
  double step = std::clamp(end - at.spot.s, -0.02, 1.0);
  while (at.spot.s != end) {
    const bool is_last = std::abs(step) >= std::abs(end - at.spot.s);
    const Spot next{at.spot.omega_b, is_last ? end : at.spot.s + step};
    try {
      const auto there = newton_from(problem_at(centre, next), at.orbit, passing_rule());
      if (std::abs(there.amplitude / at.orbit.amplitude - 1) < 0.1) {
        at.spot = next;
        at.orbit = there;
        continue;
      }
    } catch (const NewtonFailed&) {  // the step is halved
    }
    step /= 2;
    if (std::abs(step) < 1e-3) throw NewtonFailed("the family ends", {});
  }
}

// From well to well in this order, until the family ends
std::vector<BreatherAt> as_far_as_it_reaches(Centre centre, BreatherAt at,
                                             const std::vector<double>& wells) {
  std::vector<BreatherAt> out;
  for (const double s : wells) {
    try {
      continue_in_s(centre, at, s);
    } catch (const NewtonFailed&) {
      return out;
    }
    out.push_back(at);
  }
  return out;
}

// Converged, on a chain that holds the tail, with its pairs
BreatherAt finished(Centre centre, BreatherAt at) {
  if (sites_needed(at.orbit, 1e-17) == at.orbit.start.y.size()) {
    at.spot.more = 10;
    at.orbit = lengthened(problem_at(centre, at.spot), at.orbit);
  }
  at.spectrum = spectrum<double>(problem_at(centre, at.spot), at.orbit);
  return at;
}

}  // namespace

// From the linear well at each frequency
std::vector<BreatherAt> breathers_over_the_plane(Centre centre, const std::vector<double>& omegas,
                                                 const std::vector<double>& wells) {
  // Hard wells from the linear one on, then soft ones
  std::vector<double> hard, soft;
  for (const double s : wells) (s < 0 ? soft : hard).push_back(s);
  std::sort(hard.begin(), hard.end());
  std::sort(soft.rbegin(), soft.rend());

  // The linear well at all frequencies, one after the other
  std::vector<BreatherAt> linear;
  for (const double omega_b : omegas) {
    const Spot spot{omega_b, 0};
    const auto problem = problem_at(centre, spot);
    linear.push_back({spot, linear.empty() ? find_breather(problem)
                                           : newton_from(problem, linear.back().orbit)});
  }
  std::vector<std::vector<BreatherAt>> columns(omegas.size());
  parallel_for("frequencies", omegas.size(), [&](std::size_t i) {
    for (const auto& side : {hard, soft})
      for (const BreatherAt& at : as_far_as_it_reaches(centre, linear[i], side))
        columns[i].push_back(finished(centre, at));
  });
  std::vector<BreatherAt> out;
  for (const auto& column : columns) out.insert(out.end(), column.begin(), column.end());
  return out;
}

// What the statements compare
void add_spectra(Table& table, Centre centre, const std::vector<BreatherAt>& breathers) {
  const char* how = "difference of two resolutions, relative to one";
  for (const BreatherAt& at : breathers) {
    const std::vector<Pair>& pairs = at.spectrum.pairs;
    table.add(
        {{"centre", "site or bond", name_of(centre)},
         {"omega", "frequency", at.spot.omega_b},
         {"s", "anharmonicity of the well", at.spot.s},
         {"fourth", "distance of the fourth multiplier from +1", from_one(pairs[0])},
         {"fifth", "distance of the fifth multiplier from +1", from_one(pairs[1])},
         {"others", "largest modulus from the fifth multiplier on, minus one", excess(pairs, 1), "",
          how},
         {"largest", "largest modulus of all multipliers, minus one", excess(pairs), "", how}});
  }
}

// Ten more sites, in three wells
void add_edges(Table& table, Centre centre, const std::vector<BreatherAt>& breathers) {
  std::vector<BreatherAt> ends;
  for (const BreatherAt& at : breathers)
    if (at.spot.s == -1 || at.spot.s == 0 || at.spot.s == 1) ends.push_back(at);
  std::vector<int> added(ends.size());
  parallel_for("longer chains", ends.size(), [&](std::size_t k) {
    added[k] = added_at_edge(centre, ends[k].spot, ends[k].orbit, ends[k].spectrum.pairs);
  });
  for (std::size_t k = 0; k < ends.size(); ++k)
    table.add(
        {{"centre", "site or bond", name_of(centre)},
         {"omega", "frequency", ends[k].spot.omega_b},
         {"s", "anharmonicity of the well", ends[k].spot.s},
         {"added", "multipliers that ten more sites add at the point of accumulation", added[k]}});
}

}  // namespace lattice
