#pragma once
/**
# The exponents of a DpS breather with your own parameters

`sec33_dps_stability spectrum --centre bond --mu 1 --sites 32` prints all exponents (spectrum.hpp), two for each site:
first the two zeros of the phase, then the pinning pair, then the rest. They are rates per unit of $\tau/(2\tau_0)$, the
time of Eq. (11). Each comes from a long mantissa, with its distance from the one in double precision. With `--alpha 2`
the force of the contacts grows with the square of the overlap. */

#include <cmath>
#include <complex>

#include "lattice/standing/spectrum.hpp"
#include "report/program.hpp"
#include "sec3/article_chains.hpp"
#include "sec3/breather_options.hpp"

namespace lattice {
using namespace report;

/// The unit of exponents in tables.
inline constexpr char rate_unit[] = "1 per unit of tau/(2 tau_0)";

/// The error of an exponent from that in double precision; the two zeros of the phase are exact.
inline double exponent_error(const std::complex<double>& z, const std::complex<double>& in_double) {
  if (z == 0.0 && in_double == 0.0) return 0;
  return Estimate{std::abs(z), std::abs(z - in_double)}.error;
}

/// The command: which breather, its spectrum.
struct OneSpectrum : ChosenBreather {
  static constexpr Title title{"spectrum",
                               "linear stability of one static DpS breather: all its exponents, "
                               "per unit of tau/(2 tau_0)"};
  double mu = 1, alpha = 1.5;

  void parameters(Parameters& p) {
    add_centre(p);
    p.add("mu", mu, "frequency mu of the breather", {1e-6, 1e6});
    p.add("sites", sites, "number of sites (default: 31 or 32, with other exponents as needed)",
          {8, 1001});
    p.add("alpha", alpha, "exponent of the contact force, 3/2 for spheres", static_exponents());
  }

  /// The exponents, computed in the type `T`. Throws UsageError.
  template <class T>
  auto find() const {
    return on_chosen_chain(*this, [&] {
      const std::size_t length = sites ? sites : sites_of(centre, alpha);
      return exponents(contact_spectrum(stationary<T>(centre, T(mu), length, alpha)));
    });
  }

  Table table() const {
    const auto coarse = find<double>();
    const auto fine = find<long double>();
    Table table{{number("real", "growth rate", rate_unit),
                 number("imag", "frequency in the rotating frame", rate_unit),
                 number("error", "difference from the value in double precision", rate_unit)}};
    for (std::size_t i = 0; i < fine.size(); ++i) {
      const std::complex<double> z(double(fine[i].first), double(fine[i].second));
      table.add({z.real(), z.imag(), exponent_error(z, {coarse[i].first, coarse[i].second})});
    }
    return table;
  }
};

}  // namespace lattice
