#pragma once
/**
# Two families side by side

Site-centred and bond-centred breathers of one frequency, and the small difference of their energies, the barrier
(breather.hpp), at two resolutions. */

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "lattice/numerics/estimate.hpp"
#include "lattice/orbits/breather.hpp"
#include "sec3/article_chains.hpp"
#include "sec3/resolutions.hpp"

namespace lattice {

/// Two breathers of one frequency, site-centred first, and what was measured on them.
struct BreatherPair {
  double s = 0, omega = 0;               ///< anharmonicity of the wells, frequency of both
  std::array<Orbit<double>, 2> orbit{};  ///< site, bond
  std::array<Estimate, 2> energy{}, amplitude{};
  Estimate equal_frequency{}, equal_action{};  ///< the two barriers, E_site - E_bond
  Estimate slope{}, slope_action{};            ///< their derivatives with respect to omega
  std::vector<Shooting<double>> others{};      ///< both problems, if not those of `problem_of`

  /// The problem of one of the two.
  Shooting<double> problem(int k) const {
    return others.empty() ? problem_of(both_centres[k], omega, s) : others[std::size_t(k)];
  }
};

/// Measures at both tolerances in type T. Throws NewtonFailed.
template <class T>
void measure_in(BreatherPair& pair);
/// The same, with 64 bits where double precision does not give one of the barriers to 3 parts in a thousand.
void measure(BreatherPair& pair);
/// Both breathers of this frequency on the article's chains, measured so.
BreatherPair barriers_at(double omega_b, double s = 0);

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

/// The frequency between two pairs of opposite sign at which the barrier at equal frequency vanishes: Newton's method in
/// double precision, then two steps, one at each tolerance, that give its error; in extended precision if that is above
/// $10^{-8}$. Throws std::runtime_error if it is not known to a thousandth of the bracket.
Estimate frequency_of_zero(const BreatherPair& left, const BreatherPair& right);

}  // namespace lattice
