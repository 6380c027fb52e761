#include "sec5/decay.hpp"

#include <algorithm>
#include <cmath>

#include "lattice/dps/spectrum.hpp"
#include "lattice/packets/impact.hpp"
#include "lattice/packets/pulse.hpp"

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
  Member out{omega, orbit.energy, orbit.area, pairs.pinning(), 0};
  if (out.kappa > 0) out.growth = 2 * std::asinh(std::sqrt(out.kappa)) / orbit.period();
  return out;
}

// The square of the scaled growth rate is smooth, the rate itself begins like a root
double growth_times_rate(const std::vector<Member>& members, double limit) {
  const auto square = [](const Member& m) {
    const double root = std::asinh(std::sqrt(std::abs(m.kappa))) * m.omega / std::numbers::pi;
    return (m.kappa > 0 ? 1 : -1) * std::pow(root / (m.omega - 1), 2);
  };
  constexpr int parts = 256;
  double sum = 0;
  // From the limit to the first member the square is a straight line in omega - 1
  const double first = square(members.front()), low = members.front().omega - 1;
  for (int i = 0; i < parts; ++i) {
    const double part = (i + 0.5) / parts, at = limit * limit + part * (first - limit * limit);
    if (at > 0) sum += 4 * low * std::sqrt(at) / parts;
  }
  for (std::size_t k = 1; k < members.size(); ++k) {
    const Member &a = members[k - 1], &b = members[k];
    const double rise = std::log(b.area / a.area), wide = std::log((b.omega - 1) / (a.omega - 1));
    for (int i = 0; i < parts; ++i) {
      const double part = (i + 0.5) / parts, mu = (a.omega - 1) * std::exp(part * wide);
      const double at = (1 - part) * square(a) + part * square(b);
      if (at > 0) sum += mu * std::sqrt(at) * rise / parts;
    }
  }
  return sum;
}

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
  Decay out;
  out.ledger = run_bench({chain, {nu, 0}}, state, time_grid(duration, step, step),
                         [&](const State<double>& now, const Ledger&) {
                           const auto density = energy_density(chain, now);
                           t.push_back(now.t), y.push_back(now.y[most]);
                           e.push_back(total(density));
                           centres.push_back(energy_centre(density, most));
                           return true;
                         });
  // From one upward passage to that eight periods later
  constexpr std::size_t periods = 8;
  const auto up = upward_crossings(t, y);
  std::vector<double> centre;
  for (std::size_t k = 0; k + periods < up.size(); ++k) {
    const auto at = [&](double when) {
      return std::size_t(std::lower_bound(t.begin(), t.end(), when) - t.begin());
    };
    double sum = 0, place = 0;
    const std::size_t from = at(up[k]), to = at(up[k + periods]);
    for (std::size_t i = from; i < to; ++i) sum += e[i], place += centres[i];
    const double end = up[k + periods], turns = 2 * std::numbers::pi * double(periods);
    out.moments.push_back({(up[k] + end) / 2, turns / (end - up[k]), sum / double(to - from)});
    centre.push_back(place / double(to - from));
  }
  if (!centre.empty()) out.drift = centre.back() - centre.front();
  return out;
}

}  // namespace lattice
