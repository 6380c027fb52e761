#include "commands/one_profile.hpp"

#include <cmath>
#include <string>

namespace lattice {

Table OneProfile::table() const {
  const std::size_t length = sites ? sites : sites_of(centre, alpha);
  if (!fits(centre, length))
    throw UsageError("--sites: '" + std::to_string(length) +
                     "' does not fit this centre (allowed: " +
                     (centre == Centre::bond ? "even" : "odd") + " numbers)");
  const auto state = stationary<double>(centre, mu, length, alpha);
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

}  // namespace lattice
