#pragma once
/**
# The approximate breather

At small amplitude the profile $u_n$ of a breather is known approximately (quasi_continuum.hpp), Eqs. (18) to (20):
$$y_n(0) = 2\epsilon\,u_n,\qquad \epsilon = \bigl(2\tau_0(\omega_b-1)\bigr)^2.$$ */

#include <cstddef>

#include "lattice/model/chain.hpp"
#include "lattice/model/sites.hpp"

namespace lattice {

/// A bond-centred breather at t = 0: its central contact is compressed, as in Eq. (18), or stretched,
/// as it is half a period later.
enum class Phase { compressed, stretched };

/// The approximate breather of Eq. (20), at rest, and the same for contacts that are none of spheres. Throws
/// std::invalid_argument unless the exponent of the contact is above one.
State<double> ansatz(Centre centre, double omega, std::size_t sites,
                     Phase phase = Phase::compressed, const Contact& contact = Hertz{});

/// That of a chain: around a bond if it has an even number of sites.
inline State<double> ansatz(const Chain& chain, double omega, Phase phase) {
  return ansatz(chain.sites % 2 == 0 ? Centre::bond : Centre::site, omega, chain.sites, phase,
                chain.contact);
}

}  // namespace lattice
