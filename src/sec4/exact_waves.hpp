#pragma once
/**
# Waves of finite amplitude, against the NLS equation

A phonon (phonons.hpp) is a wave of vanishing amplitude. There are also waves of finite amplitude that keep their form:
$y_n(t) = \varphi(\theta)$ with $\theta = qn - \omega t$ is a solution if $\varphi$ has the period $2\pi$ and
$$\omega^2\varphi'' + W'(\varphi) = V'(r) - V'(r^-), \qquad
  r(\theta) = \varphi(\theta+q) - \varphi(\theta),\quad r^-(\theta) = r(\theta-q).$$
For an even well $\theta\to-\theta$, $\varphi\to-\varphi$ leaves this equation unchanged, so we look for odd waves
$\varphi = \sum_k b_k \sin k\theta$ with $b_1 = a$ given and the frequency unknown. As long as all contacts stay closed
everything is analytic, and the series converges geometrically. Its frequency and the growth of its disturbances know
nothing of $\beta$. */

#include <cstddef>
#include <vector>

#include "lattice/integrators/integrate.hpp"
#include "lattice/numerics/estimate.hpp"
#include "report/program.hpp"
#include "sec4/phonons.hpp"

namespace lattice {

/// An exact wave: wavenumber, frequency, and the coefficients of sin(k theta), k = 1, 2, ...
struct PlaneWave {
  double q = 0, omega = 0;
  std::vector<double> b{};

  double profile(double theta) const;  ///< phi(theta)
  double slope(double theta) const;    ///< its derivative
  /// r(theta).
  double relative(double theta) const { return profile(theta + q) - profile(theta); }
};

/// The exact wave of wavenumber `q` and amplitude `a`, by Newton's method from the phonon. Throws std::runtime_error
/// if that does not converge or if the wave opens a contact, since the series would no longer converge geometrically.
PlaneWave plane_wave(const Well& well, const Contact& contact, double q, double a,
                     std::size_t harmonics = 12);
/// The wave at t = 0 on a ring that holds a whole number of wavelengths; the first site is n = 1.
State<double> on_ring(const PlaneWave& wave, std::size_t sites);

/**
A small disturbance $e^{iQn + \lambda t}p(\theta)$ of such a wave obeys a linear equation with coefficients of period
$2\pi$. With the shift $S p = p(\theta+q)$ and $B = e^{iQ}S - 1$ it is
$$(\lambda - \omega\partial_\theta)^2 p = -W''(\varphi)\,p - B^\dagger V''(r)\,B\,p,$$
an eigenvalue problem on a grid of $\theta$. The growth rate is the largest real part of $\lambda$. */
/// The growth rate, 1 per unit of time, of the fastest disturbance of wavenumber Q, `modulation`.
double growth_rate(const PlaneWave& wave, const Well& well, const Contact& contact,
                   double modulation);

/// The value at zero amplitude of a quantity `of(a)` with an expansion in a^2, from a, a/2 and a/4: two amplitudes
/// remove the first correction, and the next pair gives the error.
template <class Of>
Estimate at_zero_amplitude(double a, Of of) {
  const double x = of(a), y = of(a / 2), z = of(a / 4);
  return compare((4 * y - x) / 3, (4 * z - y) / 3);
}

/**
On the wave $y_n = a\sin(qn-\omega t)$, that is $|A| = a/2$, the modulation of wavenumber
$Q = (|h|a^2/2|\omega''|)^{1/2}$ grows fastest, by the NLS equation at the rate $|h||A|^2$. So the eigenvalue times
$\omega|\omega_2|/|A|^2$ is a measured $\Phi$ if it is positive; otherwise the eigenvalues are imaginary. */
struct PhaseOfWave {
  double q, d, s;  ///< wavenumber, compression, anharmonicity

  /// What the NLS equation says.
  Coefficients<double> nls() const { return coefficients(q, d, s); }
  /// Growth rate of a modulation of the exact wave of amplitude `a`.
  double growth(double a, double modulation, std::size_t harmonics = 12) const;
  /// Phi from the growth at the amplitudes a, a/2 and a/4.
  Estimate phi_from_growth(double a) const;
};

/// At the edges of the band Phi(0) = -3/2 s and Phi(pi) = 3/2 (s - threshold). Both are tested over a range of wells,
/// and by exact waves of amplitude 0.005 for s at 0.05 on either side, with 6 and with 12 harmonics.
struct BandEdges {
  Estimate formula,  ///< by how much the identities are missed
      growth,  ///< by which fraction the growth on the unstable side is not that of the NLS equation
      stable_side;  ///< the largest growth on the other side
};
/// For the threshold at q = pi in a chain of compression `d`.
BandEdges band_edges(double d, double threshold);

/// The mean frequency of the wave in a run over this number of periods: the phase of its own Fourier component turns by
/// -omega per unit of time.
double measured_frequency(const Method& method, const Chain& ring, const PlaneWave& wave,
                          double periods);
/// beta at zero amplitude from runs with two steps, by omega_nl^2 = omega^2 + beta a^2/2; `omega` is the linear
/// frequency.
Estimate measured_beta(const Chain& ring, double q, double omega);

/// The table of figure x07: beta from the frequency of exact waves on 48 beads, and Phi from the growth of their
/// modulations where these are slow: not at q = pi/2, where backscattered waves grow faster, and not within 0.05 of
/// q_c, where the curvature vanishes. Only the column `beta` comes from the formula.
void report_beta(Report& report);
/// The chain starts from a soliton: its largest distance from the ansatz of Eq. (35) up to t = eps^-2, and local orders.
void report_ansatz(Report& report);

}  // namespace lattice
