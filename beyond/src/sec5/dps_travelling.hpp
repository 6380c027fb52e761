#pragma once
/**
# Travelling breathers of the DpS equation

$A_n(\tau+\tau_T) = e^{i\varphi}A_{n-1}(\tau)$ in Eq. (12). We choose $\tau_T = 2\pi$, and all others follow by
$A \to aA$, $\tau \to a^{-1/2}\tau$. With the symmetry $A_n(\tau) = -\bar A_{-n}(-\tau)$ and
$w_n = e^{-i\varphi/2}A_n(\tau_T/2)$ the equations are
$$\mathrm{Re}\,(w_n + w_{1-n}) = 0,\qquad \mathrm{Im}\,(w_n - w_{1-n}) = 0,\qquad n = 1,\dots,L+1.$$
Those of the first kind add up to $V\sin(\varphi/2) = 0$, where the conserved sum $\sum_nA_n$ is $iV$. That of $n = 1$
is left out; what is found is exact where it holds too, and so at $\varphi = 0$. */

#include <complex>
#include <cstddef>
#include <numbers>

#include "lattice/dps/evolve.hpp"
#include "lattice/orbits/newton.hpp"

namespace lattice {

/// The unknowns x are the imaginary part of A_0 and then real and imaginary parts of A_1 to A_L at tau = 0.
struct DpsTravelling {
  std::size_t half_length = 8;  ///< L
  double phase = 0;             ///< varphi
  double tolerance = 1e-13;     ///< of the integrator
  static constexpr double shift_time = 2 * std::numbers::pi;

  /// The field at tau = 0, sites -L to L + 1.
  Field expand(const Vector<double>& x) const {
    Field a(2 * half_length + 2);
    a[half_length] = {0, x[0]};
    for (std::size_t n = 1; n <= half_length; ++n) {
      const double re = x[2 * Eigen::Index(n) - 1], im = x[2 * Eigen::Index(n)];
      a[half_length + n] = {re, im};
      a[half_length - n] = {-re, im};
    }
    return a;
  }
  /// Carries a field over some slow time, by GSL.
  void flow(Field& a, double time) const {
    evolve_dps(Dps{a.size()}, a, time, 1,
               Tolerance(1e-4 * tolerance, tolerance, gsl_odeiv2_step_rk8pd),
               [](double, const Field&) {});
  }
  /// All equations, that of n = 1 first.
  Vector<double> residuals(const Vector<double>& x) const {
    Field a = expand(x);
    flow(a, shift_time / 2);
    Vector<double> out(2 * Eigen::Index(half_length) + 2);
    for (std::size_t n = 1; n <= half_length + 1; ++n) {
      const auto w = std::polar(1.0, -phase / 2) * a[half_length + n],
                 u = std::polar(1.0, -phase / 2) * a[half_length + 1 - n];
      out[2 * Eigen::Index(n) - 2] = w.real() + u.real();
      out[2 * Eigen::Index(n) - 1] = w.imag() - u.imag();
    }
    return out;
  }

  /// All but the first, for Newton's method, in units of the largest unknown. Central differences decide only how
  /// fast it converges.
  Equations<double> equations() const {
    const auto seen = [*this](const Vector<double>& x) -> Vector<double> {
      return residuals(x).tail(x.size());
    };
    return by_differences("travelling orbit of the DpS equation", seen, 1e-6);
  }
};

/// A solution: its unknowns, field at tau = 0, V and norm.
struct DpsMember {
  Vector<double> x;
  Field field;
  double V, norm;
};

/// The one near the unknowns `guess`. Throws NewtonFailed.
DpsMember dps_member(const DpsTravelling& problem, const Vector<double>& guess);

/// A guess for phase 0: unknowns cut from the packet of a struck chain of spheres, behind site `from`, at the instant
/// when its front and its back have the most nearly equal moduli. Throws std::runtime_error if no packet passes.
Vector<double> cut_dps_packet(double from, std::size_t half_length);

}  // namespace lattice
