#pragma once
/**
# The waves of the kernel equation, enclosed

For $T = 2\pi$ the compression $d$ of an even travelling breather is a zero of
$$F(d) = d-K*d_+^{3/2},\qquad K(\sigma) = -\sin|\sigma| \text{ for } |\sigma| \le T, \text{ else } 0,$$
on the space of bounded even functions with the supremum norm. There $F$ is continuously differentiable with
$DF(d)v = v-K*(av)$, $a = \frac32(d_+)^{1/2}$. Of $K$ we use $|K| \le 1$, $\int|K| = 8$ and $\int K_+ = 4$. The
guess is made of cubics and ends after some shifts (cubic_line.hpp). */

#include <vector>

#include "sec5/contraction.hpp"
#include "sec5/cubic_line.hpp"

namespace lattice {

/**
How fine the proof is made. Every choice that `check` lets pass is right. */
struct WaveFineness {
  std::size_t per_turn = 16384;  ///< cells of the guess on 2 pi, a power of two
  std::size_t turns = 9;         ///< on which the guess is not zero
  std::size_t nodes = 64;        ///< for the inverse of the derivative on 2 pi, a power of two
  std::size_t window = 6;        ///< turns on which the inverse acts

  /// Throws std::invalid_argument where spacings and cuts do not agree (fineness.hpp).
  void check() const;
};

/// The guess from Newton's method (kernel_wave.hpp); `sign` is that of the central velocity.
CubicLine wave_guess(int sign, const WaveFineness& fineness);

/**
## The residual

At the nodes $R = F(c)$ is known from the integrals of the guess. On a cell of length $h$, with $R_0$ and $R_1$ at
its ends, $|R| \le \max(|R_0|,|R_1|)+\frac{h^2}8(|R_0''|+h\sup|R'''|)$, where
$$(K*f)'' = -K*f+f(t+T)-2f(t)+f(t-T)$$
and $f' = \frac32d_+^{1/2}d'$ is bounded on the cells at hand, since $d$ is a cubic there. Behind the guess,
$|R| = |K*f|$ is at most the integral of $f$ over the last shift. */
/// A bound of |F(c)| on each cell, and one for all times behind.
std::vector<double> wave_residuals(const CubicLine& d, const ForceIntegrals& integrals);

/**
## The inverse of the derivative

It is that of contraction.hpp with $B = K*\tilde a$. The shift is a whole number of distances of nodes, so that between
two nodes $K$ is a combination of two sines. As $|K| \le 1$, $\|B_d-B\|$ is at most the largest integral of $|a_d-\tilde
a|$ over two shifts, and the Hölder continuous root costs no more than an integral over the instants at which contacts
close and open. Behind the window rows are bounded by the integral of $a_d$ over two shifts around what lies there. */
class WaveProof {
 public:
  /// Makes A and bounds it.
  WaveProof(const CubicLine& d, const WaveFineness& fineness);

  /// |A F(c)| in the supremum norm.
  double eta(const std::vector<double>& residuals) const;
  /// Bound of |1 - A DF(d)| over the ball.
  double q(double radius) const;

  const ApproximateInverse& inverse() const { return a_; }

  using Rows = std::vector<std::vector<Interval<double>>>;
  /// 3/2 sqrt(d_+) in the middle of what it may be on each cell of the window; zero behind.
  const std::vector<double>& stiffness() const { return stiffness_; }
  /// NBE, the response of nodes to broken lines.
  Rows response() const;

 private:
  std::size_t cells_between_nodes() const { return fine_.per_turn / fine_.nodes; }
  double widest(const std::vector<double>& density, std::size_t first, double behind) const;
  Interval<double> kernel(long difference) const;
  void invert();

  WaveFineness fine_;
  Angles angles_;
  std::vector<Interval<double>> range_{};  ///< of the guess on each cell
  std::vector<double> stiffness_{};
  ApproximateInverse a_{};
};

/**
## The wave

In the ball, $|d| \le r$ behind the guess, and the largest $d_+$ beyond $t$ obeys $M(t+T) \le 4M(t)^{3/2}$. So it
falls double-exponentially once $4\sqrt r < 1$, and what it adds to the integrals is bounded by a geometric sum. At
$t = nT$ the sites have $\frac12(q^2+\dot q^2) = \frac12[(\int f\cos)^2+(\int f\sin)^2]$, integrals over one shift,
and this yields the energy. The action $A$ follows to second order in $r$: solutions are critical points of
$\frac12\int f(K*f)-\int fd+\frac25\int d_+^{5/2}$, with the value $-A/10$, in $f$ and $d$. With $I = \int a$ over
the ball,
$$|A-\tilde A| \le 5\sup|R|\int\tilde f+10\,r^2I(\tfrac32+\tfrac12I).$$ */
struct EnclosedWave : Enclosure {
  Interval<double> energy, peak, action;
};

/// The wave with k = 1 and this sign of the central velocity. Throws NotProved.
EnclosedWave enclose_wave(int sign, const WaveFineness& fineness = {});

}  // namespace lattice
