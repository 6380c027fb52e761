#pragma once
/**
# Two families side by side

The energies of site-centred and bond-centred breathers agree to six digits or more, so their
difference is the hard part. A rung of the ladder holds the two breathers of one frequency and
what their comparison gives at two resolutions. */

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "lattice/numbers/estimate.hpp"
#include "lattice/orbits/breather.hpp"

namespace lattice {

/// What double precision is checked against: a 64-bit mantissa where the processor has one.
using Wide = long double;

/// Lengths of the article's chains; one site more around a bond.
constexpr std::size_t sites_of(Centre centre) {
  return centre == Centre::site ? 31 : 32;
}
inline constexpr Centre both_centres[] = {Centre::site, Centre::bond};
inline BreatherProblem<double> problem_of(Centre centre, double omega, double s = 0) {
  return breather_problem(centre, omega, s, sites_of(centre));
}

/// The rules of the two resolutions: tolerances 16 apart.
template <class T>
NewtonRule<T> rule(int coarser) {
  NewtonRule<T> out;
  out.landing.tolerance = T(128) * std::numeric_limits<T>::epsilon();
  if (coarser) out.landing.tolerance *= T(16);
  return out;
}

struct Rung {
  double s = 0, omega = 0;
  std::array<Orbit<double>, 2> orbit{};  ///< site, bond
  std::array<Estimate, 2> energy{}, amplitude{};
  Estimate equal_frequency{}, equal_area{}, slope{};
  bool wide = false;
};

/// All that two resolutions have to agree on. The coarser one starts a little beside the orbit, so
/// that it has to find its own way back.
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
      if (coarser) guess.x *= 1.0001;
      orbit[k] = refine(problem(both_centres[k]), guess, how);
    }
    gap = barrier(problem(Centre::site), orbit[0], orbit[1], how);
  }
};

/// A value at two resolutions. Comparison with quadruple precision shows errors of up to ten
/// tolerances of the energy, so that the error is not taken to be below sixteen, 2048 roundings of
/// `size`. A breather's E - A / T is stationary, and the barrier at equal area suffers less.
template <class T>
Estimate agree(const T& coarse, const T& fine, const T& size) {
  const T floor = T(2048) * std::numeric_limits<T>::epsilon() * magnitude(size);
  return {double(fine), double(magnitude<T>(fine - coarse) + floor)};
}

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

/// Whether a value is known to three parts in a thousand.
inline bool settled(const Estimate& e) {
  return e.error <= 3e-3 * std::abs(e.value);
}
/// Measures in double precision and, where that does not settle both barriers, in the wider type.
inline void measure(Rung& rung) {
  measure_in<double>(rung);
  if (!settled(rung.equal_frequency) || !settled(rung.equal_area)) measure_in<Wide>(rung);
}

/// One family at increasing frequencies, as far as it reaches.
inline std::vector<Orbit<double>> climb(Centre centre, double s,
                                        const std::vector<double>& omegas) {
  const auto problem = problem_of(centre, omegas.front(), s);
  std::vector<Orbit<double>> orbits{find_breather(problem)};
  Branch<double, BreatherProblem<double>> branch(problem, Along::omega, orbits.front(), 1);
  try {
    for (std::size_t k = 1; k < omegas.size(); ++k) orbits.push_back(branch.reach(omegas[k]));
  } catch (const NoBranch&) {
  }
  return orbits;
}

using Ladder = std::vector<Rung>;

/// The rung at a frequency between those of two others: in the coordinates of continuation.hpp the
/// branches are almost straight, and Newton's method starts from the point in between.
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
Between two rungs of opposite sign the barrier at equal frequency vanishes. Newton's method, with the
exact slope and kept between the rungs, finds the frequency; the last step is made with the
wider type. */
inline Estimate zero_between(const Rung& left, const Rung& right) {
  double low = left.omega, high = right.omega, omega = (low + high) / 2;
  const bool rises = right.equal_frequency.value > 0;
  Rung rung;
  for (int k = 0; k < 12; ++k) {
    rung = rung_between(left, right, omega);
    const auto& [site, bond] = rung.orbit;
    const double gap = site.energy - bond.energy;
    ((gap > 0) == rises ? high : low) = omega;
    const double next = omega - gap / (site.energy_omega - bond.energy_omega);
    if (std::abs(next - omega) < 1e-9) break;
    omega = next > low && next < high ? next : (low + high) / 2;
  }
  measure_in<Wide>(rung);
  const double step = rung.equal_frequency.value / rung.slope.value;
  if (!(std::abs(step) < 1e-6))
    throw std::runtime_error("the zero of the barrier near omega_b = " + std::to_string(omega) +
                             " was not found");
  return {rung.omega - step, std::abs(rung.equal_frequency.error / rung.slope.value) + 1e-15};
}

}  // namespace lattice
