#pragma once
/**
# All multipliers of one breather

`sec33_floquet multipliers --centre site --omega 1.1` prints all Floquet multipliers (floquet.hpp) with their
errors, those next to $+1$ first, for wells of any name (`--well pendulum`) and the contacts and masses of
`breather` (`--contact power --alpha 1.8`, `--precompression 1e-3 --omega 1.3`, `--mass-ratio 0.8 --omega 1.3`).
In Python this is `lattice.multipliers`. */

#include <cmath>
#include <complex>
#include <utility>
#include <vector>

#include "sec3/breather_options.hpp"
#include "sec3/exchange.hpp"
#include "sec3/resolutions.hpp"

namespace lattice {
using namespace report;

/// Every multiplier with its error, the two of the time-translation pair first.
inline std::vector<std::pair<std::complex<double>, double>> multipliers_of(const Spectrum& all) {
  std::vector<std::pair<std::complex<double>, double>> out{{1, 0}, {1, 0}};
  for (const MultiplierPair& pair : all.pairs)
    for (int sign : {1, -1})
      out.emplace_back(multiplier(pair.kappa, sign), pair.multiplier_error());
  return out;
}

/// The command: which breather, its spectrum, its tables.
struct Multipliers : ChosenBreather {
  static constexpr Title title{"multipliers", "all Floquet multipliers of one breather"};

  void parameters(Parameters& p) {
    ChosenBreather::parameters(p);
    add_well(p);
    add_contacts(p);
    add_masses(p);
    p.add("sites", sites, "number of sites (default: as many as needed)", {3, 1000});
  }
  /// The spectrum of the breather, in two precisions. Throws UsageError, NewtonFailed, NoBranch.
  Spectrum find() const {
    const Fitted chosen = find_chosen(*this, 1e-17);
    return spectrum<Wide>(chosen.problem, chosen.orbit);
  }
  /// What a shift along the chain does is said by the pair next to +1, whether the breather is stable by all of them.
  Table quantities(const Spectrum& found) const {
    Answers q;
    const MultiplierPair& pinning = found.pairs.front();
    const bool real = std::abs(pinning.kappa.imag()) <= pinning.radius();
    q.add_small(
        "kappa", real ? found.kappa() : undefined, "",
        "(lambda + 1/lambda - 2)/4 of the pinning (translational) pair of multipliers, the one "
        "nearest to +1; above 0 the breather is unstable, otherwise largest_modulus decides",
        "the pair nearest to +1 is half of a quadruplet: its kappa is not real");
    q.add("largest_modulus", found.largest_modulus(), "",
          "largest modulus of all multipliers; the breather is unstable if it exceeds 1 by more "
          "than its error");
    return q.table;
  }
  /// Every multiplier.
  Table profile(const Spectrum& found) const {
    Table out;
    for (const auto& [z, error] : multipliers_of(found))
      out.add({{"real", "real part", z.real()},
               {"imag", "imaginary part", z.imag()},
               {"modulus", "modulus of the multiplier", std::abs(z)},
               {"argument", "argument of the multiplier", std::arg(z), "rad"},
               {"error", "error of the multiplier, from two tolerances", error}});
    return out;
  }
  Table table() const { return profile(find()); }
};

}  // namespace lattice
