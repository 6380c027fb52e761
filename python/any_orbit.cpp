#include "any_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "lattice/events/overlap.hpp"
#include "lattice/numerics/progress.hpp"
#include "sec3/resolutions.hpp"

namespace lattice {
using namespace report;
namespace {

/// Singular values below this part of the largest one belong to directions in which the orbit may be moved: a shift in
/// time, and one of a chain without wells.
constexpr double free_below = 1e-9;

/// The rule for orbits of which the equations determine all but such a shift.
template <class T>
NewtonRule<T> shortest_step() {
  NewtonRule<T> how = rule<T>(Resolution::fine);
  how.rank = free_below, how.scale = 1;
  return how;
}

/// Throws std::invalid_argument if a state would move by less than its positions are rounded.
void refuse_equilibrium(const Shooting<double>& problem, const State<double>& start) {
  double most = 0;
  for (double y : start.y) most = std::max(most, std::abs(y));
  if (reach(problem.chain, start, problem.omega) <=
      64 * std::numeric_limits<double>::epsilon() * most)
    throw std::invalid_argument("y: nothing moves, and an equilibrium is no periodic orbit");
}

/// The orbit near `guess`, with steps that are halved until they help.
Fitted near_guess(const Chain& chain, const State<double>& guess, double period) {
  Symmetry symmetry = even_in_time(chain.sites);
  symmetry.decays = false;  // nothing is known of its tail, if it has one
  Shooting<double> problem{chain, std::move(symmetry), 2 * pi<double>() / period};
  refuse_equilibrium(problem, guess);
  NewtonRule<double> how = shortest_step<double>();
  how.damped = true;
  Orbit<double> orbit = newton(problem, problem.reduce(guess), how);
  return {std::move(problem), std::move(orbit)};
}

/// The problem in extended precision; a frequency in double precision would change the last digit of the period.
Shooting<Wide> with_period(const Shooting<double>& problem, double period) {
  Shooting<Wide> out = in_precision<Wide>(problem);
  out.omega = 2 * pi<Wide>() / Wide(period);
  return out;
}

/// Half the distance between the extreme positions of the bead that moves most, from `parts` segments of `duration`; on
/// each the position is a cubic.
template <class T>
T half_range(const Chain& chain, const State<T>& start, const T& duration, int parts) {
  State<T> before = start;
  std::vector<T> low = start.y, high = start.y;
  const auto enter = [&](std::size_t n, const T& y) {
    low[n] = std::min(low[n], y), high[n] = std::max(high[n], y);
  };
  for (int k = 0; k < parts; ++k) {
    State<T> now = before;
    const T dt = duration / T(parts);
    flow(chain, now, dt);
    for (std::size_t n = 0; n < chain.sites; ++n) {
      enter(n, now.y[n]);
      if (!(before.v[n] * now.v[n] < T(0))) continue;
      const Arc<T> arc{before.y[n], before.v[n], now.y[n], now.v[n], dt};
      const auto rising = [&](const T& s) { return arc.slope(s) * before.v[n] > T(0); };
      enter(n, arc.value(Arc<T>::last(T(1), rising)));
    }
    before = now;
  }
  T most(0);
  for (std::size_t n = 0; n < chain.sites; ++n) most = std::max(most, T(high[n] - low[n]));
  return most / T(2);
}

/// How many times an orbit repeats itself in its period, counted in prime factors below a hundred.
int repeats_of(const Chain& chain, const State<double>& start, double period, double amplitude) {
  int repeats = 1;
  for (int prime : {2,  3,  5,  7,  11, 13, 17, 19, 23, 29, 31, 37, 41,
                    43, 47, 53, 59, 61, 67, 71, 73, 79, 83, 89, 97})
    for (;;) {
      State<double> end = start;
      flow(chain, end, period / (repeats * prime));
      if (largest_difference(end, start) > 1e-7 * amplitude) break;
      repeats *= prime;
    }
  return repeats;
}

}  // namespace

RestingOrbit orbit_from_rest(const Chain& chain, const State<double>& guess, double period) {
  const Fitted found = near_guess(chain, guess, period);
  const auto& [problem, orbit] = found;
  const Shooting<Wide> wider = with_period(problem, period);
  RestingOrbit out{{found, newton(wider, orbit, shortest_step<Wide>()), {}}, {}, 1};
  for (std::size_t n = 0; n < chain.sites; ++n)
    out.y.push_back(with_error(orbit.start.y[n], double(out.wide.start.y[n])));
  // Half a period shows all positions
  constexpr int parts = 64;
  const Wide wide = half_range(chain, out.wide.start, out.wide.period() / Wide(2), 2 * parts);
  out.amplitude =
      with_error(half_range(chain, orbit.start, orbit.period() / 2, parts), double(wide));
  out.repeats = repeats_of(chain, orbit.start, orbit.period(), out.amplitude.value);
  return out;
}

Table RestingOrbit::quantities() const {
  Answers q;
  add_orbit(q, *this, amplitude,
            "half the distance between the extreme positions of the bead that moves most");
  q.add(
      "repeats", exact(repeats), "",
      "how many times the motion repeats itself in the given period; 1 if that is the minimal one");
  return q.table;
}

Spectrum multipliers_from_rest(const Chain& chain, const State<double>& start, double period) {
  const Fitted found = near_guess(chain, start, period);
  const double apart = largest_difference(found.orbit.start, start) /
                       half_range(chain, found.orbit.start, period / 2, 64);
  if (!(apart < 1e-3))
    throw std::invalid_argument(
        number_label(
            "y and period: no periodic orbit; the nearest one found begins at a distance of",
            apart) +
        " of the amplitude (allowed: 0.001)");
  return spectrum<Wide>(with_period(found.problem, period), found.orbit, free_below);
}

}  // namespace lattice
