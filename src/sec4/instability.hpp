#pragma once
/**
# Growth of exact waves against the NLS equation

What the NLS equation says about the stability of a phonon (nls.hpp) holds in the limit of small
amplitude and slow modulations. An exact wave (plane_wave.hpp) of small amplitude $a$ has growth rates
too, eigenvalues whose computation knows nothing of the coefficient $\beta$ of that equation. To compare
the two we need the limit $a \to 0$. A quantity that is even in $a$ has an expansion in $a^2$: two
amplitudes remove the first correction, and the next pair gives the error. */

#include <cstddef>

#include "lattice/numerics/estimate.hpp"
#include "sec4/nls.hpp"

namespace lattice {

/// The value at zero amplitude of a quantity `of(a)` with an expansion in a^2, from a, a/2 and a/4.
template <class Of>
Estimate at_zero_amplitude(double a, Of of) {
  const double x = of(a), y = of(a / 2), z = of(a / 4);
  return compare((4 * y - x) / 3, (4 * z - y) / 3);
}

/**
A comparison belongs to a wavenumber and a compressed chain. According to the NLS equation the fastest
modulation grows at the rate $|h||A|^2$, so the eigenvalue times $\omega|\omega_2|/|A|^2$ is a measured
$\Phi$ (nls.hpp). This works only for $\Phi > 0$; otherwise the eigenvalues are imaginary. */
struct PhaseOfWave {
  double q, d, s;  ///< wavenumber, compression, anharmonicity

  /// What the NLS equation says.
  Coefficients<double> nls() const { return coefficients(q, d, s); }
  /// Growth rate of a modulation of the exact wave of amplitude `a`.
  double growth(double a, double modulation, std::size_t harmonics = 12) const;
  /// Phi from the growth at the amplitudes a, a/2 and a/4.
  Estimate phi_from_growth(double a) const;
};

/**
Not only slow modulations can grow: a modulation may have any wavenumber. We measure its growth in units of
$|h||A|^2$, the largest rate of the NLS equation, whether or not that is ever reached. */
/// That growth, of the exact wave of amplitude `a`.
double growth_over_nls(const PhaseOfWave& at, double a, double modulation,
                       std::size_t harmonics = 12);

/**
At the edges of the range of unstable wavenumbers we want to know whether any slow modulation grows.
Three of them are tried, around the scale $\sqrt{|h|a^2/(2|\omega''|)}$ of the fastest. */
/// The largest growth rate of three slow modulations, zero if none of them grows.
double slow_growth(const PhaseOfWave& at, double a, std::size_t harmonics = 12);

/**
At the edges of the band instability sets in where $s$ passes zero ($q = 0$) or a threshold ($q = \pi$). Two
identities, $\Phi(0) = -\frac32 s$ and $\Phi(\pi) = \frac32(s-s_\pi)$ with $s_\pi$ the threshold, are tested
over a range of wells, and exact waves of amplitude 0.005 for $s$ at 0.05 on either side of both, with six and with
twelve harmonics. */
struct BandEdges {
  Estimate formula,  ///< by how much the identities are missed
      growth,  ///< by which fraction the growth on the unstable side is not that of the NLS equation
      stable_side;  ///< the largest growth on the other side
};

/// For the threshold at q = pi in a chain of compression `d`.
BandEdges band_edges(double d, double threshold);

}  // namespace lattice
