#pragma once
/**
# All multipliers of one breather

`sec33_floquet multipliers --centre site --omega 1.1` prints all Floquet multipliers (floquet.hpp) with their
errors, those next to $+1$ first, for wells of any name (`--well pendulum`) and the contacts and masses of
`breather` (`--contact power --alpha 1.8`, `--precompression 1e-3 --omega 1.3`, `--mass-ratio 0.8 --omega 1.3`).
In Python this is `lattice.multipliers`. */

#include <complex>
#include <utility>
#include <vector>

#include "sec3/breather_options.hpp"
#include "sec33/exchange.hpp"

namespace lattice {

/**
The chapter tabulates multipliers under the same headings. */
/// Real and imaginary part, modulus, argument (rad), error.
Columns multiplier_columns();

/// Every multiplier with its error, the two of the time-translation pair first.
std::vector<std::pair<std::complex<double>, double>> multipliers_of(const Spectrum& all);

/// The command: which breather, its spectrum, its tables.
struct Multipliers : ChosenBreather {
  static constexpr Title title{"multipliers", "all Floquet multipliers of one breather"};

  /// Declares which breather.
  void parameters(Parameters& p);
  using Found = Spectrum;
  /// The spectrum of the breather, in two precisions. Throws UsageError, NewtonFailed, NoBranch.
  Found find() const;
  /// Rows `quantity,value,error,unit,kind,meaning,reason` for the pinning pair and the largest modulus.
  Table quantities(const Found& found) const;
  /// Every multiplier.
  Table profile(const Found& found) const;
  /// What the program prints.
  Table table() const { return profile(find()); }
};

}  // namespace lattice
