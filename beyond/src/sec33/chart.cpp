#include "sec33/chart.hpp"

#include "lattice/numerics/parallel.hpp"

namespace lattice {

NewtonRule<double> chart_rule() {
  NewtonRule<double> how;
  how.events.tolerance = 1e-12;
  how.most_steps = 8;
  how.reuse_below = 1e-6;
  return how;
}

namespace {

// By its amplitude, unless the frequency changes
bool same_family(const Orbit<double>& orbit, const Orbit<double>& from) {
  return std::abs(orbit.amplitude / from.amplitude - 1) <= 0.15 || orbit.omega != from.omega;
}

// A node from the orbit of its neighbour
void visit(Node& node, const Node& from) {
  try {
    const auto problem = problem_at(Centre::site, node.spot);
    node.orbit = newton_from(problem, from.orbit, chart_rule());
    if (!same_family(node.orbit, from.orbit)) {
      if (node.spot.s < 0) return;
      const PlanePoint half{node.spot.omega_b, (node.spot.s + from.spot.s) / 2};
      const auto between = newton_from(problem_at(Centre::site, half), from.orbit, chart_rule());
      node.orbit = newton_from(problem, between, chart_rule());
      if (!same_family(between, from.orbit) || !same_family(node.orbit, between)) return;
    }
    const auto found =
        floquet_pairs(problem.chain, node.orbit.start, node.orbit.period(), chart_rule().events);
    node.kappa = found.pinning(), node.kappa_error = found.symplectic_error;
  } catch (const NewtonFailed&) {
  }
}

// From the linear well to either end of the family
void visit_wells(Nodes& column) {
  const std::size_t middle = column.size() / 2;
  visit(column[middle], column[middle]);
  for (std::size_t k = middle + 1; k < column.size() && column[k - 1].exists(); ++k)
    visit(column[k], column[k - 1]);
  for (std::size_t k = middle; k-- > 0 && column[k + 1].exists();) visit(column[k], column[k + 1]);
}

}  // namespace

// The linear well node after node, then all the other wells side by side
Chart chart(bool quick) {
  const int frequencies = quick ? 12 : 80, wells = quick ? 2 : 12;
  const double top = quick ? 1.2 : 2;
  Chart grid;
  Orbit<double> seed = find_breather(problem_at(Centre::site, {1.01, 0}));
  for (int i = 0; i < frequencies; ++i) {
    const double omega_b = 1.01 + (top - 1.01) * double(i) / (frequencies - 1);
    Nodes column(2 * std::size_t(wells) + 1);
    for (int k = -wells; k <= wells; ++k)
      column[std::size_t(k + wells)].spot = {omega_b, double(k) / wells};
    seed = newton_from(problem_at(Centre::site, {omega_b, 0}), seed, chart_rule());
    column[std::size_t(wells)].orbit = seed;
    grid.push_back(std::move(column));
  }
  parallel_for("chart", grid.size(), [&](std::size_t i) { visit_wells(grid[i]); });
  return grid;
}

}  // namespace lattice
