#include "sec5/decay.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>

#include "lattice/diagnostics/pulse.hpp"
#include "lattice/impact/impact.hpp"
#include "lattice/standing/spectrum.hpp"
#include "sec5/driven_chain.hpp"

namespace lattice {

double Member::multiplier() const {
  return std::exp(growth * 2 * std::numbers::pi / omega);
}

Orbit<double> breather_at(Centre centre, double omega, double s) {
  return find_breather(
      breather_problem<double>(centre, omega, s, centre == Centre::bond ? 22 : 21));
}

Member member_at(Centre centre, double omega, double s, bool fine) {
  const auto orbit = breather_at(centre, omega, s);
  const std::size_t sites = orbit.start.y.size();
  const auto problem = breather_problem<double>(centre, omega, s, sites);
  EventTolerance<double> rule;
  if (!fine) rule.tolerance *= 1000;
  const auto pairs = floquet_pairs(problem.chain, orbit.start, orbit.period(), rule);
  Member out{omega, orbit.area, pairs.pinning(), 0};
  if (out.kappa > 0) out.growth = 2 * std::asinh(std::sqrt(out.kappa)) / orbit.period();
  return out;
}

namespace {

/// How a shift grows along a branch, against the logarithm of the area.
struct Stability {
  std::vector<double> area, mu, square;  ///< ln A, ln(omega - 1), (sigma/(omega - 1))^2
  double limit;

  Stability(const std::vector<Member>& members, double lambda) : limit(lambda * lambda) {
    for (const Member& m : members) {
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

/// The largest |X|, by the classical Runge-Kutta method in nu t.
double largest_shift(const Stability& stability, double nu) {
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

}  // namespace

double largest_shift(const std::vector<Member>& members, double limit, double nu) {
  return largest_shift(Stability(members, limit), nu);
}

// By steps of a tenth from far below, as growth need not be monotonic in the lifetime, and then by bisection
double lifetime_of_growth(const std::vector<Member>& members, double limit, double factor) {
  const Stability stability(members, limit);
  double most = 0;
  for (const Member& m : members) most = std::max(most, m.growth);
  double high = 0.1 / most;
  while (largest_shift(stability, 1 / high) < factor)
    if (high *= 1.1; !(high * most < 1e6)) throw std::invalid_argument("the branch is stable");
  double low = high / 1.1;
  for (int k = 0; k < 40; ++k) {
    const double middle = (low + high) / 2;
    (largest_shift(stability, 1 / middle) < factor ? low : high) = middle;
  }
  return high;
}

// The pair that becomes the translational pair of the chain
double dps_growth(Centre centre) {
  const auto spectrum =
      contact_spectrum(stationary<double>(centre, 1.0, centre == Centre::bond ? 30 : 31));
  const double square = lambda_squared(1.0, spectrum.m[1]);
  return square > 0 ? std::sqrt(square) : 0;
}

Decay let_decay(const Orbit<double>& orbit, const Chain& chain, double nu, double duration,
                double step) {
  State<double> state = orbit.start;
  const std::size_t most =
      std::size_t(std::max_element(state.y.begin(), state.y.end(),
                                   [](double a, double b) { return std::abs(a) < std::abs(b); }) -
                  state.y.begin());
  std::vector<double> t, y, e, centres;
  evolve({chain, {nu, 0}}, state, time_grid(duration, step, step),
         [&](const State<double>& now, const EnergyBudget&) {
           const auto density = energy_density(chain, now);
           t.push_back(now.t), y.push_back(now.y[most]);
           e.push_back(total(density));
           double contacts = 0;
           for (std::size_t n = 1; n < chain.sites; ++n)
             contacts += contact_energy(chain, now.y.data(), n);
           centres.push_back(energy_centre(density, most, chain.sites) + contacts / (2 * e.back()));
           return true;
         });
  // From one upward crossing to that eight periods later
  Decay out;
  constexpr std::size_t periods = 8;
  const auto up = upward_crossings(t, y);
  for (std::size_t k = 0; k + periods < up.size(); ++k) {
    const auto at = [&](double when) {
      return std::size_t(std::lower_bound(t.begin(), t.end(), when) - t.begin());
    };
    double sum = 0, place = 0;
    const std::size_t from = at(up[k]), to = at(up[k + periods]);
    for (std::size_t i = from; i < to; ++i) sum += e[i], place += centres[i];
    const double end = up[k + periods], turns = 2 * std::numbers::pi * double(periods);
    const double count = double(to - from);
    out.push_back({(up[k] + end) / 2, turns / (end - up[k]), sum / count, place / count});
  }
  return out;
}

}  // namespace lattice
