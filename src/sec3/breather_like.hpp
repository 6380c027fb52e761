#pragma once
/**
# A breather of any chain

A reader names a chain by a few beads in the middle, and the breather decides how long it has to be. Contacts may have
any exponent above one and be compressed, masses and stiffnesses differ. What the ansatz does not know is reached on a
path at fixed frequency (`continue_to`) from the breather of equal beads between contacts that are not compressed. */

#include <cstddef>
#include <stdexcept>
#include <string>

#include "lattice/orbits/breather.hpp"

namespace lattice {

/**
## The band

Beads that are compressed, or differ in mass, have linear vibrations of their own. Those of a chain that repeats
two beads of masses $\mu_{1,2}$ in wells of frequency one, with contacts of the stiffnesses $k_{1,2}$, are waves
of wavenumber $q$ per pair, and with $a = 1+k_1+k_2$ their frequencies obey
$$(a-\mu_1\omega^2)(a-\mu_2\omega^2) = k_1^2+k_2^2+2k_1k_2\cos q.$$
They form two bands. For equal beads these touch, $[1,\sqrt{1+4k}]$ with $k = \frac32\sqrt d$ between spheres,
and without compression each is a point $\mu^{-1/2}$. In a band a breather would radiate. We look for it above
both, where the contacts lift it and none of its harmonics meets a wave; there $\cos q = \cosh 2\rho > 1$, and
its tail falls like $e^{-\rho n}$. */
/// The waves that the two outermost beads of a chain would carry if they were repeated for ever.
struct PhononBands {
  double mass[2], k[2], well;  ///< of both beads and contacts, and the stiffness of the wells

  /// Those at the right end of a chain of at least four beads. Throws std::invalid_argument if small displacements grow
  /// instead of oscillating.
  explicit PhononBands(const Chain& chain);
  /// The frequency of wavenumber 0 or pi, in the lower or in the upper band.
  double edge(bool upper, bool at_pi) const;
  double top() const { return edge(true, false); }
  /// The rate rho per site at which a tail decays, infinite without compression, zero at frequencies in a band.
  double decay(double omega) const;
  /// Both bands, `[1, 1.2] and [1.3, 1.5]`, as one where they touch; one number where a band is a point.
  std::string to_text() const;
};

/// Thrown if a breather would have a frequency that is not above the bands, or so little that its tail has no end.
struct InBand : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// The chain with its middle where it was and `sites` beads: beyond its ends the last two beads are repeated, and so
/// are their contacts. Throws std::invalid_argument if it has masses and another parity.
Chain lengthened(const Chain& chain, std::size_t sites);

/// As `fit_chain` of breather.hpp, for the wells, contacts and masses of a chain, which must be symmetric about its middle
/// and have free ends; contacts of spheres with equal beads give the same bits as there. Throws ShortChain, InBand,
/// NewtonFailed, NoBranch, and std::invalid_argument where `like` is no such chain.
Fitted fit_chain(Centre centre, double omega, const Chain& like, std::size_t sites,
                 std::size_t usual, double precision, Phase phase);

}  // namespace lattice
