#include "commands/one_barrier.hpp"

#include "sec3/breather_options.hpp"

namespace lattice {

void OneBarrier::parameters(Parameters& p) {
  p.add("omega", omega_b, "frequency omega_b > 1", breather_range(1.0001, 3));
  p.add("s", s, "anharmonicity of the well", {-10, 10});
}

OneBarrier::Found OneBarrier::find() const {
  BreatherPair pair{s, omega_b};
  for (int k : {0, 1}) pair.orbit[k] = find_breather(problem_of(both_centres[k], omega_b, s));
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
