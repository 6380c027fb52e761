#include "sec3/kick_threshold.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "lattice/algebra/dense.hpp"
#include "lattice/model/sites.hpp"
#include "sec3/article_chains.hpp"

namespace lattice {

// Inverse iteration turns any guess towards the eigenvector nearest to `value`, slowly if others are near
static Vector<double> eigenvector_near(const Matrix<double>& m, double value,
                                       Vector<double> guess) {
  const Matrix<double> shifted = m - (value + 1e-5) * Matrix<double>::Identity(m.rows(), m.cols());
  double turn = 1;
  for (int k = 0; k < 20 || (turn > 1e-13 && k < 5000); ++k) {
    const Vector<double> next = solve_square(shifted, guess).normalized();
    turn = std::min((next - guess).norm(), (next + guess).norm());
    guess = next;
  }
  return guess;
}

// How positions follow from positions and velocities: after a period, or around a site half of one and the reflection
static Matrix<double> period_map(const RestingBreather& at, const EventTolerance<double>& rule) {
  const auto n = Eigen::Index(at.chain.sites);
  const bool site = at.centre == Centre::site;
  State<double> state = at.rest;
  Tangent<double> tangent(at.chain.sites, 2 * at.chain.sites);
  flow(at.chain, state, site ? at.period / 2 : at.period, rule, &tangent);
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Matrix<double> map = Eigen::Map<const Rows>(tangent.entries.data(), n, 2 * n);
  return site ? Matrix<double>(-map.colwise().reverse()) : map;
}

// Even perturbations suffice around a bond, where the shift in time is odd; around a site take all
static Matrix<double> slow_basis(const RestingBreather& at) {
  const auto n = Eigen::Index(at.chain.sites);
  if (at.centre == Centre::site) return Matrix<double>::Identity(n, n);
  Matrix<double> basis = Matrix<double>::Zero(n, n / 2);
  for (Eigen::Index i = 0; i < n / 2; ++i) basis(i, i) = basis(n - 1 - i, i) = std::sqrt(0.5);
  return basis;
}

// The slow plane, from its eigenvectors
Pinning pinning_of(const RestingBreather& at, const EventTolerance<double>& rule) {
  const Matrix<double> basis = slow_basis(at);
  const Matrix<double> map = period_map(at, rule);
  const Eigen::Index n = map.rows();
  const Matrix<double> M_yy = basis.transpose() * map.leftCols(n) * basis;
  const Matrix<double> M_yv = basis.transpose() * map.rightCols(n) * basis;
  const Vector<double> g =
      basis.transpose() * Eigen::Map<const Vector<double>>(at.g.data(), Eigen::Index(at.g.size()));
  const double near = at.centre == Centre::site ? -1 : 1, period = at.period;
  // Right and left eigenvectors span the plane: a shift of positions and a push of velocities
  const Vector<double> xi = eigenvector_near(M_yy, near, g);
  const Vector<double> zeta = eigenvector_near(M_yy.transpose(), near, g);
  const double cosine = zeta.dot(M_yy * xi) / zeta.dot(xi),
               b = zeta.dot(M_yv * zeta) / zeta.dot(xi), part = xi.dot(g);
  const double phi = b * part * part / (period * xi.dot(zeta));
  const double miss = 2 * (1 - std::abs(cosine)) / (period * period);
  const Vector<double> shift = (part < 0 ? -1 : 1) * (basis * xi);
  const std::vector<double> mode(shift.begin(), shift.end());
  if (at.centre == Centre::bond) return {miss, phi, part * part, mode};
  // Around a site half a period is taken twice, which doubles the angle
  return {2 * (1 + std::abs(cosine)) * miss, 2 * cosine * phi, part * part, mode};
}

double pendulum_speed(double start, double omega, bool from_maximum) {
  const double change = omega / std::numbers::pi;
  if (!from_maximum && start <= change) return 0;
  double a = from_maximum ? std::hypot(start, change) : start;
  double b = from_maximum ? start : std::sqrt(start * start - change * change);
  while (std::abs(a - b) > 1e-14 * a) {
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  return a;
}

// A cubic through the means near the maximum
double hill_speed(const KickedPath& path) {
  const double hill = 0.5;
  std::vector<std::size_t> near;
  for (std::size_t k = 0; k < path.size(); ++k)
    if (std::abs(std::abs(path.moved(k)) - hill) <= 0.05) near.push_back(k);
  if (near.size() < 8)
    throw std::invalid_argument("too few averages of the path lie on the potential hill");
  const double first = path[near.front()].t, last = path[near.back()].t, half = (last - first) / 2;
  // Time is scaled to the interval from -1 to 1, which keeps the cubic fit well conditioned
  Matrix<double> power(Eigen::Index(near.size()), 4);
  Vector<double> place(power.rows());
  for (Eigen::Index i = 0; i < power.rows(); ++i) {
    const std::size_t k = near[std::size_t(i)];
    const double u = (path[k].t - first) / half - 1;
    power.row(i) << 1, u, u * u, u * u * u;
    place[i] = std::abs(path.moved(k)) - hill;
  }
  const Vector<double> a = least_squares(power, place);
  // The least slope of the cubic or, if it has none, the slope in the middle
  return (a[3] > 0 ? a[1] - a[2] * a[2] / (3 * a[3]) : a[1]) / half;
}

// Newton's method, with no overlap negligible; the runs neglect the faintest
RestingBreather resting_breather(Centre centre, Phase phase, double omega_b, std::size_t sites,
                                 double s) {
  const Fitted found =
      fit_chain(centre, omega_b, Quartic{s}, centre == Centre::site ? sites | 1 : sites,
                sites_of(centre, Length::for_kicks), 1e-16, phase);
  const State<double>& rest = found.orbit.start;
  return {centre,
          Chain{rest.y.size(), simplest(Well(Quartic{s}))},
          rest,
          found.problem.period(),
          found.orbit.energy,
          kick_direction(rest.y)};
}

RestingBreather along_pinning_mode(RestingBreather at) {
  at.g = pinning_of(at).shift;
  return at;
}

RestingBreather reversed(RestingBreather at) {
  for (double& x : at.g) x = -x;
  return at;
}

EventCorrected fourteen_stages(double step) {
  return {step, nystrom(blanes_moan_6_14())};
}

Prediction predict_threshold(const RestingBreather& at, const Estimate& barrier) {
  EventTolerance<double> coarse;
  coarse.tolerance *= 16;
  const TwoRuns<Pinning> found{pinning_of(at, coarse), pinning_of(at)};
  Prediction out;
  out.phi = found.of(&Pinning::phi);
  out.along = found.of(&Pinning::along);
  out.barrier = barrier;
  if (!(found.fine.frequency2 > 0)) return out;
  out.frequency = found.of([](const Pinning& p) { return std::sqrt(p.frequency2); });
  // The threshold goes as the root of the barrier, so the barrier's relative error counts half
  out.threshold =
      found.of([&](const Pinning& p) { return std::sqrt(2 * std::abs(barrier.value / p.phi)); });
  out.threshold.error += 0.5 * out.threshold.value * std::abs(barrier.error / barrier.value);
  return out;
}

KickedPath decided_path(const RestingBreather& at, double c, const Method& method, double limit) {
  KickedPath path = at.after(c, method, limit, [](const KickedPath& so_far, auto&...) {
    return mobility_of(so_far) == Mobility::undecided;
  });
  if (mobility_of(path) != Mobility::undecided) return path;
  throw std::runtime_error("a kick neither depins the breather nor leaves it pinned");
}

Depinning depinning(const RestingBreather& at, double predicted, const Method& method,
                    double limit) {
  Depinning out;
  for (std::size_t i = 0; i < kicks_beyond.size(); ++i) {
    out.c[i] = kicks_beyond[i] * predicted;
    const KickedPath path = decided_path(at, out.c[i], method, limit);
    if (mobility_of(path) != Mobility::free)
      throw std::runtime_error("a kick above the predicted threshold leaves the breather pinned");
    out.speed[i] = hill_speed(path);
    out.drift = std::max(out.drift, path.run.energy_drift);
  }
  const auto from = [&](std::size_t i, std::size_t k) {
    const double c1 = out.c[i], v1 = out.speed[i], c2 = out.c[k], v2 = out.speed[k];
    return std::sqrt((c1 * c1 * v2 * v2 - c2 * c2 * v1 * v1) / (v2 * v2 - v1 * v1));
  };
  const Estimate one = with_error(from(0, 2), from(0, 1)), two = with_error(from(1, 2), from(0, 1));
  out.threshold = {one.value, std::max(one.error, two.error)};
  return out;
}

}  // namespace lattice
