#pragma once
/**
# Waves of finite amplitude

A phonon (phonons.hpp) is a wave of vanishing amplitude. There are also waves of finite amplitude that keep their form:
$y_n(t) = f(\theta)$ with $\theta = qn - \omega t$ is a solution if $f$ has the period $2\pi$ and
$$\omega^2f'' + W'(f) = V'(r) - V'(r^-), \qquad
  r(\theta) = f(\theta+q) - f(\theta),\quad r^-(\theta) = r(\theta-q).$$
For an even well $\theta\to-\theta$, $f\to-f$ leaves this equation unchanged, so we look for odd waves
$f = \sum_k b_k \sin k\theta$ with $b_1 = a$ given and the frequency unknown. As long as all contacts stay closed
everything is analytic, and the series converges geometrically. Its frequency knows nothing of $\beta$. */

#include <complex>
#include <cstddef>
#include <vector>

#include "lattice/integrators/integrate.hpp"
#include "lattice/numerics/estimate.hpp"

namespace lattice {

/// An exact wave: wavenumber, frequency, coefficients of sin(k theta), k = 1, 2, ..., and the chain that carries it.
struct PlaneWave {
  double q = 0, omega = 0;
  std::vector<double> b{};
  Well well = Harmonic{};
  Contact contact = Hertz{};

  double profile(double theta) const;  ///< f(theta)
  /// r(theta).
  double relative(double theta) const { return profile(theta + q) - profile(theta); }
};

/// The exact wave of wavenumber `q` and amplitude `a`, by Newton's method from the phonon. Throws std::runtime_error
/// if that does not converge or if the wave opens a contact, since the series would no longer converge geometrically.
PlaneWave plane_wave(const Well& well, const Contact& contact, double q, double a,
                     std::size_t harmonics = 12);
/**
A small disturbance $e^{iQn + \lambda t}p(\theta)$ of such a wave obeys a linear equation with coefficients of period
$2\pi$. With the shift $S p = p(\theta+q)$ and $B = e^{iQ}S - 1$ it is
$$(\lambda - \omega\partial_\theta)^2 p = -W''(f)\,p - B^\dagger V''(r)\,B\,p,$$
an eigenvalue problem on a grid of $\theta$. The growth rate is the largest real part of $\lambda$. */
/// The growth rate, 1 per unit of time, of the fastest disturbance of wavenumber Q, `modulation`.
double growth_rate(const PlaneWave& wave, double modulation);

/// The value at zero amplitude of a quantity `of(a)` with an expansion in a^2, from a, a/2 and a/4: two amplitudes
/// remove the first correction, and the next pair gives the error.
template <class Of>
Estimate at_zero_amplitude(double a, Of of) {
  const double x = of(a), y = of(a / 2), z = of(a / 4);
  return with_error((4 * y - x) / 3, (4 * z - y) / 3);
}

}  // namespace lattice
