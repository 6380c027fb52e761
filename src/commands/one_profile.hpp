#pragma once
/**
# One stationary breather of the DpS equation

`sec32_dps_profiles profile --centre bond --mu 1 --sites 20` prints a breather beside its quasi-continuum profile. A
bond-centred breather needs an even number of sites, a site-centred one an odd number. With `--alpha 2` the contacts are
not those of spheres, and their force grows with the square of the overlap. */

#include "lattice/standing/stationary.hpp"
#include "report/program.hpp"
#include "sec3/breather_options.hpp"

namespace lattice {

/// The command: centre, frequency, length and exponent; the table has a row for each site.
struct OneProfile {
  static constexpr Title title{"profile", "one breather beside its approximation"};
  Centre centre = Centre::site;
  double mu = 1, alpha = 1.5;
  std::size_t sites = 0;  ///< 0: as in the full run, or as wide as other exponents need

  /// Declares what a state depends on.
  void parameters(Parameters& p) {
    p.add("centre", centre, "where the breather is centred",
          {{"site", Centre::site}, {"bond", Centre::bond}});
    p.add("mu", mu, "frequency of the stationary state", {1e-6, 1e6});
    p.add("sites", sites, "chain length (default: 31 or 32, with other exponents as needed)",
          {2, 1e5});
    p.add("alpha", alpha, "exponent of the contact force, 3/2 for spheres", static_exponents());
  }
  /// Site, breather, approximation.
  Table table() const;
};

}  // namespace lattice
