#pragma once
/**
# Waves of the kernel equation

The chapter (sec5_kernel_equation.cpp) shows that travelling breathers of linear wells with $T = 2\pi k$ obey one
equation for the compression $d$ of a contact, with the force $f = d_+^\alpha$,
$$d = K * d_+^\alpha,\qquad K(\sigma) = -\sin|\sigma| \ \text{ for } |\sigma| \le T.$$

For even $d$ and any $T$ let $X(t) = \int_{|t|}^\infty \sin(s-|t|)\,f(s)\,ds$ and $V = \int f\cos
t\,dt$. Then $X$ falls as fast as $f$, and has a kink at zero, $\ddot X + X = f - V\delta$. We compute
$$d(t) = X(t+T) - 2X(t) + X(t-T) + V\sin(T-|t|)_{|t|<T}.$$
At $T = 2\pi k$ this is the kernel equation, since the last term is $VK(t)$, the response to the missing
pulse $V\delta$. It is also an exact travelling breather, of type II, if $V = 0$. */

#include <cstddef>
#include <vector>

#include "lattice/model/chain.hpp"
#include "lattice/model/contact.hpp"
#include "sec5/half_line.hpp"

namespace lattice {

/// How finely a wave is resolved: nodes of a panel, and the length of the longest panel.
struct WaveGrid {
  std::size_t nodes = 20;
  double longest = 0.5;
};

/// While a contact is closed: from when to when, and the largest compression at a node.
struct Closed {
  double from, to, most;
};

/// A wave that is even about t = 0, on the half line.
struct KernelWave {
  PowerContact law;
  HalfLine line;
  Vector<double> d;  ///< compressions at the nodes

  double shift_time() const { return line.shift_time(); }
  /// d_+^alpha at the nodes.
  Vector<double> force() const;

  /// The action A, the integral of d_+^(alpha + 1).
  double action() const;
  /// Q, which is A^(-(alpha - 1) / (alpha + 1)) where the kernel equation is solved.
  double quotient() const;
  /// V, the component of the force at the frequency of the wells.
  double component() const;
  /// By how much the kernel equation is missed, relative to the peak.
  double residual() const;

  /// Largest compression.
  double peak() const;
  /// The intervals with t >= 0 in which the contact is closed and the compression exceeds `least` of the
  /// peak. A contact that is closed where the grid ends counts as closed up to there; whether it opens again
  /// later is not known.
  std::vector<Closed> closed(double least) const;
  /// In how many intervals a contact is closed, as far as double precision can tell.
  std::size_t contacts() const;

  /**
  A lattice is made from the wave at the instant at which positions are odd and velocities even. */
  /// The sites -half_length, ..., half_length + 1 at that instant.
  State<double> state(std::size_t half_length) const;
  /// Velocity of the central site.
  double central_velocity() const;
  /// The energy of that lattice, Eq. (6).
  double energy() const;
};

/**
Newton's method takes the derivative $I - K f'(d)$, whose second part is compact, so that few steps of
the method of minimal residuals invert it. After each step the panels are cut anew where the contacts
open. Even functions contain neither a shift of time nor a change of the internal phase, with which the
derivative would be singular or nearly so. */
/// The x with x - K * (stiffness x) = right, up to `enough` of the norm of the right side. Throws
/// std::runtime_error if too many steps are needed.
Vector<double> solve_linearized(const HalfLine& line, const Vector<double>& stiffness,
                                const Vector<double>& right, double enough = 1e-11);

/// The wave with shift time T near `guess`. Throws std::runtime_error where Newton's method fails.
KernelWave newton_wave(const KernelWave& guess, double shift_time, const PowerContact& law,
                       const WaveGrid& grid = {});

/**
A first guess comes from a short ascent of the quotient that the theorem maximizes, among even functions. It begins
with pulses $2\pi - \pi/2k$ apart, a distance at which $k$ pulses support each other. The contact at $t
= 0$ is closed for one sign and open for the other. */
/// The wave with T = 2 pi k; `sign` is that of the central velocity.
KernelWave wave_of_type_one(std::size_t k, int sign, const PowerContact& law,
                            const WaveGrid& grid = {});

/// The wave of type II between the shift time of `start` and `to`, if V changes its sign on the way in
/// steps of `step`. Throws std::runtime_error if it does not.
KernelWave wave_of_type_two(KernelWave start, double to, double step, const WaveGrid& grid = {});

}  // namespace lattice
