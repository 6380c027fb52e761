#pragma once
/**
# The breathers of the chain, enclosed

In linear wells the compressions $d_n = y_n-y_{n+1}$ of a breather of frequency $\omega$ obey
$\ddot d_n+d_n = f_{n-1}-2f_n+f_{n+1}$ with $f_n = (d_n)_+^{3/2}$. As functions of $\theta = \omega t$ they
have the period $2\pi$, and where $\omega$ is not the inverse of an integer the left side can be inverted,
by the convolution $Gf(\theta) = \frac1{2\pi}\int g(\theta-\vartheta)f(\vartheta)\,d\vartheta$ with the
Fourier coefficients $G_k = 1/(1-\omega^2k^2)$. So
$$F(d)_n = d_n-G(f_{n-1}-2f_n+f_{n+1}) = 0$$
on the space of bounded sequences of continuous even functions. The left neighbour of contact 0 is $d_1$
around a bond and $d_0$ half a period later around a site. Conversely $y_n = G(f_{n-1}-f_n)$ turns any zero
of $F$ into a motion of the chain. In $C^0$ the map $F$ is continuously differentiable with
$DF(d)v = v-G(\Delta(av))$, $a = \frac32(d_+)^{1/2}$, and the supremum norm lets the proof see that a square
root is bad near zero and near zero only: what counts is an integral over time.

What the proof takes from analysis has a function for each constant, so that a test can hold it against what it bounds.
*/

#include <vector>

#include "lattice/model/sites.hpp"
#include "sec5/circle.hpp"
#include "sec5/contraction.hpp"

namespace lattice {

/// gamma, the mean of |g|: 2 / s - 1 with s = sin(pi / omega), 1 < omega < 2.
Interval<double> mean_of_kernel(const Interval<double>& omega);
/// pi / (omega s), which no |g| exceeds.
Interval<double> largest_of_kernel(const Interval<double>& omega);

/**
How fine the proof is made. More samples and harmonics make the residual smaller, more nodes and cells the bound
of the derivative. Every choice that `check` lets pass is right. */
struct Fineness {
  std::size_t contacts = 7;     ///< of the half chain, in the window
  std::size_t harmonics = 320;  ///< of the guess
  std::size_t samples = 65536;  ///< on the circle, for the Fourier coefficients of the forces
  std::size_t nodes = 32;       ///< on the half circle, for the inverse of the derivative
  std::size_t cells = 2048;  ///< on the half circle, on which the stiffness is taken to be constant

  /// Throws std::invalid_argument where spacings and cuts do not agree (fineness.hpp).
  void check() const;
};

/// The guess: cosine coefficients of the compressions of the contacts 0, 1, ... of the half chain.
struct ChainGuess {
  Centre centre = Centre::site;
  Interval<double> omega{};
  std::vector<std::vector<double>> c{};  ///< by contact, then by harmonic
};

/// The guess from Newton's method (breather.hpp), for omega = numerator / denominator. Throws
/// std::invalid_argument unless 1 < omega < 2.
ChainGuess chain_guess(Centre centre, int numerator, int denominator, const Fineness& fineness);

/**
## The residual

The Fourier coefficients of $f = (c_+)^{3/2}$ are computed from $M$ samples. The discrete ones contain those at $k+jM$
too. As $f'$ has bounded variation, $|f_k| \le V/(2\pi k^2)$, and integration by parts on each interval of contact gives
$V \le 3\int c_+^{1/2}|c''|\,d\theta$: of $f'' = \frac32c^{1/2}c''+\frac34c'^2c^{-1/2}$ the second term has the integral
$-\frac32\int c^{1/2}c''$. So a coefficient of $\cos k\theta$ is at most $2V/(2\pi k^2)$; what is folded back has
$\sum_{j\ne0}(jM+k)^{-2} \le \frac{\pi^2}3(M-k)^{-2}$, and beyond the harmonics of the guess $|G_k| \le
k^{-2}/(\omega^2-K^{-2})$ for $k > K$. */
/// An upper bound of V / (2 pi); cosine sums are bounded by the sums of the moduli of their coefficients.
Interval<double> variation_of_force(const std::vector<double>& c);
/// The largest error of a coefficient below `harmonics`, over V / (2 pi).
Interval<double> folded_back(std::size_t samples, std::size_t harmonics);
/// Sum of |G_k| times the coefficients from `harmonics` on, over V / (2 pi).
Interval<double> left_out(const Interval<double>& omega, std::size_t harmonics);
/// Ranges of a cosine sum on equal cells of the half circle: from its ends and its second derivative.
std::vector<Interval<double>> ranges(const std::vector<double>& c, std::size_t cells);

/// sup |F(c)_n| for every contact of the window, and for the first behind it.
std::vector<double> chain_residuals(const ChainGuess& guess, const Fineness& fineness);

/**
## The inverse of the derivative

It is that of contraction.hpp with $B = G\Delta\tilde a$ and $m+1$ nodes on the half circle, so that $\epsilon =
\frac18(\pi/m)^2\sup|(Bv)''|$. The entries of $CNB$, a matrix of functions, are linear combinations of $g$, between two
nodes a combination of two sines, and we integrate their modulus from the values at the nodes. Behind the window rows
are bounded by $\gamma$ times the stiffness there. */
class ChainProof {
 public:
  /// Makes A and bounds it.
  ChainProof(const ChainGuess& guess, const Fineness& fineness);

  /// |A F(c)| in the supremum norm.
  double eta(const std::vector<double>& residuals) const;
  /// Bound of |1 - A DF(d)| over the ball.
  double q(double radius) const;

  const ApproximateInverse& inverse() const { return a_; }

 private:
  using Rows = std::vector<std::vector<Interval<double>>>;
  std::size_t window() const { return c_.size(); }
  double row(const std::vector<double>& of_contact, std::size_t n) const;
  void bound_operator(const ChainGuess& guess);
  Rows integrals(std::size_t contact) const;
  Rows matrix_of_nodes() const;
  double norm_of_row(const std::vector<double>& inverse) const;

  Centre centre_;
  Interval<double> omega_, gamma_, largest_g_;
  Fineness fine_;
  Rows kernel_;                                   ///< g at the nodes
  Rows c_{};                                      ///< range of the guess on every cell
  std::vector<std::vector<double>> stiffness_{};  ///< the constant on every cell
  ApproximateInverse a_{};
};

/**
## The breather

Behind the window $\delta_n = \sup|d_n|$ obeys $\sup_{m>n}\delta_m \le \gamma(\sup_{m\ge n}\delta_m)^{3/2} +
3\gamma(\sup_{m>n}\delta_m)^{3/2}$, and so $\sup_{m>n}\delta_m \le 2\gamma\,(\sup_{m\ge n}\delta_m)^{3/2}$ once
$3\gamma\sqrt{\delta} < \frac12$ there, less than a third of what is before it: the tail falls
double-exponentially, and what it adds to amplitude and energy is bounded by the ball. */
struct ChainBreather : Enclosure {
  Interval<double> amplitude;  ///< largest |y_n(0)|
  Interval<double> energy;
};

/// The breather of the chain in linear wells. Throws NotProved, and std::invalid_argument as the guess does.
ChainBreather enclose_chain(Centre centre, int numerator, int denominator,
                            const Fineness& fineness = {});

}  // namespace lattice
