#pragma once
/**
# Growth of exact waves against the NLS equation

What the NLS equation says about the stability of a phonon (nls.hpp) holds in the limit of small
amplitude and slow modulations. An exact wave (plane_wave.hpp) of small amplitude $a$ has growth rates
too, eigenvalues whose computation knows nothing of the coefficient $\beta$ of that equation. To compare
the two we need the limit $a \to 0$. A quantity that is even in $a$ has an expansion in $a^2$: two
amplitudes remove the first correction, and the next pair gives the error. */

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "lattice/numbers/criterion.hpp"
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

/**
## The statements of section 4.1

Four statements about the instability are decided by conditions (criterion.hpp). The coefficient $\beta$ is
confirmed if nothing that was measured is off by a thousandth. $\Phi$ is much smaller in linear wells if
its largest value is positive there and below a tenth of the others'. It changes its sign at the inflection
$q_c$ if bisection finds this place in every well and $\cos q_c = v_1(1-\cos q_c)^2$ holds there. */
/// From the largest relative distances of beta and of the growth from their formulas.
inline Criterion confirmed_beta(const Estimate& shift, const Estimate& growth) {
  return {below("shift", shift, 1e-3), below("growth", growth, 1e-3)};
}

/// From the largest Phi in soft, linear and hard wells, on a coarse and a fine grid of wavenumbers.
inline Criterion small_in_linear_wells(const std::array<double, 3>& coarse,
                                       const std::array<double, 3>& fine) {
  const auto ratio = [](const auto& x) { return x[1] / std::min(x[0], x[2]); };
  return {above("largest_s_0", compare(coarse[1], fine[1]), 0),
          below("ratio_s_0", compare(ratio(coarse), ratio(fine)), 0.1)};
}

/// For the place `q` in chains of compression `d` with each of the wells.
inline Criterion sign_changes_at(double q, double d, const std::array<double, 3>& wells) {
  const double x = 1 - std::cos(q);
  double apart = std::abs(std::cos(q) / (contact_series(d).v1 * x * x) - 1);
  for (double s : wells)
    apart = std::max(apart, std::abs(sign_change_of_phi(d, s, 0.9, 1.4) / q - 1));
  return {below("apart", compare(0.0, apart), 1e-10)};
}

/**
At the edges of the band instability sets in where $s$ passes zero ($q = 0$) or a threshold ($q = \pi$). Two
identities, $\Phi(0) = -\frac32 s$ and $\Phi(\pi) = \frac32(s-s_\pi)$ with $s_\pi$ the threshold, are tested
over a range of wells, and exact waves of amplitude 0.005 for $s$ at 0.05 on either side: with six and with
twelve harmonics modulations must grow on the unstable side, at the rate of the NLS equation within two per
cent, and not at all on the other, but for rounding. */
/// For the threshold at q = pi in a chain of compression `d`.
inline Criterion opens_at_edges(double d, double threshold) {
  const double a = 0.005, beside = 0.05, pi = std::numbers::pi;
  double formula = 0, leftover = 0;
  for (double s = -4; s <= 4; s += 0.25)
    formula = std::max({formula, std::abs(coefficients(0.0, d, s).phi + 1.5 * s),
                        std::abs(coefficients(pi, d, s).phi - 1.5 * (s - threshold))});
  Estimate apart{};
  for (const PhaseOfWave& phase : {PhaseOfWave{0, d, -beside}, {pi, d, threshold + beside}}) {
    const double nls = std::abs(phase.nls().h()) * a * a / 4;
    apart = larger(apart, compare(std::abs(slow_growth(phase, a, 6) / nls - 1),
                                  std::abs(slow_growth(phase, a) / nls - 1)));
  }
  for (const PhaseOfWave& phase : {PhaseOfWave{0, d, beside}, {pi, d, threshold - beside}})
    leftover = std::max(leftover, slow_growth(phase, a));
  return {below("formula", compare(0.0, formula), 1e-13), below("growth", apart, 0.02),
          below("stable_side", compare(0.0, leftover), 1e-12)};
}

}  // namespace lattice
