#pragma once
/**
# Growth of exact waves against the NLS equation

What the NLS equation says about the stability of a phonon (nls.hpp) holds in the limit of small
amplitude and slow modulations. An exact wave (plane_wave.hpp) of small amplitude $a$ has growth rates
too, eigenvalues whose computation knows nothing of the coefficient $\beta$ of that equation. To compare
the two we need the limit $a \to 0$. A quantity that is even in $a$ has an expansion in $a^2$: two
amplitudes remove the first correction, and the next pair gives the error. */

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "lattice/numbers/estimate.hpp"
#include "lattice/waves/nls.hpp"
#include "lattice/waves/plane_wave.hpp"

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
  double q, d, s;

  Coefficients<double> nls() const { return coefficients(q, d, s); }

  double growth(double a, double modulation, std::size_t harmonics = 12) const {
    const Quartic well{s};
    const CompressedHertz contact{d};
    return growth_rate(plane_wave(well, contact, q, a, harmonics), well, contact, modulation);
  }
  Estimate phi_from_growth(double a) const {
    const auto c = nls();
    return at_zero_amplitude(a, [&](double x) {
      return growth(x, fastest_modulation(c, x)) / (x * x / 4) * c.omega * std::abs(c.omega_2);
    });
  }
};

/**
Slow modulations are not all that can grow: a modulation may have any wavenumber. We measure its growth in
units of $|h||A|^2$, the fastest of the NLS equation, whether or not that is ever reached. */
inline double growth_over_nls(const PhaseOfWave& at, double a, double modulation,
                              std::size_t harmonics = 12) {
  return at.growth(a, modulation, harmonics) / (std::abs(at.nls().h()) * a * a / 4);
}

/**
At the edges of the range of unstable wavenumbers we want to know whether any slow modulation grows.
Three of them are tried, around the scale $\sqrt{|h|a^2/(2|\omega''|)}$ of the fastest. */
inline double slow_growth(const PhaseOfWave& at, double a, std::size_t harmonics = 12) {
  const auto c = at.nls();
  const double slow = std::sqrt(std::abs(c.h() * a * a / (2 * c.curvature)));
  double growth = 0;
  for (double m : {0.5, 1.0, 1.5}) growth = std::max(growth, at.growth(a, m * slow, harmonics));
  return growth;
}

}  // namespace lattice
