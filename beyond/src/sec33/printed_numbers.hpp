#pragma once
/**
# Numbers of section 3.3, computed with a map of fixed steps

What would the article's programs have printed with a given method and a given number of steps per period? A
`Setting` collects the numbers that the article prints for $\omega_b = 1.1$, all computed of the map of these steps
(fixed_step.hpp): its own breathers, its own derivative, its own runs. */

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "lattice/orbits/breather.hpp"
#include "sec33/fixed_step.hpp"

namespace lattice {

/// What the article prints: relative to the amplitude, as energy, as anharmonicity, as velocity, in sites.
namespace printed {
inline constexpr double residual = 1.5e-9, barrier = 1.77e-11, s0_site = 0.05, s0_bond = 0.26,
                        threshold = 6.19e-6, weak_kick = 3e-6, jump = 2;
}

/// What five iterations leave, against the breather that it stands for.
struct Shifted {
  double sites;     ///< by how much it is shifted along the chain
  double share;     ///< of the difference, along the direction that the equations feel least
  double released;  ///< the residual when the iteration goes on along that direction too
};

/// One method with one number of steps, and what it gives.
struct Setting {
  static constexpr double omega_b = 1.1, period = 2 * std::numbers::pi / omega_b;
  Nystrom method;
  std::size_t steps = 0;
  bool is_long = false;    ///< also kicked, which takes long runs
  std::size_t sites = 17;  ///< around a site; one more around a bond
  double residual = 0, variation = 0, residual_differences = 0, variation_differences = 0;
  double barrier = 0;
  std::array<double, 2> off_circle{}, s0{}, s0_differences{};  // around a site, around a bond
  double pinned_at = std::nan(""), freed_at = std::nan("");    // the threshold is in between
  Creep path{};                                                // after the weak kick, if followed

  /// Verlet, Runge-Kutta of order four and two of order five, and a symplectic method of order four.
  static std::vector<Nystrom> methods();

  /// Five iterations from the DpS profile for the site-centred breather, as the article made them, with exact
  /// derivatives and with difference quotients.
  void measure_residual();
  /// What these iterations leave, for a map that is as accurate as the flow.
  Shifted shift_left() const;
  /// The energies of both breathers in the linear well and their multipliers in three wells.
  void measure_breathers();
  /// The kick that frees the bond-centred breather within 20000 periods: whether it lies within twelve per cent of the
  /// printed one and, if so, three halvings of that interval.
  void measure_threshold();
  /// The path of the site-centred breather after the weak kick, for five times `horizon` or until it is no longer, or not
  /// yet, two sites from its start at a time after `horizon`.
  void measure_jump();

  /// Between the two kicks; nan where only one of them is known.
  double threshold() const { return std::sqrt(pinned_at * freed_at); }
  /// The smaller of the distances of the four multipliers from +1.
  double least_off() const { return std::min(off_circle[0], off_circle[1]); }
  static constexpr double horizon = 2.5e5, horizons = 5;
};

/// Whether a value is within a share of the target.
bool is_near(double value, double target, double share = 0.1);

/// Which of the numbers come near the printed ones: within ten per cent for barrier and threshold, 0.03 for s_0, half a
/// site for the jump, and a factor of two for the residual, which is a size and not a value.
struct Near {
  bool residual, barrier, s0_site, s0_bond, threshold, jump;
  int count() const { return residual + barrier + s0_site + s0_bond + threshold + jump; }
};
Near near_printed(const Setting& at);

/// Whether a residual is the printed one but for a factor of two.
bool is_near_residual(double residual);

}  // namespace lattice
