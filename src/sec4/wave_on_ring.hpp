#pragma once
/**
# Waves on a ring, measured

The theory of weakly nonlinear waves (nls.hpp) predicts two numbers that can be read off a run on a ring:
the mean frequency of an exact wave of wavenumber $q$ (plane_wave.hpp), from the phase of its first
Fourier component, and the rate at which a small modulation of wavenumber $Q$ grows, from the side band
$q + Q$. */

#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <vector>

#include "lattice/integrators/integrate.hpp"
#include "lattice/numerics/line_fit.hpp"
#include "sec4/plane_wave.hpp"

namespace lattice {

/// Fourier sum over the sites n = 1, 2, ... of y + i v / omega.
std::complex<double> fourier(const State<double>& state, double wavenumber, double omega);

/**
A frequency is an angle over a time. The phase of the wave's own component turns by $-\omega$ per unit of
time; we add up its changes from sample to sample over a number of periods, on a ring that holds a whole
number of wavelengths. */
template <class Stepper>
double measured_frequency(const Stepper& method, const Chain& chain, const PlaneWave& wave,
                          double periods) {
  State<double> state = on_ring(wave, chain.sites);
  const double time = 2 * std::numbers::pi * periods / wave.omega;
  double turned = 0, last = 0;
  evolve(method, chain, state, time, 0.5, [&](const State<double>& now) {
    const double phase = std::arg(fourier(now, wave.q, wave.omega));
    if (now.t > 0) turned += std::remainder(phase - last, 2 * std::numbers::pi);
    last = phase;
  });
  return -turned / time;
}

/**
From the shift of this frequency follows $\beta$, the coefficient of the NLS equation, without its
formula: a uniform wave of that equation has $\omega_{nl}^2 = \omega^2 + 2\beta|A|^2$, and the exact wave
has $a = 2|A|$. The linear frequency `omega` is that of Eq. (34). Two pairs of amplitudes lead to zero
amplitude (instability.hpp), and two steps in time give the error. */
Estimate measured_beta(const Chain& ring, double q, double omega);

/**
Growth can be seen in a run as well. A modulation with `turns` periods on the ring starts with a relative
amplitude of $10^{-6}$, and a line is fitted to the logarithm of the side band from four to eight times
1 / `expected`, when the growing part has left the decaying one behind. */
template <class Stepper>
double measured_growth(const Stepper& method, const Chain& chain, const PlaneWave& wave, int turns,
                       double expected) {
  State<double> state = on_ring(wave, chain.sites);
  const double modulation = 2 * std::numbers::pi * turns / double(chain.sites);
  for (std::size_t n = 0; n < chain.sites; ++n) {
    const double factor = 1 + 1e-6 * std::cos(modulation * double(n + 1));
    state.y[n] *= factor;
    state.v[n] *= factor;
  }
  std::vector<double> times, logs;
  evolve(method, chain, state, 8 / expected, 0.02 / expected, [&](const State<double>& now) {
    if (now.t < 4 / expected) return;
    times.push_back(now.t);
    logs.push_back(std::log(std::abs(fourier(now, wave.q + modulation, wave.omega))));
  });
  return fit_line(times, logs).slope;
}

}  // namespace lattice
