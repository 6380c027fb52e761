#pragma once
/**
# A modulated plane wave with your own parameters

`sec5_growth growth --q 2.5 --modulation 0.7` tells the frequency of a plane wave of the DpS equation (dps_waves.hpp), the
growth of one modulation, and the band of those that grow. Formulas have no step to halve, so their error is the
difference of two precisions. */

#include <numbers>

#include "report/program.hpp"

namespace lattice {

/// The command.
struct OnePlaneWave {
  static constexpr Title title{
      "growth",
      "plane wave of the DpS equation: its frequency and the growth rate of a modulation"};
  double q = std::numbers::pi;               ///< wavenumber of the wave
  double modulation = std::numbers::pi / 4;  ///< Q
  double amplitude = 1;                      ///< |A|

  /// Declares them.
  void parameters(Parameters& p);
  /// What the program prints.
  Table table() const;
};

}  // namespace lattice
