#include "sec5/decay.hpp"

#include <algorithm>
#include <cmath>

#include "lattice/measure/impact.hpp"
#include "lattice/measure/pulse.hpp"

namespace lattice {

double Member::multiplier() const {
  return std::exp(growth * 2 * std::numbers::pi / omega);
}

Orbit<double> breather_at(Centre centre, double omega, double s) {
  return find_breather(breather_problem<double>(centre, omega, s, centre == Centre::bond ? 22 : 21));
}

Member member_at(Centre centre, double omega, double s, bool fine) {
  const auto orbit = breather_at(centre, omega, s);
  const std::size_t sites = orbit.start.y.size();
  const auto problem = breather_problem<double>(centre, omega, s, sites);
  Landing<double> rule;
  if (!fine) rule.tolerance *= 1000;
  const auto pairs = floquet_pairs(problem.chain, orbit.start, orbit.period(), rule);
  Member out{omega, orbit.energy, orbit.area, pairs.pinning(), 0};
  if (out.kappa > 0) out.growth = 2 * std::asinh(std::sqrt(out.kappa)) / orbit.period();
  return out;
}

// Simpson's rule needs an odd number of members
double growth_times_rate(const std::vector<Member>& members) {
  double sum = 4 * members.front().growth;
  for (std::size_t k = 2; k < members.size(); k += 2) {
    const Member &a = members[k - 2], &b = members[k - 1], &c = members[k];
    // dA/A over the two halves of the interval, as the derivative of ln A at its three points
    const double la = std::log(a.area), lb = std::log(b.area), lc = std::log(c.area);
    const double da = (-3 * la + 4 * lb - lc) / 2, db = (lc - la) / 2,
                 dc = (la - 4 * lb + 3 * lc) / 2;
    sum += (a.growth * da + 4 * b.growth * db + c.growth * dc) / 3;
  }
  return sum;
}

Decay let_decay(const Orbit<double>& orbit, const Chain& chain, double nu, double duration,
                double step) {
  State<double> state = orbit.start;
  const std::size_t most = std::size_t(
      std::max_element(state.y.begin(), state.y.end(),
                       [](double a, double b) { return std::abs(a) < std::abs(b); }) -
      state.y.begin());
  std::vector<double> t, y, e, centres;
  Decay out;
  out.ledger = run_bench({chain, {nu, 0}}, state, pace(duration, step, step),
                         [&](const State<double>& now, const Ledger&) {
                           const auto density = energy_density(chain, now);
                           t.push_back(now.t), y.push_back(now.y[most]);
                           e.push_back(total(density));
                           centres.push_back(energy_centre(density, most));
                           return true;
                         });
  // From one upward passage to the next
  const auto up = upward_crossings(t, y);
  std::vector<double> centre;
  for (std::size_t k = 0; k + 1 < up.size(); ++k) {
    const auto at = [&](double when) {
      return std::size_t(std::lower_bound(t.begin(), t.end(), when) - t.begin());
    };
    double sum = 0, place = 0;
    const std::size_t from = at(up[k]), to = at(up[k + 1]);
    for (std::size_t i = from; i < to; ++i) sum += e[i], place += centres[i];
    out.moments.push_back({(up[k] + up[k + 1]) / 2, 2 * std::numbers::pi / (up[k + 1] - up[k]),
                           sum / double(to - from)});
    centre.push_back(place / double(to - from));
  }
  if (!centre.empty()) out.drift = centre.back() - centre.front();
  return out;
}

}  // namespace lattice
