#pragma once
/**
# The phonon band and its instability, for any compression and well

`sec4_precompression_mi band` prints the edges of the band (phonons.hpp), its inflection, and the intervals of
wavenumbers whose phonons are modulationally unstable; `coefficients` evaluates everything that the NLS equation
(phonons.hpp) says about one wavenumber. */

#include <numbers>

#include "report/program.hpp"
#include "sec4/phonons.hpp"

namespace lattice {
using namespace report;

/**
The ranges exclude values at which a formula loses its digits or a run its meaning. */
struct Band {
  static constexpr Title title{
      "band", "phonon band: edges, inflection point and modulationally unstable wavenumbers"};
  double d = 0.5, s = -1.0 / 6;

  /// Declares compression and well.
  void parameters(Parameters& p) {
    p.add("d", d, "static compression d of the contacts", {1e-6, 100});
    p.add("s", s, "anharmonicity s of the quartic well", {-100, 100});
  }
  /// Edges, inflection, and where modulations grow.
  Table table() const;
};

/// The coefficients of the NLS equation for one carrier.
struct OneWavenumber : Band {
  static constexpr Title title{"coefficients",
                               "coefficients of the NLS equation at one wavenumber"};
  double q = std::numbers::pi / 4;

  /// Declares the wavenumber too.
  void parameters(Parameters& p) {
    p.add("q", q, "wavenumber q of the carrier phonon", {0, std::numbers::pi});
    Band::parameters(p);
  }
  /// Frequency, group velocity, and the coefficients of Eqs. (36) and (37).
  Table table() const;
};

}  // namespace lattice
