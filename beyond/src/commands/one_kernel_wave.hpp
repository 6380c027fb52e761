#pragma once
/**
# One wave of the kernel equation with your own parameters

`sec5_kernel_equation wave --alpha 3 --sign minus` solves the kernel equation (kernel_wave.hpp) for one number $k$ of
oscillations a site, one sign of the central velocity and one exponent of the contacts, on two grids. */

#include <cstddef>

#include "report/program.hpp"

namespace lattice {

/// The command.
struct OneKernelWave {
  static constexpr Title title{
      "wave",
      "one solution of the kernel equation: an exact travelling breather in harmonic wells"};
  enum class Sign { plus = 1, minus = -1 };
  std::size_t k = 1;       ///< oscillations a site
  Sign sign = Sign::plus;  ///< of the central velocity
  double alpha = 1.5;      ///< exponent of the contacts

  /// Declares them.
  void parameters(Parameters& p);
  /// What the program prints.
  Table table() const;
};

}  // namespace lattice
