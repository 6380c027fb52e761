#pragma once
/**
# One stationary breather of the DpS equation

`sec32_dps_profiles profile --centre bond --mu 1 --sites 20` prints a breather beside its quasi-continuum profile. A
bond-centred breather needs an even number of sites, a site-centred one an odd number. With `--alpha 2` the force of the
contacts grows with the square of the overlap. */

#include <cmath>

#include "lattice/standing/stationary.hpp"
#include "report/program.hpp"
#include "sec3/article_chains.hpp"
#include "sec3/breather_options.hpp"

namespace lattice {
using namespace report;

/// The command: centre, frequency, length and exponent; the table has a row for each site.
struct OneProfile : ChosenBreather {
  static constexpr Title title{"profile",
                               "one static DpS breather and its quasi-continuum approximation"};
  double mu = 1, alpha = 1.5;

  void parameters(Parameters& p) {
    add_centre(p);
    p.add("mu", mu, "frequency mu of the stationary DpS state", {1e-6, 1e6});
    p.add("sites", sites, "number of sites (default: 31 or 32, with other exponents as needed)",
          {2, 1e5});
    p.add("alpha", alpha, "exponent of the contact force, 3/2 for spheres", static_exponents());
  }
  Table table() const {
    const std::size_t length = sites ? sites : sites_of(centre, alpha);
    const auto state =
        on_chosen_chain(*this, [&] { return stationary<double>(centre, mu, length, alpha); });
    const bool spheres = alpha == 1.5;
    const double size = spheres ? mu * mu : std::pow(mu, 1 / (alpha - 1));
    Table out{count("n", "site", "site"), number("u", "stationary DpS breather"),
              number("quasi_continuum", "quasi-continuum profile")};
    for (std::size_t i = 0; i < length; ++i) {
      const long n = site_number(i, length);
      out.add({n, state.u[i],
               size * (spheres ? quasi_continuum(centre, n) : quasi_continuum(centre, n, alpha))});
    }
    return out;
  }
};

}  // namespace lattice
