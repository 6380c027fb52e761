#include "commands/one_barrier.hpp"

namespace lattice {

void OneBarrier::parameters(Parameters& p) {
  p.add("omega", omega, "frequency omega_b > 1", {1.0001, 3});
  p.add("s", s, "anharmonicity of the well", {-10, 10});
}

OneBarrier::Found OneBarrier::find() const {
  BreatherPair pair{s, omega};
  for (int k : {0, 1}) pair.orbit[k] = find_breather(problem_of(both_centres[k], omega, s));
  measure_in<Wide>(pair);
  return pair;
}

Table OneBarrier::quantities(const Found& found) const {
  Quantities q;
  q.add("equal_frequency", found.equal_frequency);
  q.add("equal_area", found.equal_area);
  return q.table;
}

}  // namespace lattice
