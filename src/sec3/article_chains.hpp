#pragma once
/**
# The chains of section 3

The article's figures of breathers show 31 sites around a site, or 32 around a bond. */

#include <cstddef>
#include <string>

#include "lattice/model/sites.hpp"
#include "lattice/orbits/breather.hpp"
#include "lattice/standing/stationary.hpp"

namespace lattice {

/// As tables name it: site or bond.
inline std::string name_of(Centre centre) {
  return centre == Centre::bond ? "bond" : "site";
}

/// Default lengths of a chain: that of the article's figures; the shortest that holds a tail down to rounding up to
/// omega_b = 2; and one that is a little longer, for breathers that are kicked.
enum class Length { article, shortest, for_kicks };

/// The default length of a chain with this centre.
constexpr std::size_t sites_of(Centre centre, Length length = Length::article) {
  constexpr std::size_t site[] = {31, 21, 23}, bond[] = {32, 22, 22};
  return (centre == Centre::site ? site : bond)[std::size_t(length)];
}

/// The default length of a chain for a stationary state of the DpS equation with this exponent.
inline std::size_t sites_of(Centre centre, double alpha) {
  return sites_of(centre) + 2 * short_chain(alpha) - 2 * short_chain();
}

/// The breather of frequency `omega` in quartic wells, on the article's chain.
inline Shooting<double> problem_of(Centre centre, double omega, double s = 0) {
  return breather_problem(centre, omega, s, sites_of(centre));
}

}  // namespace lattice
