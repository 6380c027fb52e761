#include "commands/one_breather.hpp"

#include "lattice/orbits/breather_pairs.hpp"

namespace lattice {

void OneBreather::parameters(Parameters& p) {
  add_omega(p);
  add_well(p);
  add_contacts(p);
  add_masses(p);
  add_centre(p);
  p.add("sites", sites, "chain length (default: 31 or 32)", {3, 1001});
  add_phase(p);
  p.add("profile", as_profile, "print the positions n,y instead");
}

OneBreather::Found OneBreather::find() const {
  return find_chosen(*this, 1e-17);
}

/**
Errors are differences from an orbit in extended precision (a 64-bit mantissa). The residual is that of the whole
period. */
Table OneBreather::quantities(const Found& found) const {
  const Orbit<double>& orbit = found.orbit;
  const Orbit<Wide> wide = newton(in_precision<Wide>(found.problem), orbit, rule<Wide>(0));
  State<double> end = orbit.start;
  const FlowReport<double> run = flow(found.problem.chain, end, found.problem.period(), {});
  const double miss = largest_difference(end, orbit.start) / orbit.amplitude;
  const auto differs = [](double a, const Wide& b) {
    return Estimate{a, double(magnitude<double>(a - double(b)))};
  };
  Answers q;
  q.add("amplitude", differs(orbit.amplitude, wide.amplitude), "",
        "largest displacement of a bead at t = 0, when all beads are at rest");
  q.add("energy", differs(orbit.energy, wide.energy), "", "energy of the whole chain, Eq. (6)");
  q.add("area", differs(orbit.area, wide.area), "",
        "integral over a period of the sum of mass times squared velocity, 2 pi times the action");
  q.add_small("residual", {miss, double(run.error)}, "relative to amplitude",
              "largest difference of positions and velocities after a period from those before");
  q.add("iterations", exact(double(orbit.iterations())), "",
        "steps of Newton's method in the last solve");
  return q.table;
}

// A reader may want the tail, so it has relative accuracy at every site
Table OneBreather::profile(const Found& found) const {
  const Orbit<double> orbit = newton(found.problem, found.orbit, scaled_rule<double>());
  Table table{{count("n", "site", "site"), number("y", "position at t = 0")}};
  for (std::size_t i = 0; i < orbit.start.y.size(); ++i)
    table.add({site_number(i, orbit.start.y.size()), orbit.start.y[i]});
  return table;
}

Table OneBreather::table() const {
  const Found found = find();
  return as_profile ? profile(found) : quantities(found);
}

}  // namespace lattice
