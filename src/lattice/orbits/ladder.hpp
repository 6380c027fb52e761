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
  Estimate equal_frequency{}, equal_area{};  ///< the two barriers, E_site - E_bond
  Estimate slope{}, slope_area{};            ///< their derivatives with respect to omega
  bool wide = false;                         ///< whether the wider type was needed
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

/**
Both barriers have derivatives that cost nothing. At equal frequency it is the difference of those of the
energies; at equal area $d\mathcal H = \omega\,d\mathcal A/2\pi$ along both families leaves
$(\omega_{site}/\omega_b-1)\,\mathcal H'_{bond}$, where $\omega_{site}$ is the frequency of the site-centred
breather of that area. */
template <class T>
void assess(Rung& rung, const Measured<T>& coarse, const Measured<T>& fine) {
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
  const auto slope_area = [&](const Measured<T>& m) {
    return m.orbit[1].energy_omega * (m.gap.omega_site / T(rung.omega) - T(1));
  };
  rung.slope_area = agree(slope_area(coarse), slope_area(fine), fine.orbit[1].energy_omega);
  rung.wide = sizeof(T) > sizeof(double);
}

/**
A rung is measured at both tolerances; a search, which asks again and again, takes one at a time. */
template <class T>
void measure_in(Rung& rung) {
  assess<T>(rung, {rung, 1}, {rung, 0});
}
template <class T>
void measure_once(Rung& rung, int coarser = 0) {
  const Measured<T> only(rung, coarser);
  assess<T>(rung, only, only);
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
Between two rungs of opposite sign a barrier vanishes. Its derivative is known with it, so that Newton's
method, kept between the rungs, finds the frequency in double precision in a few steps. */
inline Estimate zero_between(const Rung& left, const Rung& right, Estimate Rung::*gap) {
  const auto slope = gap == &Rung::equal_area ? &Rung::slope_area : &Rung::slope;
  const double below = (left.*gap).value, above = (right.*gap).value;
  const double width = right.omega - left.omega;
  double low = left.omega, high = right.omega, omega = low - below * width / (above - below);
  Rung at;
  const auto newton_step = [&] { return (at.*gap).value / (at.*slope).value; };
  for (int k = 0; k < 40; ++k) {
    at = rung_between(left, right, omega);
    measure_once<double>(at);
    (((at.*gap).value > 0) == (above > 0) ? high : low) = omega;
    const double step = newton_step(), next = omega - step;
    omega = low < next && next < high ? next : (low + high) / 2;
    if (std::abs(step) < 1e-4 * width || std::abs((at.*gap).value) < 4 * (at.*gap).error) break;
  }

  /**
  Two more steps are made with the wider type, one at each tolerance. The last of them, which is what the two
  tolerances and the curvature make of the zero, is its error, with that of the barrier there over its slope. */
  double step = 0;
  for (int coarser : {1, 0}) {
    at = rung_between(left, right, omega);
    measure_once<Wide>(at, coarser);
    step = newton_step();
    omega -= step;
  }
  if (!(std::abs(step) < 1e-3 * width))
    throw std::runtime_error("no zero of the barrier found near " + std::to_string(at.omega));
  return {omega, std::abs((at.*gap).error / (at.*slope).value) + std::abs(step) + 1e-15};
}

}  // namespace lattice
