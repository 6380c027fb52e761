#pragma once
/**
# Two families side by side

Site-centred and bond-centred breathers of one frequency, and the small difference of their energies, the barrier
(breather.hpp), at two resolutions. */

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "lattice/numerics/estimate.hpp"
#include "lattice/orbits/breather.hpp"

namespace lattice {

/// What double precision is checked against: a 64-bit mantissa where the processor has one.
using Wide = long double;

/// The breather of frequency `omega` in quartic wells, on the chain that all pairs use.
inline Shooting<double> problem_of(Centre centre, double omega, double s = 0) {
  return breather_problem(centre, omega, s, sites_of(centre));
}

/// The rules of the two resolutions: the default tolerance of `EventTolerance`, or 16 times that if `coarser`.
template <class T>
NewtonRule<T> rule(int coarser) {
  NewtonRule<T> out;
  out.events.tolerance = T(128) * std::numeric_limits<T>::epsilon();
  if (coarser) out.events.tolerance *= T(16);
  return out;
}

/// The finer rule for the tail: every site to the same relative accuracy, and every contact event, however faint.
template <class T>
NewtonRule<T> scaled_rule() {
  NewtonRule<T> out = rule<T>(0);
  out.scaled = true;
  out.events.slowest_event = T(0);
  return out;
}

/// In what two breathers agree when their energies are compared: frequency, or action.
enum class Equal { frequency, action };

/// A barrier and its derivative with respect to the frequency.
struct Sloped {
  Estimate barrier, slope;
};

/// Two breathers of one frequency, site-centred first, and what was measured on them.
struct BreatherPair {
  double s = 0, omega = 0;               ///< anharmonicity of the wells, frequency of both
  std::array<Orbit<double>, 2> orbit{};  ///< site, bond
  std::array<Estimate, 2> energy{}, amplitude{};
  Estimate equal_frequency{}, equal_action{};  ///< the two barriers, E_site - E_bond
  Estimate slope{}, slope_action{};            ///< their derivatives with respect to omega
  bool wide = false;                           ///< whether extended precision was needed
  std::vector<Shooting<double>> others{};      ///< both problems, if not those of `problem_of`

  /// The problem of one of the two.
  Shooting<double> problem(int k) const {
    return others.empty() ? problem_of(both_centres[k], omega, s) : others[std::size_t(k)];
  }
  /// One of the two barriers.
  Sloped gap(Equal equal) const {
    if (equal == Equal::frequency) return {equal_frequency, slope};
    return {equal_action, slope_action};
  }
};

/**
The difference of the two is the error, but it may be small by chance. Comparison with quadruple precision shows errors
of the energy of up to ten tolerances, so the error is never below sixteen: 2048 roundings of `size`, which is the
energy or, where it is more, what 1/64 of the frequency changes of it. At equal action a quarter of the energy serves as
size: an orbit makes $E - \mathcal A/T_b$ stationary, and this barrier suffers less from an error of the orbit. */
/// `fine` with that error.
template <class T>
Estimate agree(const T& coarse, const T& fine, const T& size) {
  const T floor = T(2048) * std::numeric_limits<T>::epsilon() * magnitude(size);
  return {double(fine), double(magnitude<T>(fine - coarse) + floor)};
}

/// Measures at both tolerances in type T. Throws NewtonFailed.
template <class T>
void measure_in(BreatherPair& pair);

/// Whether a value is known to three parts in a thousand.
inline bool settled(const Estimate& e) {
  return e.error <= 3e-3 * std::abs(e.value);
}

/// The family of the breather of `problem` at increasing frequencies, as far as it reaches.
std::vector<Orbit<double>> breathers_at(Shooting<double> problem,
                                        const std::vector<double>& omegas);

/// Pairs at increasing frequencies.
using BreatherPairs = std::vector<BreatherPair>;

/// Frequencies: 1.005, then up to 2 in `count` equal steps from 1. For a soft well (s < 0), whose
/// branches fold, only up to 1.9, and from 1.8 on in steps a fifth as long.
std::vector<double> pair_frequencies(double s, int count);

/// Both families, of the site-centred and the bond-centred breather of `problems`, at these frequencies, as far as they
/// reach, each pair measured by `measure_pair`; `s` is only noted.
BreatherPairs breather_pairs_at(double s, const std::array<Shooting<double>, 2>& problems,
                                const std::vector<double>& omegas,
                                const std::function<void(BreatherPair&)>& measure_pair);

/// The frequency between two pairs of opposite sign at which the barrier vanishes: Newton's method in double precision,
/// then two steps, one at each tolerance, that give its error; in extended precision if that is above $10^{-8}$. Throws
/// std::runtime_error if it is not known to a thousandth of the bracket.
Estimate frequency_of_zero(const BreatherPair& left, const BreatherPair& right, Equal equal);

}  // namespace lattice
