#include "commands/one_spectrum.hpp"

#include <cmath>

namespace lattice {

Table spectrum_table(Centre centre, double mu, std::size_t sites, double alpha) {
  const auto coarse = exponents(spectrum_of<double>(centre, mu, sites, alpha));
  const auto fine = exponents(spectrum_of<long double>(centre, mu, sites, alpha));
  Table table{
      {number("real", "growth rate", "1 per unit of time"),
       number("imag", "frequency in the turning frame", "1 per unit of time"),
       number("error", "distance from the value in double precision", "1 per unit of time")}};
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const double re = double(fine[i].first), im = double(fine[i].second);
    table.add({re, im, std::hypot(re - coarse[i].first, im - coarse[i].second)});
  }
  return table;
}

void OneSpectrum::parameters(Parameters& p) {
  add_centre(p);
  p.add("mu", mu, "frequency of the breather", {1e-6, 1e6});
  p.add("sites", sites, "chain length (default: 31 or 32, with other exponents as needed)",
        {8, 1001});
  p.add("alpha", alpha, "exponent of the contact force, 3/2 for spheres", static_exponents());
}

Table OneSpectrum::table() const {
  return on_chosen_chain(*this, [&] {
    return spectrum_table(centre, mu, sites ? sites : sites_of(centre, alpha), alpha);
  });
}

}  // namespace lattice
