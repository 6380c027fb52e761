#include "any_orbit.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "commands/multipliers.hpp"
#include "lattice/algebra/dense.hpp"
#include "lattice/events/overlap.hpp"
#include "lattice/numerics/progress.hpp"
#include "lattice/orbits/floquet.hpp"
#include "sec3/resolutions.hpp"

namespace lattice {
using namespace report;
namespace {

using Multiplier = std::complex<double>;

/// Singular values below this part of the largest one belong to directions in which the orbit may be moved: a shift in
/// time, and one of a chain without wells.
constexpr double free_below = 1e-9;

/// The rule for orbits of which the equations determine all but such a shift.
template <class T>
NewtonRule<T> shortest_step(Resolution resolution = Resolution::fine) {
  NewtonRule<T> how = rule<T>(resolution);
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

/// The orbit of this symmetry near `guess`, with steps that are halved until they help.
Fitted near_guess(const Chain& chain, Symmetry symmetry, const State<double>& guess,
                  double period) {
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

/**
A shift in time is an eigenvector of the monodromy matrix $M$ with eigenvalue one, and the gradient of the energy is one
of its transpose. Vectors that are perpendicular to both are mapped, but for multiples of the shift, among themselves, and
the eigenvalues there are all but those of the phase. */
template <class T>
std::vector<Multiplier> beside_phase(const Chain& chain, const State<T>& start, const T& period,
                                     const EventTolerance<T>& how) {
  const auto n = Eigen::Index(chain.sites);
  const std::vector<T> a = accelerations(chain, start.y);
  Vector<T> shift(2 * n), gradient(2 * n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto site = std::size_t(i);
    const T mass(chain.mass_of(site));
    shift[i] = start.v[site], shift[n + i] = a[site];
    gradient[i] = -mass * a[site], gradient[n + i] = mass * start.v[site];
  }
  const Matrix<T> without_shift = perpendicular_to(shift);
  const Vector<T> rest = without_shift.transpose() * gradient;
  const Matrix<T> basis = without_shift * perpendicular_to(rest);
  std::vector<Multiplier> out;
  for (const auto& z :
       eigenvalues_of<T>(basis.transpose() * monodromy(chain, start, period, how) * basis))
    out.emplace_back(double(z.real()), double(z.imag()));
  std::stable_sort(out.begin(), out.end(), [](const Multiplier& x, const Multiplier& y) {
    return std::abs(x - 1.0) < std::abs(y - 1.0);
  });
  return out;
}

/// The multipliers of an orbit that is nowhere at rest: the error of each is its distance from that in less precision.
OrbitMultipliers in_motion(const Fitted& found, double period) {
  const NewtonRule<Wide> how = shortest_step<Wide>();
  const Orbit<Wide> wide = newton(with_period(found.problem, period), found.orbit, how);
  std::vector<Multiplier> coarse =
      beside_phase(found.problem.chain, found.orbit.start, found.orbit.period(),
                   rule<double>(Resolution::fine).events);
  OrbitMultipliers out{{{1, 0}, {1, 0}}, exact(1)};
  double most = 1, least = 1, surely = 1;
  for (const Multiplier& z :
       beside_phase(found.problem.chain, wide.start, wide.period(), how.events)) {
    const auto nearest = std::min_element(
        coarse.begin(), coarse.end(),
        [&](const auto& x, const auto& y) { return std::abs(x - z) < std::abs(y - z); });
    const double error =
        std::abs(*nearest - z) + std::numeric_limits<double>::epsilon() * std::abs(z);
    coarse.erase(nearest);
    out.all.emplace_back(z, error);
    most = std::max(most, std::abs(z));
    least = std::max(least, std::abs(z) - error), surely = std::max(surely, std::abs(z) + error);
  }
  out.largest_modulus = {most, std::max(most - least, surely - most)};
  return out;
}

/// Throws std::invalid_argument if `share` of the amplitude is too much.
void refuse_beyond(double most, double share, const char* what) {
  if (share < most) return;
  throw std::invalid_argument(
      number_label(std::string("y, v and period: no periodic orbit; ") + what, share) +
      number_label(" of the amplitude (allowed:", most) + ")");
}

}  // namespace

RestingOrbit orbit_from_rest(const Chain& chain, const State<double>& guess, double period) {
  const Fitted found = near_guess(chain, even_in_time(chain.sites), guess, period);
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

// Half a period is enough, and tells more digits, where the orbit begins at rest
OrbitMultipliers multipliers_through(const Chain& chain, const State<double>& start,
                                     double period) {
  const auto moves = [](double v) { return v != 0; };
  const bool rests = std::none_of(start.v.begin(), start.v.end(), moves);
  const bool ring = chain.ends == Ends::periodic;
  const Symmetry symmetry = rests ? even_in_time(chain.sites) : travelling(chain.sites, 0, ring);
  // Distances are relative to the motion
  refuse_equilibrium({chain, symmetry, 2 * pi<double>() / period}, start);
  State<double> end = start;
  if (!is_accurate(try_flow(chain, end, period), {}))
    throw std::invalid_argument(
        "y, v and period: no periodic orbit; the motion from there cannot be followed");
  const double range = half_range(chain, start, period, 64);
  double size = range;
  for (double v : start.v) size = std::max(size, std::abs(v));
  refuse_beyond(0.1, largest_difference(end, start) / size,
                "after one period it misses its start by");
  const Fitted found = near_guess(chain, symmetry, start, period);
  const double apart = largest_difference(found.orbit.start, start) / size;
  refuse_beyond(1e-3, apart, "the nearest one found begins at a distance of");
  if (!rests) return in_motion(found, period);
  const Spectrum all = spectrum<Wide>(with_period(found.problem, period), found.orbit, free_below);
  return {multipliers_of(all), all.largest_modulus()};
}

}  // namespace lattice
