#include "sec33/intermediate.hpp"

#include <cmath>
#include <cstddef>

#include "lattice/numerics/parallel.hpp"
#include "sec33/held.hpp"

namespace lattice {

namespace {

template <class T>
Held<T> held_problem(const Cut& cut, const Exchange& from, double centre) {
  Shooting<T> problem = in_precision<T>(problem_at(Centre::site, cut.at(from.place.value)));
  problem.symmetry = even_in_time(problem.chain.sites);
  return {problem, cut.along_s ? along_s<T>() : along_omega<T>(), T(centre)};
}

// Extended precision, twice
Intermediate describe(const Cut& cut, const Exchange& from, double centre,
                      const Vector<double>& near) {
  const auto held = held_problem<Wide>(cut, from, centre);
  std::array<Vector<Wide>, 2> x;
  std::array<Pairs<Wide>, 2> pairs;
  for (std::size_t coarser : {0U, 1U}) {
    const NewtonRule<Wide> how = rule<Wide>(int(coarser));
    x[coarser] = newton(held.equations(), Vector<Wide>(near.cast<Wide>()), how).x;
    const auto there = held.at(x[coarser]);
    pairs[coarser] = floquet_pairs(there.chain, held.start(x[coarser]), there.period(), how.events);
  }
  const Eigen::Index last = x[0].size() - 1;
  const double apart = double(magnitude<Wide>(x[1][last] - x[0][last]));
  Intermediate out{centre, x[0][last], energy(held.at(x[0]).chain, held.start(x[0]))};
  out.place = {double(out.parameter), apart + double(pairs[0].defect) / std::abs(from.slope)};
  const Spectrum all{compare_pairs(pairs[1], pairs[0]), {}};
  out.kappa = all.kappa();
  out.largest_modulus = all.largest_modulus();
  return out;
}

}  // namespace

// From centre to centre in double precision, then each by itself
std::vector<Intermediate> intermediate_breathers(const Cut& cut, const ExchangePair& ends,
                                                 int count) {
  const Exchange& from = ends.found[0];
  const auto n = Eigen::Index(from.orbit.start.y.size());
  Vector<double> x(n + 1);
  for (Eigen::Index i = 0; i < n; ++i) x[i] = from.orbit.start.y[std::size_t(i)];
  const auto centre = [&](std::size_t k) { return double(k + 1) / (2 * count); };
  std::vector<Vector<double>> near;
  for (std::size_t k = 0; k + 1 < std::size_t(count); ++k) {
    const double wave = std::sin(pi<double>() * centre(k));
    x[n] = from.place.value + wave * wave * ends.width().value;
    near.push_back(moved_to_centre(held_problem<double>(cut, from, centre(k)), x));
    x = near.back();
  }
  std::vector<Intermediate> out(near.size());
  parallel_for("intermediate breathers", out.size(),
               [&](std::size_t k) { out[k] = describe(cut, from, centre(k), near[k]); });
  return out;
}

// The energies of both symmetric breathers at the same parameters
double energy_share(const Cut& cut, const ExchangePair& ends, const Intermediate& one) {
  std::array<Wide, 2> e{};
  for (std::size_t k : {0U, 1U}) {
    const auto problem = problem_at(both_centres[k], cut.at(double(one.parameter)));
    auto wide = in_precision<Wide>(problem);
    if (!cut.along_s) wide.omega = one.parameter;
    e[k] = newton(wide, follow(problem, ends.found[k].orbit)).energy;
  }
  return double((one.energy - e[0]) / (e[1] - e[0]));
}

}  // namespace lattice
