#pragma once
/**
# One travelling breather with your own parameters

`sec5_travelling_breathers orbit` computes one exact travelling breather (travelling.hpp), also in other
wells. At $s \ne 0$ the sum $Z$ no longer rotates freely, the shift time is an unknown, and we follow the
branch of orbits that begins at $s = 0$. If it folds before the $s$ that was asked for, the command says where.
In Python this is `lattice.travelling`. */

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "report/program.hpp"
#include "sec5/travelling.hpp"

namespace lattice {
using namespace report;

/// kappa of the phase and the largest modulus of the multipliers that do not lie near one.
template <class T>
std::pair<double, double> phase_and_rest(const Shooting<T>& problem, const Orbit<T>& orbit,
                                         const EventTolerance<T>& rule);

/// The command: which orbit, in two precisions, its tables.
struct OneOrbit {
  static constexpr Title title{"orbit", "one exact travelling breather"};
  std::size_t k = 1;                            ///< oscillations per site of an orbit of type I
  std::size_t half_length = usual_half_length;  ///< sites on either side of the centre
  std::string sign = "plus";                    ///< or minus, of the central velocity at t = 0
  double s = 0;                                 ///< anharmonicity of the wells
  std::optional<double> near{};                 ///< a shift time instead of k and s
  bool as_profile = false;                      ///< whether `table` is the profile

  /// Declares them.
  void parameters(Parameters& p);

  /**
  Whatever was asked for, the answer comes in two precisions, which give its error. */
  struct Found {
    Shooting<double> problem;
    Orbit<double> orbit;
    Shooting<long double> wide_problem;
    Orbit<long double> wide;
  };
  /// The orbit. Throws UsageError if there is none, NewtonFailed.
  Found find() const;
  /// Rows `quantity,value,error,unit,kind,meaning,reason`.
  Table quantities(const Found& found) const;
  /// The orbit at t = 0, in extended precision and rounded to double.
  Table profile(const Found& found) const;
  /// What the program prints.
  Table table() const;
};

}  // namespace lattice
