#include "sec2/searches.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lattice/events/columns.hpp"
#include "lattice/gsl/random.hpp"
#include "lattice/numerics/parallel.hpp"

namespace searches {

// The derivative of a kick is the linearisation (chain.hpp) about the positions at which it is given
static void kick_tangent(const Chain& chain, const std::vector<double>& y, double h,
                         Tangent<double>& tangent) {
  const Hessian<double> bend = linearise(chain, y);
  const std::size_t sites = chain.sites, columns = tangent.columns;
  for (std::size_t n = 0; n < sites; ++n) {
    const double push = -h * inverse_mass<double>(chain, n);
    double* row = tangent.row(sites + n);
    add_scaled(row, tangent.row(n), push * bend.diagonal[n], columns);
    if (n > 0) add_scaled(row, tangent.row(n - 1), push * bend.off[n - 1], columns);
    if (n + 1 < sites) add_scaled(row, tangent.row(n + 1), push * bend.off[n], columns);
  }
}

void LeapfrogShooting::advance(State<double>& z, Tangent<double>* tangent, int count,
                               const std::function<void(const State<double>&)>& watch) const {
  const std::size_t sites = chain.sites;
  const double h = period() / steps;
  const auto drift = [&](double by) {
    add_scaled(z.y.data(), z.v.data(), by, sites);
    if (tangent) add_scaled(tangent->row(0), tangent->row(sites), by, sites * tangent->columns);
  };
  for (int k = 0; k < count; ++k) {
    drift(h / 2);
    const std::vector<double> a = accelerations(chain, z.y);
    add_scaled(z.v.data(), a.data(), h, sites);
    if (tangent) kick_tangent(chain, z.y, h, *tangent);
    drift(h / 2);
    watch(z);
  }
}

// As in shooting.hpp but for how the chain is run: residuals and derivatives follow from the lists of the symmetry
Evaluation<double> LeapfrogShooting::evaluate(const Vector<double>& x, bool with_jacobian) const {
  const State<double> start = expand(x);
  State<double> z = start;
  const Tangent<double> first = tangent_of<double>(symmetry.unknowns, chain.sites);
  Tangent<double> tangent = first;
  advance(z, with_jacobian ? &tangent : nullptr, steps / symmetry.parts,
          [](const State<double>&) {});
  Evaluation<double> out;
  out.residual = residuals(start, z);
  if (with_jacobian) out.jacobian = slopes(first, tangent);
  return out;
}

Equations<double> LeapfrogShooting::equations() const {
  const auto rows = Eigen::Index(symmetry.equations.size());
  return {name(),
          [*this](const Vector<double>& x, const EventTolerance<double>&, bool derivative) {
            return evaluate(x, derivative);
          },
          [rows, size = scale](const Vector<double>& x, bool) {
            return Sizes<double>{Vector<double>::Constant(x.size(), size),
                                 Vector<double>::Constant(rows, size)};
          }};
}

// A motion that begins at rest is at rest again after half a period; any other has to return after a whole one
static std::pair<LeapfrogShooting, State<double>> draw(const Series& series, unsigned long seed,
                                                       int steps) {
  const std::size_t sites = series.sites, middle = sites / 2;
  const bool at_rest = seed % 2 == 1;
  LeapfrogShooting search;
  search.chain = {sites, series.wells ? Well{Harmonic{}} : Well{None{}}, Hertz{.floor = 0},
                  series.ends};
  search.omega = 1.2;
  search.steps = steps;
  search.symmetry = at_rest ? even_in_time(sites) : travelling(sites, 0, false);
  Random random(seed);
  const double size = std::exp(random.uniform(std::log(series.least), std::log(series.most)));
  State<double> start(sites);
  for (std::size_t n = middle - 1; n <= middle + 1; ++n) {
    start.y[n] = size * random.uniform(-1, 1);
    if (!at_rest) start.v[n] = size * random.uniform(-1, 1);
  }
  search.scale = largest(start);
  return {search, start};
}

// A motion that is found is followed for a period and classified
static End classify(const LeapfrogShooting& search, const State<double>& start) {
  State<double> z = start;
  double swing = 0, overlap = 0;
  search.advance(z, nullptr, search.steps, [&](const State<double>& now) {
    for (std::size_t n = 0; n < now.y.size(); ++n) {
      swing = std::max(swing, std::abs(now.y[n] - start.y[n]) / search.scale);
      if (n > 0) overlap = std::max(overlap, (now.y[n - 1] - now.y[n]) / search.scale);
    }
  });
  if (swing < 1e-6 && overlap < 1e-6) return End::rest;
  if (!(swing > 1e-2)) return End::doubtful;
  const auto e = energy_density(search.chain, start);
  const double all = energy(search.chain, start);
  return std::max(e.front(), e.back()) < 1e-6 * all ? End::localized : End::extended;
}

// Newton's method with the exact flow may move the motion by a tenth of its size, and must end in one of the same kind
static bool confirmed(const LeapfrogShooting& search, const Vector<double>& from, End end) try {
  Equations<double> nearby = search.Shooting<double>::equations();
  nearby.evaluate = [&, exact = nearby.evaluate](const Vector<double>& x,
                                                 const EventTolerance<double>& rule,
                                                 bool derivative) {
    if (sup<double>(x - from) < 0.1 * sup(from)) return exact(x, rule, derivative);
    throw NewtonFailed("Newton's method leaves the neighbourhood of its start", {});
  };
  NewtonRule<double> rule;
  if (search.symmetry.parts == 1) rule.rank = 1e-9;  // such orbits may be shifted in time
  return classify(search, search.expand(newton(nearby, from, rule).x)) == end;
} catch (const NewtonFailed&) {
  return false;
}

// A motion that fails this test is counted as doubtful
static End run_search(const Series& series, unsigned long seed, int steps) {
  const auto [search, start] = draw(series, seed, steps);
  const NewtonRule<double> rule{.most_steps = 200, .damped = true, .rank = 1e-9};
  try {
    const Vector<double> x = newton(search.equations(), search.reduce(start), rule).x;
    const End end = classify(search, search.expand(x));
    const bool moves = end == End::localized || end == End::extended;
    return moves && !confirmed(search, x, end) ? End::doubtful : end;
  } catch (const NewtonFailed&) {
    return End::failed;
  }
}

Estimate EndCounts::sum(const std::vector<End>& ends) const {
  std::array<double, 2> n{};
  for (End end : ends)
    for (std::size_t k : {0, 1}) n[k] += of[k][std::size_t(end)];
  const double error = std::abs(n[1] - n[0]) + std::sqrt(n[1] * (all - n[1]) / all);
  return error > 0 ? Estimate{n[1], error} : exact(n[1]);
}

EndCounts search_all(const Series& series, unsigned long seeds) {
  std::vector<End> ends(2 * seeds);
  parallel_for("searches, " + series.name, ends.size(), [&](std::size_t i) {
    const unsigned long seed = i / 2 + 1;
    const int steps = i % 2 == 0 ? 128 : 256;
    ends[i] = run_search(series, seed, steps);
  });
  EndCounts counts{{}, double(seeds)};
  for (std::size_t i = 0; i < ends.size(); ++i) counts.of[i % 2][std::size_t(ends[i])] += 1;
  return counts;
}

}  // namespace searches
