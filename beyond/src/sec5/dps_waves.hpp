#pragma once
/**
# Plane waves of the DpS equation and their modulation

A wave $A_n = A\,e^{i(qn-\Omega\tau)}$ solves the DpS equation (dps.hpp) exactly, because all its contacts are
stretched equally. With $D = |2A\sin\frac q2|^{1/2}$ and the rate $\rho = D/(2\tau_0)$,
$$\Omega = -4\rho\,\sin^2\tfrac q2.$$
In the chain it has the frequency $1-\epsilon^{1/2}\Omega$, which is above the band for every $q$.

The chapter (sec5_experiment.cpp) derives the growth rate of a modulation and the band of those that grow. With $c =
\cos q$ the fastest one is $Q = \pi$ if $-\frac15<c<0$, and halfway between $1$ and $\cos Q_*$ in the cosine if
$c<-\frac15$. The square of the largest growth is $-4\rho^2c(1+5c)$, at most $\rho^2/5$, in the first case and
$-\frac{\rho^2}4(1+5c)(1-c)^2/(1-5c)$ in the second, which rises up to $\frac23\rho^2$ at $c = -1$. */

#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include "lattice/dps/evolve.hpp"
#include "lattice/numerics/estimate.hpp"

namespace lattice {

/// The wave of wavenumber q and modulus `amplitude`; T is double or long double.
template <class T>
struct DpsWave {
  T q, amplitude = 1;

  /// rho, per unit of slow time.
  T rate() const {
    using std::abs, std::sin, std::sqrt;
    return sqrt(abs(T(2) * amplitude * sin(q / T(2)))) / T(2 * tau_0());
  }
  /// Omega.
  T frequency() const {
    using std::sin;
    const T s = sin(q / T(2));
    return T(-4) * rate() * (s * s);
  }
  /// The growth rate of a modulation of wavenumber Q, zero if it does not grow exponentially.
  T growth(T Q) const {
    using std::cos, std::sqrt;
    const T c = cos(q), C = cos(Q);
    const T square = (T(1) + T(5) * c) * (T(1) - C) * ((T(5) * c - T(1)) * C - (T(1) + T(3) * c));
    return square > T(0) ? rate() * sqrt(square) / T(2) : T(0);
  }
  /// Whether any modulation grows exponentially.
  bool unstable() const {
    using std::cos;
    return cos(q) < T(0) && cos(q) != T(-1) / T(5);
  }
  /// The edge Q_* of the band, not a number if there is no band.
  T edge() const {
    using std::acos, std::cos;
    const T c = cos(q);
    return unstable() ? acos((T(1) + T(3) * c) / (T(5) * c - T(1)))
                      : std::numeric_limits<T>::quiet_NaN();
  }
  /// The modulation that grows fastest, not a number if none grows.
  T fastest() const {
    using std::acos, std::cos;
    if (!unstable()) return std::numeric_limits<T>::quiet_NaN();
    return cos(q) > T(-1) / T(5) ? std::numbers::pi_v<T> : acos((T(1) + cos(edge())) / T(2));
  }
};

/// A quantity of the wave q. Formulas have no step to halve, so their error is the difference of two precisions.
template <class Of>
Estimate in_two_precisions(double q, Of of, double amplitude = 1) {
  return with_error(double(of(DpsWave<double>{q, amplitude})),
                    double(of(DpsWave<long double>{q, amplitude})));
}

/// A plane wave and a modulation that fit on a ring.
struct ModulatedWave {
  std::size_t sites;
  int waves, turns;  ///< periods of the wave and of the modulation on the ring

  /// The wave by itself, of modulus one.
  DpsWave<double> wave() const { return {around(waves)}; }
  /// Q.
  double modulation() const { return around(turns); }
  /// Re sigma.
  double growth() const { return wave().growth(modulation()); }
  /// The wave with its growing mode, x = size and y = (i Re sigma / rho - a) x / k. Throws std::invalid_argument if none
  /// grows.
  Field start(double size) const;

 private:
  double around(int k) const { return 2 * std::numbers::pi * k / double(sites); }
};

/// Growth of a modulation and frequency Omega of the wave, per unit of the slow time.
struct WaveRates {
  double growth = 0, frequency = 0;
};

/**
## The chain's own waves

A travelling wave of the chain, $y_n(t) = u(qn+\omega t)$, is in the state
of its neighbour after the time $q/\omega$ (James 2011 proves that such waves exist near those of the DpS equation).
On a ring of one period this is a problem for Newton's method: the state and $\omega$ are unknown, the component
$\frac1N\sum(y_n-i\dot y_n)e^{-iqn} = 2\epsilon$ is given, and least squares deal with the equation that the
conserved energy makes superfluous. The same map on a longer ring, linearised by differences, has eigenvalues
$\lambda$ and growth rates $\frac\omega q\ln|\lambda|$, at a cost that does not depend on $\epsilon$. */
/// A wave of the chain on a ring of one period, with its frequency.
struct ChainWave {
  State<double> state;
  double omega = 1;
};

/// The wave of the amplitude `eps`, with this many steps for the way to the neighbour's state. Throws
/// std::runtime_error if Newton's method does not converge.
ChainWave chain_wave(const ModulatedWave& wave, double eps, std::size_t steps);

/// The largest growth rate among all modulations that fit on the ring, and the frequency, per unit of the slow time.
WaveRates chain_rates(const ModulatedWave& wave, double eps, std::size_t steps);

/// The largest growth rate of the DpS equation on that ring.
double largest_growth(const ModulatedWave& wave);

}  // namespace lattice
