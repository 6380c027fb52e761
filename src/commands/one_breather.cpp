#include "commands/one_breather.hpp"

#include "lattice/orbits/breather_pairs.hpp"
#include "lattice/quadruple_orbits/orbits.hpp"

namespace lattice {

void OneBreather::parameters(Parameters& p) {
  add_omega(p);
  add_well(p);
  add_contacts(p);
  add_masses(p);
  add_centre(p);
  p.add("sites", sites, "chain length (default: 31 or 32)", {3, 1001});
  p.add("precision", precision, "of the orbit; extended takes some seventy times as long",
        {"double", "extended"});
  add_phase(p);
  p.add("profile", as_profile, "print the positions n,y instead");
}

/**
Values are printed in the chosen precision, and their errors are differences from another one.
The residual is that of the whole period. */
template <class T, class Other>
static Table breather_table(const Shooting<T>& problem, const Orbit<T>& orbit,
                            const Orbit<Other>& other, const EventTolerance<T>& landing) {
  State<T> end = orbit.start;
  const FlowReport<T> run = flow(problem.chain, end, problem.period(), landing);
  const T miss = largest_difference(end, orbit.start) / orbit.amplitude;
  const auto differs = [](const T& a, const Other& b) {
    return Estimate{double(a), double(magnitude<T>(a - T(b)))};
  };
  Answers q;
  q.add("amplitude", differs(orbit.amplitude, other.amplitude), "",
        "largest displacement of a bead at t = 0, when all beads are at rest");
  q.add("energy", differs(orbit.energy, other.energy), "", "energy of the whole chain, Eq. (6)");
  q.add("area", differs(orbit.area, other.area), "",
        "integral over a period of the sum of mass times squared velocity, 2 pi times the action");
  q.add_small("residual", {double(miss), double(run.error)}, "relative to amplitude",
              "largest difference of positions and velocities after a period from those before");
  q.add("iterations", exact(double(orbit.iterations())), "",
        "steps of Newton's method in the last solve");
  return q.table;
}

/// A reader may want the tail, so it has relative accuracy at every site.
template <class T>
static Table breather_profile(const Orbit<T>& orbit) {
  Table table{{count("n", "site", "site"), number("y", "position at t = 0")}};
  for (std::size_t i = 0; i < orbit.start.y.size(); ++i)
    table.add({site_number(i, orbit.start.y.size()), double(orbit.start.y[i])});
  return table;
}

/**
Higher precision is expensive and needs a good start: double precision finds the orbit, and each higher precision
confirms the one before. */
OneBreather::Found OneBreather::find() const {
  return find_chosen(*this, extended() ? 1e-34 : 1e-17);
}

static Orbit<Wide> widened(const Fitted& found) {
  return polish(in_precision<Wide>(found.problem), found.orbit, rule<Wide>(0));
}

static NewtonRule<Quadruple> deep_rule() {
  NewtonRule<Quadruple> deep;
  deep.events.tolerance = Quadruple(1e-27);
  return deep;
}

static Orbit<Quadruple> deepened(const Fitted& found, const Orbit<Wide>& wide) {
  return polish(in_precision<Quadruple>(found.problem), wide, deep_rule());
}

/**
The profile in double precision asks for the tail itself; higher precision reaches it without being asked. */
Table OneBreather::quantities(const Found& found) const {
  const Orbit<Wide> wide = widened(found);
  if (!extended()) return breather_table(found.problem, found.orbit, wide, {});
  return breather_table(in_precision<Quadruple>(found.problem), deepened(found, wide), wide,
                        deep_rule().events);
}

Table OneBreather::profile(const Found& found) const {
  if (extended()) return breather_profile(deepened(found, widened(found)));
  return breather_profile(polish(found.problem, found.orbit, graded<double>()));
}

Table OneBreather::table() const {
  const Found found = find();
  return as_profile ? profile(found) : quantities(found);
}

}  // namespace lattice
