#pragma once
/**
# Even functions on panels that end where contacts open

The wave of the kernel equation (kernel_wave.hpp) is an even function $d(t)$ that falls
double-exponentially, and what is integrated is $f = d_+^\alpha$, which is not smooth where $d$ passes
through zero. The kernel in turn has kinks at $0$ and $\pm T$, so that $d$ inherits in $t \pm T$ the
weaker singularities of what $f$ does in $t$. All of this falls on the ends of panels if the set of
these ends contains the zeros of $d$ and is mapped onto itself by $t \to t + T$ and $t \to -t$. So the
cuts are given in $[0, T/2]$, reflected to $[0, T]$ and repeated.

Inside a panel of length $\ell$ the time is $t = a + \ell\,w(x)$, $0 < x < 1$, with a polynomial $w$
that has a multiple zero at either end, $w = x^2(3-2x)$ or $x^3(10-15x+6x^2)$. A power $(t-a)^{3/2}$
then becomes $x^3$ times an analytic function, and the nodes and weights of Gauss integrate it
spectrally. */

#include <cstddef>
#include <vector>

#include "lattice/algebra/dense.hpp"

namespace lattice {

/**
What is the same for all panels: Gauss's nodes in $(0,1)$, their weights, the integrals from $0$ to each
node, and the map $w$ with its derivative. */
struct QuadraturePanel {
  /// With this many nodes; `order` is that of the zeros of w, 2 or 3.
  QuadraturePanel(std::size_t nodes, std::size_t order);

  std::size_t nodes, order;
  Vector<double> x, weight, lagrange;  ///< nodes, weights of Gauss, barycentric weights
  Matrix<double> integral;             ///< (i, j): integral of Lagrange polynomial j from 0 to x_i
  /// w(x).
  double map(double x) const;
  /// w'(x).
  double slope(double x) const;
  /// The x with map(x) = u.
  double inverse(double u) const;
  /// The polynomial through `values` at the nodes, at x.
  double interpolate(const double* values, double x) const;
};

/**
A grid of the half line. Functions on it are vectors of their values at the nodes. */
class HalfLine {
 public:
  /// Cuts in [0, T/2], sorted, the first 0 and the last T/2; `periods` shift times are covered.
  HalfLine(double shift_time, std::vector<double> cuts, std::size_t periods,
           const QuadraturePanel& panel);

  /// How many nodes there are.
  Eigen::Index size() const { return t_.size(); }
  double shift_time() const { return shift_time_; }
  std::size_t periods() const { return periods_; }
  /// The nodes, ascending from t = 0.
  const Vector<double>& t() const { return t_; }
  /// Weights of the integral over the half line.
  const Vector<double>& weight() const { return weight_; }
  /// Integral of an even function over the whole line.
  double integral(const Vector<double>& values) const { return 2 * weight_.dot(values); }

  /// The function at a time t, zero beyond the grid.
  double at(const Vector<double>& values, double t) const;
  /// The function on another grid.
  Vector<double> onto(const HalfLine& other, const Vector<double>& values) const;

  /**
  A force $f$ acts at a resting oscillator of frequency one, and the response that vanishes in the future
  is $X(t) = \int_t^\infty \sin(s-t)\,f(s)\,ds$. Its integrals run from the far end inwards, so that the
  digits of the tail are not lost in sums of what is larger. */
  struct Response {
    Vector<double> x;                  ///< X at the nodes
    std::vector<double> half, half_v;  ///< X and its derivative at T/2, 3T/2, ...
    double component;                  ///< the integral of f cos t over the whole line
  };
  /// The response to the force with these values at the nodes.
  Response respond(const Vector<double>& f) const;

  /// X(t+T) - 2 X(t) + X(|t-T|) + component * sin(T - t) for t < T (kernel_wave.hpp).
  Vector<double> convolve(const Vector<double>& f) const;

 private:
  double shift_time_;
  std::size_t periods_, per_shift_;
  QuadraturePanel panel_;
  std::vector<double> start_, length_;
  Vector<double> t_, weight_, jacobian_, cosine_, sine_;
};

}  // namespace lattice
