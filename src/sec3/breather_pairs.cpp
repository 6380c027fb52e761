#include "sec3/breather_pairs.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "lattice/model/precisions.hpp"
#include "lattice/numerics/parallel.hpp"

namespace lattice {

/// What one resolution measures on a pair.
template <class T>
struct Measured {
  std::array<Orbit<T>, 2> orbit;
  Barrier<T> gap;
};

/// Both breathers of a pair and the barrier between them, at one tolerance. The coarser one starts off the orbit, by
/// one part in a million, so that it has to find its own way back.
template <class T>
static Measured<T> measured(const BreatherPair& pair, Resolution resolution) {
  const NewtonRule<T> how = rule<T>(resolution);
  Measured<T> out;
  for (int k : {0, 1}) {
    Orbit<double> guess = pair.orbit[k];
    if (resolution == Resolution::coarse) guess.x *= 1.000001;
    out.orbit[k] = newton(in_precision<T>(pair.problem(k)), guess, how);
  }
  out.gap = barrier(in_precision<T>(pair.problem(0)), out.orbit[0], out.orbit[1], how);
  return out;
}

/// Two resolutions side by side: the finer one gives the value, their difference the error.
template <class T>
static void set_errors(BreatherPair& pair, const Measured<T>& coarse, const Measured<T>& fine) {
  // Near omega_b = 1 the energy changes so fast with the frequency that the rounding of the phase shows in it
  const auto size_of = [&](const Orbit<T>& b) {
    return std::max(b.energy, T(pair.omega) * magnitude(b.energy_omega) / T(64));
  };
  const T size = size_of(fine.orbit[1]);
  for (int k : {0, 1}) {
    const Orbit<T>&a = coarse.orbit[k], &b = fine.orbit[k];
    pair.energy[k] = with_flow_error(a.energy, b.energy, size_of(b));
    pair.amplitude[k] = with_flow_error(a.amplitude, b.amplitude, b.amplitude);
  }
  // The barriers are tiny, but their rounding is that of the energies they are differences of
  pair.equal_frequency =
      with_flow_error(coarse.gap.equal_frequency, fine.gap.equal_frequency, size);
  pair.equal_action = with_flow_error<T>(coarse.gap.equal_action, fine.gap.equal_action,
                                         fine.orbit[1].energy / T(4));
  const auto slope = [](const Measured<T>& m) {
    return m.orbit[0].energy_omega - m.orbit[1].energy_omega;
  };
  pair.slope = with_flow_error(slope(coarse), slope(fine), fine.orbit[1].energy_omega);
  // At equal action it is (omega_site/omega - 1) H'_bond, as dH = omega dA / 2 pi along both families
  const auto slope_action = [&](const Measured<T>& m) {
    return m.orbit[1].energy_omega * (m.gap.omega_site / T(pair.omega) - T(1));
  };
  pair.slope_action =
      with_flow_error(slope_action(coarse), slope_action(fine), fine.orbit[1].energy_omega);
}

template <class T>
void measure_in(BreatherPair& pair) {
  set_errors<T>(pair, measured<T>(pair, Resolution::coarse), measured<T>(pair, Resolution::fine));
}

/// Whether a value is known to three parts in a thousand.
static bool settled(const Estimate& e) {
  return e.error <= 3e-3 * std::abs(e.value);
}

void measure(BreatherPair& pair) {
  measure_in<double>(pair);
  if (!settled(pair.equal_frequency) || !settled(pair.equal_action)) measure_in<Wide>(pair);
}

BreatherPair barriers_at(double omega_b, double s) {
  BreatherPair pair{s, omega_b};
  for (int k : {0, 1}) pair.orbit[k] = find_breather(pair.problem(k));
  measure(pair);
  return pair;
}

/// At one tolerance, for a step of a search; the errors are those of rounding alone.
template <class T>
static void measure_once(BreatherPair& pair, Resolution resolution) {
  const auto only = measured<T>(pair, resolution);
  set_errors<T>(pair, only, only);
}

std::vector<double> pair_frequencies(double s, int count) {
  std::vector<double> out{1.005};
  for (int k = 1; k <= count; ++k) out.push_back(1 + double(k) / count);
  if (s >= 0) return out;
  std::erase_if(out, [](double omega) { return omega > 1.8; });
  for (int k = 1; k <= count / 2; ++k) out.push_back(1.8 + 0.2 * double(k) / count);
  return out;
}

/// The same two problems at another frequency.
static std::vector<Shooting<double>> at_frequency(std::array<Shooting<double>, 2> problems,
                                                  double omega) {
  for (Shooting<double>& problem : problems) problem.omega = omega;
  return {problems.begin(), problems.end()};
}

// Both families first, then all pairs, none of which needs another
BreatherPairs breather_pairs_at(double s, const std::array<Shooting<double>, 2>& problems,
                                const std::vector<double>& omegas,
                                const std::function<void(BreatherPair&)>& measure_pair) {
  std::array<std::vector<Orbit<double>>, 2> families;
  parallel_for(2, [&](std::size_t k) { families[k] = breathers_at(problems[k], omegas); });
  BreatherPairs pairs;
  const auto& [site, bond] = families;
  for (std::size_t k = 0; k < std::min(site.size(), bond.size()); ++k) {
    BreatherPair pair{.s = s, .omega = site[k].omega, .orbit = {site[k], bond[k]}};
    pair.others = at_frequency(problems, pair.omega);
    pairs.push_back(pair);
  }
  parallel_for("branches", pairs.size(), [&](std::size_t i) { measure_pair(pairs[i]); });
  return pairs;
}

/// The pair of frequency `omega`, not yet measured. With the growth like (omega - 1)^2 taken out, a branch is almost
/// straight in log(omega - 1).
static BreatherPair pair_between(const BreatherPair& left, const BreatherPair& right,
                                 double omega) {
  BreatherPair pair{.s = left.s, .omega = omega};
  pair.others = at_frequency({left.problem(0), left.problem(1)}, omega);
  const auto scaled = [&](double from) {
    const double ratio = (omega - 1) / (from - 1);
    return ratio * ratio;
  };
  const double part =
      std::log((omega - 1) / (left.omega - 1)) / std::log((right.omega - 1) / (left.omega - 1));
  for (int k : {0, 1})
    pair.orbit[k] = newton(pair.problem(k),
                           Vector<double>((1 - part) * scaled(left.omega) * left.orbit[k].x +
                                          part * scaled(right.omega) * right.orbit[k].x),
                           on_the_way());
  return pair;
}

/// The last two steps to a zero near `omega`: one at each tolerance. The second, which is what the two tolerances and
/// the curvature make of the zero, is its error, with that of the barrier there over its slope.
template <class T>
static Estimate last_steps(const BreatherPair& low, const BreatherPair& high, double omega) {
  double step = 0, error = 0;
  for (const Resolution resolution : {Resolution::coarse, Resolution::fine}) {
    BreatherPair at = pair_between(low, high, omega);
    measure_once<T>(at, resolution);
    step = at.equal_frequency.value / at.slope.value;
    error = std::abs(at.equal_frequency.error / at.slope.value);
    omega -= step;
  }
  return {omega, error + std::abs(step) + 1e-15};
}

// Newton's method for a vanishing barrier, with bisection if it would leave the bracket
Estimate frequency_of_zero(const BreatherPair& left, const BreatherPair& right) {
  const double below = left.equal_frequency.value, above = right.equal_frequency.value,
               width = right.omega - left.omega;
  BreatherPair low = left, high = right;
  double omega = left.omega - below * width / (above - below);
  // Double precision goes as far as the barrier stands out from its error
  for (int k = 0; k < 40; ++k) {
    BreatherPair at = pair_between(low, high, omega);
    measure_once<double>(at, Resolution::fine);
    const Estimate now = at.equal_frequency;
    const double step = now.value / at.slope.value, next = omega - step;
    ((now.value > 0) == (above > 0) ? high : low) = std::move(at);
    omega = low.omega < next && next < high.omega ? next : (low.omega + high.omega) / 2;
    if (std::abs(step) < 1e-4 * width || std::abs(now.value) < 4 * now.error) break;
  }

  // If that does not give eight digits, extended precision does
  Estimate zero = last_steps<double>(low, high, omega);
  if (!(zero.error < 1e-8)) zero = last_steps<Wide>(low, high, omega);
  if (!(zero.error < 1e-3 * width))
    throw std::runtime_error("no zero of the barrier is found near " + std::to_string(omega));
  return zero;
}

#define LIST(T) template void measure_in<T>(BreatherPair&);
LATTICE_IN_EACH_PRECISION(LIST)
#undef LIST

}  // namespace lattice
