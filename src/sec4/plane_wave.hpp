#pragma once
/**
# Exact periodic waves and what becomes of a disturbance

A phonon (dispersion.hpp) is a wave of vanishing amplitude. There are also waves of finite amplitude that
keep their form: $y_n(t) = \varphi(\theta)$ with $\theta = qn - \omega t$ is a solution if $\varphi$ has
the period $2\pi$ and
$$\omega^2\varphi'' + W'(\varphi) = V'(r) - V'(r^-), \qquad
  r(\theta) = \varphi(\theta+q) - \varphi(\theta),\quad r^-(\theta) = r(\theta-q).$$
For an even well $\theta\to-\theta$, $\varphi\to-\varphi$ leaves this equation unchanged, so we look for
odd waves $\varphi = \sum_k b_k \sin k\theta$ with $b_1 = a$ given and the frequency unknown. As long as
all contacts stay closed everything is analytic, and the series converges geometrically.

A small disturbance $e^{iQn + \lambda t}p(\theta)$ of such a wave obeys a linear equation with
coefficients of period $2\pi$. With the shift $S p = p(\theta+q)$ and $B = e^{iQ}S - 1$ it is
$$(\lambda - \omega\partial_\theta)^2 p = -W''(\varphi)\,p - B^\dagger V''(r)\,B\,p,$$
an eigenvalue problem on a grid of $\theta$. The growth rate is the largest real part of $\lambda$. */

#include <cstddef>
#include <vector>

#include "lattice/model/chain.hpp"

namespace lattice {

/// An exact wave: wavenumber, frequency, and the coefficients of sin(k theta), k = 1, 2, ...
struct PlaneWave {
  double q = 0, omega = 0;
  std::vector<double> b{};

  /// phi(theta).
  double profile(double theta) const;
  /// Its derivative.
  double slope(double theta) const;
  /// r(theta).
  double relative(double theta) const { return profile(theta + q) - profile(theta); }
};

/// The exact wave of wavenumber `q` and amplitude `a` with this many `harmonics`, by Newton's method from
/// the phonon. Throws std::runtime_error if the method does not converge or if the wave opens a contact,
/// since the series would then no longer converge geometrically.
PlaneWave plane_wave(const Well& well, const Contact& contact, double q, double a,
                     std::size_t harmonics = 12);

/**
To let the wave run we need its displacements and velocities on a ring of beads, which must hold a whole
number of wavelengths. The first site is $n = 1$. */
/// The wave on a ring of `sites` beads at t = 0.
State<double> on_ring(const PlaneWave& wave, std::size_t sites);

/// The growth rate, 1 per unit of time, of the fastest disturbance of wavenumber Q, `modulation`. Throws
/// std::runtime_error if the eigenvalues do not converge.
double growth_rate(const PlaneWave& wave, const Well& well, const Contact& contact,
                   double modulation);

}  // namespace lattice
