#include "commands/one_barrier.hpp"

namespace lattice {

void OneBarrier::parameters(Parameters& p) {
  add_omega(p);
  add_well(p);
  add_contacts(p);
}

/**
Between spheres that are not compressed the chains are those of the chapter; other breathers decide themselves how long
theirs is. */
OneBarrier::Found OneBarrier::find() const {
  BreatherPair pair{0, omega_b};
  const bool plain = std::holds_alternative<Hertz>(like.contact);
  for (int k : {0, 1}) {
    ChosenBreather one = *this;
    one.centre = both_centres[k];
    auto problem = breather_problem(one.centre, omega_b, well, sites_of(one.centre));
    const Fitted found = plain ? Fitted{problem, find_breather(problem)} : find_chosen(one, 1e-20);
    pair.others.push_back(found.problem);
    pair.orbit[k] = found.orbit;
  }
  measure_in<Wide>(pair);
  return pair;
}

Table OneBarrier::quantities(const Found& found) const {
  Answers q;
  q.add_small("equal_frequency", found.equal_frequency, "",
              "E_site - E_bond, the energies of both breathers at the frequency omega_b");
  q.add_small("equal_area", found.equal_area, "",
              "E_site - E_bond at the area of the bond-centred breather, as a moving one keeps it");
  return q.table;
}

}  // namespace lattice
