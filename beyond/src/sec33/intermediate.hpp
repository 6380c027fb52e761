#pragma once
/**
# Intermediate breathers, centred neither on a site nor on a bond

Two exchanges of stability that lie close together on a cut through the plane of $\omega_b$ and $s$, one of the
site-centred and one of the bond-centred breather, are the ends of a family of breathers without a mirror: at the one
they are centred on the site, at the other on the bond. This file follows such a family by its centre (held.hpp). */

#include <array>
#include <string>
#include <vector>

#include "sec33/exchange.hpp"

namespace lattice {

/**
The order of the two exchanges tells whether the pinning pairs of both breathers are on the circle between them or neither
is. */
struct ExchangePair {
  std::array<Exchange, 2> found;  ///< site, bond
  Estimate width() const {
    const Estimate &site = found[0].place, &bond = found[1].place;
    return {bond.value - site.value, site.error + bond.error};
  }
  bool resolved() const { return std::abs(width().value) > width().error; }
  /// What both pinning pairs are between the two: stable, unstable, or unresolved where the width is below its error.
  std::string between() const {
    if (!resolved()) return "unresolved";
    return (width().value > 0) == (found[0].slope < 0) ? "stable" : "unstable";
  }
};

/// One of the family: Q, s or omega_b with and without its error, the energy, kappa of its pinning pair, and the largest
/// modulus of all multipliers.
struct Intermediate {
  double centre = 0;
  Wide parameter = 0, energy = 0;
  Estimate place{}, kappa{}, largest_modulus{};
};

/**
Only the tiny energy barrier between site and bond fixes the parameter, and in double precision the error of the
parameter exceeds the whole interval on which the family exists. So double precision only moves the breather to its
centre. From there extended precision solves for it twice and independently, with tolerances that differ by a factor of
sixteen. The error is their difference plus what the violation of symplecticity of the linearised flow makes of the
parameter. The orbit at one centre, moved to the next, is the guess there, and the guess of the parameter goes from one
exchange to the other like the square of a sine. */
/// The family at `count` - 1 centres between site and bond. Throws NewtonFailed.
std::vector<Intermediate> intermediate_breathers(const Cut& cut, const ExchangePair& ends,
                                                 int count);

/// Its energy between those of the symmetric breathers at the same parameters, hence at the same frequency: zero at the
/// site's, one at the bond's.
double energy_share(const Cut& cut, const ExchangePair& ends, const Intermediate& one);

}  // namespace lattice
