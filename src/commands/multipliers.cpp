#include "commands/multipliers.hpp"

namespace lattice {

Columns multiplier_columns() {
  return {number("real", "real part"), number("imag", "imaginary part"),
          number("modulus", "its modulus"), number("argument", "its argument", "rad"),
          number("error", "of the multiplier, from two tolerances")};
}

std::vector<std::pair<std::complex<double>, double>> multipliers_of(const Spectrum& all) {
  std::vector<std::pair<std::complex<double>, double>> out{{1, 0}, {1, 0}};
  for (const Pair& pair : all.pairs)
    for (int sign : {1, -1})
      out.emplace_back(multiplier(pair.kappa, sign), pair.multiplier_error());
  return out;
}

void Multipliers::parameters(Parameters& p) {
  ChosenBreather::parameters(p);
  add_well(p);
  add_contacts(p);
  add_masses(p);
  p.add("sites", sites, "sites (default: as many as needed)", {3, 1000});
}

Multipliers::Found Multipliers::find() const {
  const Fitted chosen = find_chosen(*this, 1e-17);
  return spectrum<Wide>(chosen.problem, chosen.orbit);
}

/**
The pair that decides on stability is the one next to $+1$. */
Table Multipliers::quantities(const Found& found) const {
  Answers q;
  q.add_small(
      "kappa", found.kappa(), "",
      "(lambda + 1/lambda - 2)/4 of the pinning pair of multipliers; above 0 it is unstable");
  return q.table;
}

Table Multipliers::profile(const Found& found) const {
  Table out{multiplier_columns()};
  for (const auto& [z, error] : multipliers_of(found))
    out.add({z.real(), z.imag(), std::abs(z), std::arg(z), error});
  return out;
}

}  // namespace lattice
