#pragma once
/**
# The exponents of a DpS breather with your own parameters

`sec33_dps_stability spectrum --centre bond --mu 1 --sites 32` prints all exponents (spectrum.hpp), two for each site:
first the two zeros of the phase, then the pinning pair, then the rest. With `--alpha 2` the contacts are not those of
spheres, and their force grows with the square of the overlap. */

#include "lattice/standing/spectrum.hpp"
#include "sec3/breather_options.hpp"

namespace lattice {

/// The eigenvalues of the contact matrix of a breather, in one precision.
template <class T>
ContactSpectrum<T> spectrum_of(Centre centre, const T& mu, std::size_t sites, double alpha = 1.5) {
  return contact_spectrum(stationary<T>(centre, mu, sites, alpha));
}

/// Each exponent from a long mantissa, with its distance from the one in double precision.
Table spectrum_table(Centre centre, double mu, std::size_t sites, double alpha = 1.5);

/// The command: which breather, its spectrum.
struct OneSpectrum : ChosenBreather {
  static constexpr Title title{"spectrum", "all exponents of a breather"};
  double mu = 1, alpha = 1.5;

  /// Declares which breather.
  void parameters(Parameters& p);
  /// What the program prints.
  Table table() const;
};

}  // namespace lattice
