#pragma once
/**
# Travelling breathers of the DpS equation

$A_n(\tau+\tau_T) = e^{i\varphi}A_{n-1}(\tau)$ in Eq. (12), for contacts of any exponent $\alpha$; the article's is
$3/2$. We choose $\tau_T = 2\pi$, and all others follow by $A \to aA$, $\tau \to a^{1-\alpha}\tau$. With the symmetry
$A_n(\tau) = -\bar A_{-n}(-\tau)$ and $w_n = e^{-i\varphi/2}A_n(\tau_T/2)$ the equations are
$$\mathrm{Re}\,(w_n + w_{1-n}) = 0,\qquad \mathrm{Im}\,(w_n - w_{1-n}) = 0,\qquad n = 1,\dots,L+1.$$
Those of the first kind add up to $V\sin(\varphi/2) = 0$, where the conserved sum $\sum_nA_n$ is $iV$. Without the one
with $n = 1$ there was a member for every $\varphi$ that we tried, $-0.4$ to 3; it is exact where that one holds too. */

#include <complex>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>

#include "lattice/dps/dps_impact.hpp"
#include "lattice/orbits/newton.hpp"

namespace lattice {

/// The unknowns x are the imaginary part of A_0 and then real and imaginary parts of A_1 to A_L at tau = 0.
struct DpsTravelling {
  std::size_t half_length = 8;  ///< L
  double phase = 0;             ///< varphi
  double tolerance = 1e-13;     ///< of the integrator
  double alpha = 1.5;           ///< exponent of the contact force
  double size = 1;              ///< a field is known to the tolerance times 1e-4 of this
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
    evolve_dps(Dps{.sites = a.size(), .exponent = alpha}, a, time, 1,
               Tolerance(1e-4 * tolerance * size, tolerance, gsl_odeiv2_step_rk8pd),
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

/// A member of the family: its field at tau = 0, V, norm and energy.
struct DpsMember {
  double phase;      ///< varphi
  Vector<double> x;  ///< the unknowns
  Field field;
  double V, norm, energy;
};

/// The member near the unknowns `guess`. Throws NewtonFailed.
DpsMember dps_member(const DpsTravelling& problem, const Vector<double>& guess);

/// A guess for phase 0: unknowns cut from the packet of a struck chain of spheres, behind site `from`, at the instant
/// when its front and its back have the most nearly equal moduli. Throws std::runtime_error if no packet passes.
Vector<double> cut_dps_packet(double from, std::size_t half_length);

/**
With the shift time fixed the amplitude is about the power $b = 1/(\alpha-1)$ of a number. So the continuation to other
exponents is one in $b$, and shape and logarithm of the amplitude are extrapolated from the last two members. Towards
$\alpha = 1$ breathers become wide, and sites are added where the outermost ones move by more than a rounding error. */
/// The member of exponent `alpha` and angle `phase`, with its problem, in which the flow has the given tolerance.
/// Throws NewtonFailed where the branch cannot be followed.
std::pair<DpsTravelling, DpsMember> follow_dps_member(double alpha, double phase, double tolerance);

/// The same member again with two more sites on either side, at another tolerance.
std::pair<DpsTravelling, DpsMember> in_wider_window(const DpsTravelling& problem,
                                                    const DpsMember& member, double tolerance);

}  // namespace lattice
