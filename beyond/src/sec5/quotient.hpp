#pragma once
/**
# The quotient and its ascent

A wave of the kernel equation (kernel_wave.hpp) is where
$$Q(f) = \frac{\int f\,(K*f)\,dt}{\|f\|_p^2},\qquad f \ge 0,\qquad p = 1 + \frac1\alpha,$$
is largest. There $K*f = S f^{1/\alpha}$ wherever $f > 0$. So we write $f = u^\alpha$ with $u \ge 0$ and
repeat
$$u \leftarrow (K*u^\alpha + \mu u)_+$$
with the norm kept at one. Since $K$ is not positive, the step may go down if $\mu$ is too small; it is
then refused and repeated with twice the $\mu$. So the quotient never falls, and nothing but its growth
decides. The method needs the convolution and the weights of the integral, and no other property of the
grid. */

#include <cstddef>
#include <functional>
#include <vector>

#include "lattice/algebra/dense.hpp"
#include "lattice/model/contact.hpp"

namespace lattice {

/// K * f for the values of f on some grid.
using Convolution = std::function<Vector<double>(const Vector<double>&)>;

/// An ascent: u, K * u^alpha, and the quotient after every step that was taken.
struct Ascent {
  Vector<double> u, image;
  std::vector<double> quotients;

  /// The last and largest.
  double quotient() const { return quotients.back(); }
  /// Whether the last `over` steps gained less than `gain` of the quotient each, on average.
  bool rests(double gain, std::size_t over) const;
  /// The compression d = K * f of the wave whose force is a multiple of u^alpha.
  Vector<double> wave(const PowerContact& law) const;
};

/// Goes up from `u` until the ascent rests, or `most` steps are tried. A start whose quotient is not
/// positive is allowed, since only the growth counts.
Ascent ascend(const Convolution& convolve, const Vector<double>& weight, const PowerContact& law,
              Vector<double> u, double gain, std::size_t most, std::size_t over = 1);

/**
Random starts have no symmetry, so they live on a plain grid of the whole line, the interval of `shifts`
shift times with `per_shift` points in each. The trapezoidal sum with $K$ misses the kinks of $K$ at $0$
and $\pm T$; Euler and Maclaurin's formula says by how much, $h^2/12$ times the jumps of the derivative,
which are $-2$ and $1$. */
class PlainLine {
 public:
  /// The first point is t = 0.
  PlainLine(double shift_time, std::size_t shifts, std::size_t per_shift);

  /// The points of the grid.
  const Vector<double>& t() const { return t_; }
  /// The length of the interval.
  double length() const { return step_ * double(t_.size()); }
  /// Weights of the integral over the interval.
  Vector<double> weight() const { return Vector<double>::Constant(t_.size(), step_); }
  /// K * f at the points of the grid.
  Vector<double> convolve(const Vector<double>& f) const;

 private:
  std::size_t per_shift_;
  double step_;
  Vector<double> t_, cosine_, sine_;
};

/// A positive function that joins random values at `pieces` + 1 places by straight lines; the same one on
/// every grid of the same interval.
Vector<double> random_start(const PlainLine& line, std::size_t pieces, unsigned long seed);

/// When an ascent stops: after so many tries, or when `over` steps gained less than `gain` each, on average.
struct StopRule {
  double gain;
  std::size_t most, over;
};

/// Ascents on twelve shift times from `count` random starts, the seeds being 1, 2 and so on.
std::vector<Ascent> random_ascents(std::size_t count, double shift_time, std::size_t per_shift,
                                   const PowerContact& law, const StopRule& rule);

}  // namespace lattice
