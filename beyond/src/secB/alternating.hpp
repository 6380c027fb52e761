#pragma once
/**
# Contacts with two exponents in turn

Let the contacts of a chain without wells alternate between two laws, $\delta^a$ and $\zeta\,\delta^b$. An
impact then sends out a pulse that leaves something behind at every second bead and loses energy, like the pulse of a
dimer chain, and for particular exponents it does not. With two exponents the chain has a scale of its own: if the
strengths of both laws are equal in SI units, then in units in which mass, impact velocity and the first law are one
$$\zeta = \frac{b+1}{a+1}\,\ell^{\,b-a},\qquad \ell^{a+1} = \frac{m v_0^2}{(a+1)A},$$
for potential energies $A\delta^{a+1}$ and $A\delta^{b+1}$ with displacements in metres. */

#include <cstddef>

namespace lattice {

/// Exponents of the forces, in the order of the contacts: `second`, `first`, `second`, ...
struct TwoExponents {
  double first, second;
  double length;  ///< the unit of length in metres
  /// zeta: the strength of the second law in units of the first.
  double strength_ratio() const;
};

/// Loss of energy of the pulse per site, from where it has passed `from` sites to `to`. `tolerance` is that of the
/// integrator. Throws std::runtime_error if GSL cannot go on.
double loss_per_site(const TwoExponents& law, std::size_t from, std::size_t to, double tolerance);

/// The second exponent, between `low` and `high`, at which nothing is lost: close to it the loss grows with the square of
/// the distance.
double lossless_exponent(TwoExponents law, double low, double high, std::size_t from,
                         std::size_t to, double tolerance);

}  // namespace lattice
