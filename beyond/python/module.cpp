/**
# The second Python module

It has what is beyond the article: `lattice.travelling` and `lattice.drive`, whose names and documentation are in
package.py. */

#include "binding.hpp"

#include <array>

#include "commands/one_orbit.hpp"
#include "lattice/numerics/parallel.hpp"
#include "sec5/driven_chain.hpp"

namespace {

py::tuple one_orbit(const Words& words) {
  const auto command = read<OneOrbit>(words);
  const auto found = at_work([&] { return command.find(); });
  return answer(command, found) + py::make_tuple(found.problem.chain);
}

/**
With damping or a force the energy is not conserved but accounted for, and the budget takes the place of the drift. */
py::tuple drive_chain(const Chain& chain, const Numbers& y, const Numbers& v, double time,
                      double sample, double tolerance, const std::vector<double>& damping,
                      double force, double frequency) {
  DrivenChain driven{chain, {}, {}};
  driven.losses.of_site = damping;
  if (force != 0) driven.drive = {Drive::By::base, frequency, force};
  Samples samples(chain, time, sample);
  std::vector<double> injected, dissipated, energies;
  State<double> state = state_of(chain, y.data(), v.data());
  const auto pair = at_work([&] {
    return evolve(Converged{tolerance}, driven, state, time, Every{sample},
                  [&](const State<double>& now, const EnergyBudget& budget) {
                    samples.take(now);
                    injected.push_back(budget.work);
                    dissipated.push_back(budget.beams);
                    energies.push_back(energy(chain, now));
                    return true;
                  });
  });
  samples.demand_all();
  // The three balance: none is better known than the others, though two runs may agree in it by chance
  const auto all = [](const DrivenEnd& run) {
    return std::array{run.budget.work, run.budget.beams, run.energy};
  };
  const auto coarse = all(pair.coarse), fine = all(pair.fine);
  double error = 0;
  for (std::size_t k : {0, 1, 2}) error = std::max(error, with_error(coarse[k], fine[k]).error);
  const auto known = [&](std::size_t k) {
    return py::make_tuple(fine[k], fine[k] == 0 ? with_error(coarse[k], fine[k]).error : error);
  };
  return py::make_tuple(samples.t, samples.y, samples.v, pair.error, pair.fine.imbalance, known(0),
                        known(1), known(2), array_of(injected), array_of(dissipated),
                        array_of(energies));
}

}  // namespace

PYBIND11_MODULE(_beyond, m) {
  translate_complaints();
  m.attr("options") = options<OneOrbit>();
  m.def("set_threads", &set_threads);
  m.def("travelling", &one_orbit);
  m.def("drive", &drive_chain);
}
