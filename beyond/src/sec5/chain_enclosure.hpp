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

The constants of $g$ are $\gamma = \frac1{2\pi}\int|g| = 2/s-1$ and $|g| \le \pi/(\omega s)$ with
$s = \sin(\pi/\omega)$, for $1 < \omega < 2$. */

#include <vector>

#include "lattice/model/sites.hpp"
#include "sec5/contraction.hpp"

namespace lattice {

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

The Fourier coefficients of $f = (c_+)^{3/2}$ are computed from $M$ samples. The discrete ones contain those at
$k+jM$ too. As $f'$ has bounded variation, $|f_k| \le V/(2\pi k^2)$, and integration by parts on each interval of
contact gives $V \le 3\int c_+^{1/2}|c''|\,d\theta$: of $f'' = \frac32c^{1/2}c''+\frac34c'^2c^{-1/2}$ the second term
has the integral $-\frac32\int c^{1/2}c''$. That bounds both what is folded back and what lies beyond the harmonics
of the guess. */
/// sup |F(c)_n| for every contact of the window, and for the first behind it.
std::vector<double> chain_residuals(const ChainGuess& guess, const Fineness& fineness);

/**
## The inverse of the derivative

On $m+1$ nodes of the half circle, functions are replaced by broken lines, an operation $\Pi$ of norm one.
Let $B = G\Delta\tilde a$ with a stiffness $\tilde a$ that is constant on small cells and zero behind the
window, $N$ the values at the nodes, $E$ the broken line through values, $\mathfrak B = NBE$, and $C$ a
matrix, an approximate inverse of $1-\mathfrak B$. We take
$$A = 1+ECNB, \qquad
  1-A(1-B) = (1-\Pi)B+E[1-C(1-\mathfrak B)]NB+ECNB(1-\Pi)B,$$
an identity. All its terms are small: $\|(1-\Pi)B\| \le \epsilon = \frac18(\pi/m)^2\sup|(Bv)''|$ and
$\|1-C(1-\mathfrak B)\| = \delta$. The norm of $CNB$, a matrix of functions, is at most $\beta$: its entries are
linear combinations of $g$, between two nodes a combination of two sines, and we integrate their modulus
from the values at the nodes. With $B_d$ for the stiffness of any $d$ in the ball
$$\|1-A\,DF(d)\| \le (1+\beta)(\epsilon+\|B_d-B\|)+\delta\|B\|$$
in the window. Behind it $A$ is the identity and rows are bounded by $\gamma$ times the stiffness there. */
class ChainProof {
 public:
  /// Makes A and bounds it.
  ChainProof(const ChainGuess& guess, const Fineness& fineness);

  /// |A F(c)| in the supremum norm.
  double eta(const std::vector<double>& residuals) const;
  /// Bound of |1 - A DF(d)| over the ball.
  double q(double radius) const;

  double inverse_excess() const { return inverse_excess_; }  ///< beta: |A| - 1
  double delta() const { return delta_; }                    ///< |1 - C (1 - B)| for the matrix
  double epsilon() const { return epsilon_; }                ///< what broken lines miss

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
  double inverse_excess_ = 0, delta_ = 0, epsilon_ = 0, norm_ = 0;
};

/**
## The breather

Behind the window $\delta_n = \sup|d_n|$ obeys $\sup_{m>n}\delta_m \le \gamma(\sup_{m\ge n}\delta_m)^{3/2} +
3\gamma(\sup_{m>n}\delta_m)^{3/2}$, and so $\sup_{m>n}\delta_m \le 2\gamma\,(\sup_{m\ge n}\delta_m)^{3/2}$ once
$3\gamma\sqrt{\delta} < \frac12$ there, less than a third of what is before it: the tail falls
double-exponentially, and what it adds to amplitude and energy is bounded by the ball. */
struct ChainBreather {
  Contraction<double> unique, exists;
  double inverse_excess, delta, epsilon, residual;
  Interval<double> amplitude;  ///< largest |y_n(0)|
  Interval<double> energy;
};

/// The breather of the chain in linear wells. Throws NotProved, and std::invalid_argument as the guess does.
ChainBreather enclose_chain(Centre centre, int numerator, int denominator,
                            const Fineness& fineness = {});

}  // namespace lattice
