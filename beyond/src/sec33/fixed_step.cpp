#include "sec33/fixed_step.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "lattice/model/typed.hpp"
#include "lattice/orbits/linear.hpp"
#include "lattice/orbits/shooting.hpp"
#include "sec33/depinning.hpp"

namespace lattice {

namespace {

using Rows = std::vector<std::vector<double>>;

/// to += factor * from
void add(std::vector<double>& to, double factor, const std::vector<double>& from) {
  if (factor == 0) return;
  const double* __restrict__ x = from.data();
  double* __restrict__ out = to.data();
  for (std::size_t i = 0, n = to.size(); i < n; ++i) out[i] += factor * x[i];
}

/// The scheme with its step worked in, so that a stage is a sum of rows.
struct Weights {
  std::vector<double> drift, kick;
  Rows stage;

  Weights(const Nystrom& m, double h) : stage(m.a) {
    for (double c : m.c) drift.push_back(c * h);
    for (double b : m.b) kick.push_back(b * h);
    for (auto& row : stage)
      for (double& a : row) a *= h * h;
  }

  /// Positions of stage `i`.
  void positions(std::size_t i, const std::vector<double>& y, const std::vector<double>& v,
                 const Rows& forces, std::vector<double>& out) const {
    const double d = drift[i];
    for (std::size_t n = 0; n < y.size(); ++n) out[n] = y[n] + d * v[n];
    for (std::size_t j = 0; j < i; ++j) add(out, stage[i][j], forces[j]);
  }

  /// The end of a step: `at_end` are the positions of the last stage.
  void finish(std::vector<double>& y, std::vector<double>& v, Rows& forces,
              std::vector<double>& at_end) const {
    for (std::size_t i = 0; i < kick.size(); ++i) add(v, kick[i], forces[i]);
    std::swap(y, at_end);
    std::swap(forces.front(), forces.back());
  }
};

/// What the linearised forces do to columns of positions: entry (n, c) stands at n * count + c.
void pull(const Hessian<double>& h, const std::vector<double>& y, std::vector<double>& out) {
  const std::size_t sites = h.diagonal.size(), count = y.size() / sites;
  for (std::size_t n = 0; n < sites; ++n) {
    const double *here = y.data() + n * count, d = h.diagonal[n];
    double* to = out.data() + n * count;
    for (std::size_t c = 0; c < count; ++c) to[c] = -d * here[c];
    const auto beside = [&](double off, const double* there) {
      if (off == 0) return;
      for (std::size_t c = 0; c < count; ++c) to[c] -= off * there[c];
    };
    if (n > 0) beside(h.off[n - 1], here - count);
    if (n + 1 < sites) beside(h.off[n], here + count);
  }
}

/// The map with its columns, whose positions and velocities are `y` and `v`.
void carry_columns(const FixedStep& map, State<double> state, std::vector<double>& y,
                   std::vector<double>& v) {
  const Weights weights(map.method, map.period / double(map.steps));
  const std::size_t stages = map.method.c.size();
  Window all{0, map.chain.sites};
  Rows forces(stages, state.y), pulls(stages, y);
  std::vector<double> at = state.y, column_at = y;
  const auto evaluate = [&](std::size_t i) {
    accelerate(map.chain, at.data(), forces[i].data(), all);
    pull(linearise(map.chain, at), column_at, pulls[i]);
  };
  evaluate(0);
  for (std::size_t k = 0; k < map.steps; ++k) {
    for (std::size_t i = 1; i < stages; ++i) {
      weights.positions(i, state.y, state.v, forces, at);
      weights.positions(i, y, v, pulls, column_at);
      evaluate(i);
    }
    weights.finish(state.y, state.v, forces, at);
    weights.finish(y, v, pulls, column_at);
  }
}

}  // namespace

void carry(const FixedStep& map, State<double>& state, std::size_t count) {
  const Weights weights(map.method, map.period / double(map.steps));
  const std::size_t stages = map.method.c.size(), sites = map.chain.sites;
  Rows forces(stages, state.y);
  std::vector<double> at = state.y;
  // Long runs of short chains choose the loop once, and both ends are free
  detail::with_pair<double>(map.chain, [&]<class W, class C>(const W& well, const C& contact) {
    if constexpr (detail::has_loop<double, W, C>) {
      const auto evaluate = [&](std::size_t i) {
        sweep_acceleration(well, contact, at.data(), forces[i].data(), Homogeneous{}, sites, 0.0,
                           0.0);
      };
      evaluate(0);
      for (std::size_t k = 0; k < map.steps * count; ++k) {
        for (std::size_t i = 1; i < stages; ++i) {
          weights.positions(i, state.y, state.v, forces, at);
          evaluate(i);
        }
        weights.finish(state.y, state.v, forces, at);
      }
    } else
      throw std::invalid_argument("a map of fixed steps needs potentials that have a loop");
  });
  state.t += map.period * double(count);
}

// Columns of the tangent, or quotients of small differences
Matrix<double> derivative(const FixedStep& map, const State<double>& start, std::size_t count,
                          double increment) {
  const std::size_t sites = start.y.size();
  Matrix<double> out(2 * sites, count);
  if (increment == 0) {
    std::vector<double> y(sites * count, 0), v = y;
    for (std::size_t c = 0; c < count; ++c)
      (c < sites ? y[c * count + c] : v[(c - sites) * count + c]) = 1;
    carry_columns(map, start, y, v);
    for (std::size_t n = 0; n < sites; ++n)
      for (std::size_t c = 0; c < count; ++c) {
        out(n, c) = y[n * count + c];
        out(sites + n, c) = v[n * count + c];
      }
    return out;
  }
  const double h = increment * largest(start);
  State<double> end = start;
  carry(map, end);
  for (std::size_t c = 0; c < count; ++c) {
    State<double> moved = start;
    entry(moved, c) += h;
    carry(map, moved);
    for (std::size_t i = 0; i < 2 * sites; ++i) out(i, c) = (entry(moved, i) - entry(end, i)) / h;
  }
  return out;
}

// Newton's method with least squares
MapBreather find_breather(const FixedStep& map, State<double> guess, const GaussNewton& how) {
  MapBreather out{std::move(guess)};
  const std::size_t sites = map.chain.sites;
  for (int k = 0;; ++k) {
    State<double> end = out.start;
    carry(map, end);
    Vector<double> miss(2 * sites);
    for (std::size_t i = 0; i < 2 * sites; ++i) miss[i] = entry(end, i) - entry(out.start, i);
    const double size = largest(out.start);
    out.residual = miss.cwiseAbs().maxCoeff() / size;
    if (k == how.iterations) return out;
    Matrix<double> jacobian = derivative(map, out.start, sites, how.increment);
    for (std::size_t n = 0; n < sites; ++n) jacobian(n, n) -= 1;
    const Vector<double> change = solve_system(jacobian, miss, how.rank);
    for (std::size_t n = 0; n < sites; ++n) out.start.y[n] -= change[n];
    out.variation = change.cwiseAbs().maxCoeff() / size;
  }
}

// The zero of the parabola through three wells
double zero_in_wells(const std::array<double, 3>& kappa) {
  const double slope = (kappa[2] - kappa[0]) / 2, bend = (kappa[2] + kappa[0]) / 2 - kappa[1];
  const double root = slope * slope - 4 * bend * kappa[1];
  const double none = std::numeric_limits<double>::quiet_NaN();
  if (!(root >= 0)) return none;
  // The root nearest to zero, without a difference of equal numbers
  const double s = -2 * kappa[1] / (slope + std::copysign(std::sqrt(root), slope));
  return std::abs(s) <= 1 ? s : none;
}

Creep path_of(const FixedStep& map, State<double> state, std::size_t periods, std::size_t every,
              const std::function<bool(const Creep&)>& stop) {
  Creep path;
  const auto look = [&] {
    path.t.push_back(state.t);
    path.X.push_back(breather_place(energy_density(map.chain, state)));
  };
  look();
  for (std::size_t k = 0; k + every <= periods && !stop(path); k += every) {
    carry(map, state, every);
    look();
  }
  return path;
}

bool stays_away(const Creep& path, double sites, double since) {
  if (path.t.empty() || path.t.back() < since) return false;
  for (std::size_t k = 0; k < path.t.size(); ++k)
    if (path.t[k] >= since && !(std::abs(std::abs(path.moved(k)) - sites) <= 0.5)) return false;
  return true;
}

bool frees(const FixedStep& map, const State<double>& start, double c, std::size_t periods) {
  const Creep path = path_of(map, kicked(start, c), periods, 16, [](const Creep& so_far) {
    return mobility_of(so_far) != Mobility::undecided;
  });
  return mobility_of(path) == Mobility::free;
}

}  // namespace lattice
