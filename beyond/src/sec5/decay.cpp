#include "sec5/decay.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>

#include "lattice/orbits/floquet.hpp"

namespace lattice {

double BranchMember::multiplier() const {
  return std::exp(growth * 2 * std::numbers::pi / omega);
}

BranchMember member_at(Centre centre, double omega, bool fine) {
  const auto problem =
      breather_problem<double>(centre, omega, 0.0, centre == Centre::bond ? 22 : 21);
  const Orbit<double> orbit = find_breather(problem);
  EventTolerance<double> rule;
  if (!fine) rule.tolerance *= 1000;
  const auto pairs = floquet_pairs(problem.chain, orbit.start, orbit.period(), rule);
  BranchMember out{omega, orbit.action_integral, pairs.pinning(), 0};
  if (out.kappa > 0) out.growth = 2 * std::asinh(std::sqrt(out.kappa)) / orbit.period();
  return out;
}

namespace {

/// How a shift grows along a branch, against the logarithm of the area.
struct Stability {
  std::vector<double> area, mu, square;  ///< ln A, ln(omega - 1), (sigma/(omega - 1))^2
  double limit;

  Stability(const std::vector<BranchMember>& members, double lambda) : limit(lambda * lambda) {
    for (const BranchMember& m : members) {
      const double root = std::asinh(std::sqrt(std::abs(m.kappa))) * m.omega / std::numbers::pi;
      area.push_back(std::log(m.area)), mu.push_back(std::log(m.omega - 1));
      square.push_back((m.kappa > 0 ? 1 : -1) * std::pow(root / (m.omega - 1), 2));
    }
  }
  /// The square of the growth rate at ln A = a.
  double operator()(double a) const {
    const std::size_t k = std::size_t(std::lower_bound(area.begin(), area.end(), a) - area.begin());
    if (k == 0) {
      const double part = std::exp((a - area[0]) / 4), low = std::exp(mu[0]) * part;
      return (limit + part * (square[0] - limit)) * low * low;
    }
    const std::size_t i = std::min(k, area.size() - 1);
    const double part = (a - area[i - 1]) / (area[i] - area[i - 1]);
    return (square[i - 1] + part * (square[i] - square[i - 1])) *
           std::exp(2 * (mu[i - 1] + part * (mu[i] - mu[i - 1])));
  }
};

}  // namespace

// By the classical Runge-Kutta method in nu t
double largest_shift(const std::vector<BranchMember>& members, double limit, double nu) {
  const Stability stability(members, limit);
  constexpr int steps = 1000;
  const double h = std::log(100) / steps;
  double x = 1, v = 0, most = 1;
  for (int i = 0; i < steps; ++i) {
    const auto pull = [&](double part) {
      return stability(stability.area.back() - (i + part) * h) / (nu * nu);
    };
    const double left = pull(0), middle = pull(0.5), right = pull(1);
    const double v2 = v + h / 2 * (left * x - v / 4), x2 = x + h / 2 * v;
    const double v3 = v + h / 2 * (middle * x2 - v2 / 4), x3 = x + h / 2 * v2;
    const double v4 = v + h * (middle * x3 - v3 / 4), x4 = x + h * v3;
    const double a = left * x - v / 4, b = middle * x2 - v2 / 4, c = middle * x3 - v3 / 4;
    x += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v += h / 6 * (a + 2 * b + 2 * c + right * x4 - v4 / 4);
    most = std::max(most, std::abs(x));
  }
  return most;
}

// By steps of a tenth from far below, as growth need not be monotonic in the lifetime, and then by bisection
double lifetime_of_growth(const std::vector<BranchMember>& members, double limit, double factor) {
  const auto shift = [&](double lifetime) { return largest_shift(members, limit, 1 / lifetime); };
  double most = 0;
  for (const BranchMember& m : members) most = std::max(most, m.growth);
  double high = 0.1 / most;
  while (shift(high) < factor)
    if (high *= 1.1; !(high * most < 1e6)) throw std::invalid_argument("the branch is stable");
  double low = high / 1.1;
  for (int k = 0; k < 40; ++k) {
    const double middle = (low + high) / 2;
    (shift(middle) < factor ? low : high) = middle;
  }
  return high;
}

}  // namespace lattice
