#include "sec36/defect_mode.hpp"

#include <algorithm>
#include <numbers>
#include <stdexcept>

#include "lattice/integrators/event_corrected.hpp"

namespace lattice {

// A short array around the defect; contacts without a floor, because the tail is of interest
Shooting<double> mode_problem(const CantileverArray& array, double ratio) {
  CantileverArray piece = array;
  piece.sites = mode_sites, piece.defect = mode_sites / 2 + 1;
  Shooting<double> problem{cantilever_chain(piece, ratio), even_in_time(mode_sites)};
  problem.chain.contact = Hertz{.floor = 0};
  return problem;
}

// Begin just above the linear frequency, with the amplitude that balances the first harmonic
Orbit<double> mode_of_energy(Shooting<double> problem, double energy) {
  const std::size_t middle = mode_sites / 2;
  const double mu = problem.chain.mass_of(middle), eta = problem.chain.eta_of(middle);
  problem.omega = 1 / std::sqrt(mu) + 0.005;
  const double root = (problem.omega * problem.omega * mu - 1) / (0.915 * eta);
  State<double> guess(mode_sites);
  guess.y[middle] = root * root;
  Orbit<double> orbit = newton(problem, problem.reduce(guess));
  // Then follow the family to the energy asked for, with small changes of the frequency
  const auto fourth_root = [](double x) { return std::sqrt(std::sqrt(x)); };
  for (int k = 0; k < 40; ++k) {
    const double now = fourth_root(orbit.energy);
    const double step = 4 * now * now * now * (fourth_root(energy) - now) / orbit.energy_omega;
    if (std::abs(orbit.energy / energy - 1) < 1e-10) return orbit;
    const double change = std::clamp(step, -0.01, 0.01);
    problem.omega += change;
    orbit = newton(problem, Vector<double>(orbit.x + change * orbit.x_omega));
  }
  throw std::runtime_error("no breather at the defect is found with the requested energy");
}

// Where the energy of the mode is, averaged over one period
std::vector<double> mean_density(const Shooting<double>& problem, const Orbit<double>& orbit,
                                 std::size_t instants) {
  std::vector<double> mean(mode_sites, 0.0);
  State<double> state = orbit.start;
  const double period = 2 * std::numbers::pi / orbit.omega, parts = double(instants);
  evolve(EventCorrected{0.05}, problem.chain, state, period, period / parts,
         [&](const State<double>& now) {
           const auto e = energy_density(problem.chain, now);
           for (std::size_t n = 0; n < mode_sites; ++n) mean[n] += e[n] / (parts + 1);
         });
  return mean;
}

}  // namespace lattice
