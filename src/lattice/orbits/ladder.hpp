#pragma once
/**
# Two families side by side

The energies of site-centred and bond-centred breathers of one frequency agree to six digits or more, and
the article wants their difference, the barrier (breather.hpp), from $\omega_b = 1$ to 2. So we follow both
families side by side. A rung of the ladder holds the two breathers of one frequency and what their
comparison gives at two resolutions. */

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "lattice/numbers/estimate.hpp"
#include "lattice/numbers/parallel.hpp"
#include "lattice/orbits/breather.hpp"

namespace lattice {

/**
All ladders use chains of the same length and two tolerances, and double precision is checked against a
wider type. */
/// What double precision is checked against: a 64-bit mantissa where the processor has one.
using Wide = long double;

/// Length of the article's chain (figure 4); one site more around a bond.
constexpr std::size_t sites_of(Centre centre) {
  return centre == Centre::site ? 31 : 32;
}
inline constexpr Centre both_centres[] = {Centre::site, Centre::bond};
inline BreatherProblem<double> problem_of(Centre centre, double omega, double s = 0) {
  return breather_problem(centre, omega, s, sites_of(centre));
}

/// The rules of the two resolutions: the default tolerance of `Landing`, or 16 times that if `coarser`.
template <class T>
NewtonRule<T> rule(int coarser) {
  NewtonRule<T> out;
  out.landing.tolerance = T(128) * std::numeric_limits<T>::epsilon();
  if (coarser) out.landing.tolerance *= T(16);
  return out;
}

/**
Two breathers of one frequency, site-centred first, and what was measured on them make a rung. */
struct Rung {
  double s = 0, omega = 0;
  std::array<Orbit<double>, 2> orbit{};  ///< site, bond
  std::array<Estimate, 2> energy{}, amplitude{};
  /// The two barriers, E_site - E_bond, and the slope of the first one along the frequency.
  Estimate equal_frequency{}, equal_area{}, slope{};
  bool wide = false;  ///< whether the wider type was needed
};

/**
Each resolution measures everything on a rung for itself. The coarser one starts slightly off the orbit, by
one part in a million, so that it has to find its own way back. */
template <class T>
struct Measured {
  std::array<Orbit<T>, 2> orbit;
  Barrier<T> gap;

  Measured(const Rung& rung, int coarser) {
    const NewtonRule<T> how = rule<T>(coarser);
    const auto problem = [&](Centre c) {
      return in_precision<T>(problem_of(c, rung.omega, rung.s));
    };
    for (int k : {0, 1}) {
      Orbit<double> guess = rung.orbit[k];
      if (coarser) guess.x *= 1.000001;
      orbit[k] = polish(problem(both_centres[k]), guess, how);
    }
    gap = barrier(problem(Centre::site), orbit[0], orbit[1], how);
  }
};

/**
The difference of the two is the error, but it may be small by chance. Comparison with quadruple precision
shows errors of the energy of up to ten tolerances, so we never take the error to be below sixteen: 2048
roundings of `size`. At equal area a quarter of the energy serves as size: an orbit makes
$E - \mathcal A/T_b$ stationary, and this barrier suffers less from an error of the orbit. */
template <class T>
Estimate agree(const T& coarse, const T& fine, const T& size) {
  const T floor = T(2048) * std::numeric_limits<T>::epsilon() * magnitude(size);
  return {double(fine), double(magnitude<T>(fine - coarse) + floor)};
}

/// Measures a rung in type T. Throws NoConvergence.
template <class T>
void measure_in(Rung& rung) {
  const Measured<T> fine(rung, 0), coarse(rung, 1);
  const T size = fine.orbit[1].energy;
  for (int k : {0, 1}) {
    const Orbit<T>&a = coarse.orbit[k], &b = fine.orbit[k];
    rung.energy[k] = agree(a.energy, b.energy, b.energy);
    rung.amplitude[k] = agree(a.amplitude, b.amplitude, b.amplitude);
  }
  rung.equal_frequency = agree(coarse.gap.equal_frequency, fine.gap.equal_frequency, size);
  rung.equal_area = agree<T>(coarse.gap.equal_area, fine.gap.equal_area, size / T(4));
  const auto slope = [](const Measured<T>& m) {
    return m.orbit[0].energy_omega - m.orbit[1].energy_omega;
  };
  rung.slope = agree(slope(coarse), slope(fine), fine.orbit[1].energy_omega);
  rung.wide = sizeof(T) > sizeof(double);
}

/**
A barrier is a small difference of two large numbers. We want it to three parts in a thousand, and if
double precision does not give that, the wider type measures again. */
/// Whether a value is known to three parts in a thousand.
inline bool settled(const Estimate& e) {
  return e.error <= 3e-3 * std::abs(e.value);
}
/// Measures in double precision and, if that does not settle both barriers, in the wider type.
inline void measure(Rung& rung) {
  measure_in<double>(rung);
  if (!settled(rung.equal_frequency) || !settled(rung.equal_area)) measure_in<Wide>(rung);
}

/**
A ladder is climbed along the two branches (continuation.hpp), so that there is never a doubt to which
family a breather belongs. A branch that turns back in frequency ends its ladder. */
/// One family at increasing frequencies, as far as it reaches.
inline std::vector<Orbit<double>> climb(Centre centre, double s,
                                        const std::vector<double>& omegas) {
  const auto problem = problem_of(centre, omegas.front(), s);
  std::vector<Orbit<double>> orbits{find_breather(problem)};
  Branch branch(problem, along_omega<BreatherProblem<double>>(), orbits.front(), 1);
  try {
    for (std::size_t k = 1; k < omegas.size(); ++k) orbits.push_back(branch.reach(omegas[k]));
  } catch (const NoBranch&) {
  }
  return orbits;
}

using Ladder = std::vector<Rung>;

/// Frequencies: 1.005, then up to 2 in `count` equal steps from 1. For a soft well (s < 0), whose
/// branches fold, only up to 1.9, and from 1.8 on in steps a fifth as long.
inline std::vector<double> ladder_frequencies(double s, int count) {
  std::vector<double> out{1.005};
  for (int k = 1; k <= count; ++k) out.push_back(1 + double(k) / count);
  if (s >= 0) return out;
  std::erase_if(out, [](double omega) { return omega > 1.8; });
  for (int k = 1; k <= count / 2; ++k) out.push_back(1.8 + 0.2 * double(k) / count);
  return out;
}

/**
The two families know nothing of each other until their rungs are measured, nor do the rungs; so first the
families and then the rungs are computed in parallel. */
/// Both families at these frequencies, as far as they reach, each rung measured by `measure_rung`.
template <class Measure>
Ladder climb_pairs(double s, const std::vector<double>& omegas, Measure measure_rung) {
  std::array<std::vector<Orbit<double>>, 2> families;
  parallel_for(2, [&](std::size_t k) { families[k] = climb(both_centres[k], s, omegas); });
  Ladder ladder;
  const auto& [site, bond] = families;
  for (std::size_t k = 0; k < std::min(site.size(), bond.size()); ++k)
    ladder.push_back({s, site[k].omega, {site[k], bond[k]}});
  parallel_for("branches", ladder.size(), [&](std::size_t i) { measure_rung(ladder[i]); });
  return ladder;
}

/**
A zero of the barrier lies between two rungs, and to find it we need more rungs there. In the coordinates
of continuation.hpp the branches are almost straight, so Newton's method starts from the point in
between. */
inline Rung rung_between(const Rung& left, const Rung& right, double omega) {
  Rung rung{left.s, omega};
  const auto scaled = [&](double from) { return std::pow((omega - 1) / (from - 1), 2); };
  const double part =
      std::log((omega - 1) / (left.omega - 1)) / std::log((right.omega - 1) / (left.omega - 1));
  for (int k : {0, 1})
    rung.orbit[k] = newton(problem_of(both_centres[k], omega, left.s),
                           Vector<double>((1 - part) * scaled(left.omega) * left.orbit[k].x +
                                          part * scaled(right.omega) * right.orbit[k].x));
  return rung;
}

/**
If a barrier has opposite signs on two rungs, it vanishes between them. Regula falsi closes in on that
frequency in double precision; an end of the bracket that stays has its value halved, so that it cannot
stay for ever. The last step is made with the wider type. The error of the zero is that of the barrier
there over its slope, plus a thousandth of the last step, since the slope is that of a chord. Throws
std::runtime_error if the search does not close in. */
inline Estimate zero_between(const Rung& left, const Rung& right, Estimate Rung::*gap) {
  Rung at;
  double low = left.omega, high = right.omega;
  double below = (left.*gap).value, above = (right.*gap).value, slope = 0;
  int stays = 0;
  for (int k = 0; k < 60; ++k) {
    slope = (above - below) / (high - low);
    const double omega = std::clamp(low - below / slope, low, high);
    at = rung_between(left, right, omega);
    measure_in<double>(at);
    const double value = (at.*gap).value;
    const bool beyond = (value > 0) == (above > 0);
    (beyond ? high : low) = omega, (beyond ? above : below) = value;
    const int side = beyond ? 1 : -1;
    if (stays == side) (beyond ? below : above) /= 2;
    stays = side;
    if (std::abs(value) <= 4 * (at.*gap).error || high - low < 1e-9) break;
  }
  measure_in<Wide>(at);
  const double step = (at.*gap).value / slope;
  if (!(std::abs(step) < 0.01 * (right.omega - left.omega)))
    throw std::runtime_error("no zero of the barrier found near " + std::to_string(at.omega));
  return {at.omega - step, std::abs((at.*gap).error / slope) + std::abs(step) * 1e-3 + 1e-15};
}

}  // namespace lattice
