#pragma once
/**
# Even functions on the line, enclosed

The wave of the kernel equation is an even function $d(t)$. The guess for it is made of cubic polynomials, one on
each cell of equal length $h$, with coefficients that are numbers of the format, and is zero from the last cell
on; at the ends of cells it may jump by a rounding. This file encloses what the equation asks of it: the integrals
of $f = d_+^{3/2}$ times $\cos t$ and $\sin t$ up to the end of every cell. Since the shift $T = 2\pi$ is a whole
number of cells, these integrals are all that the convolution with $K(\sigma) = -\sin|\sigma|$ needs:
$$(K*f)(t) = -c\sin t+s\cos t,\qquad c = 2C(t)-C(t-T)-C(t+T),\quad C(t) = \int_0^tf\cos s\,ds,$$
and $s$ likewise with $\sin s$. Its derivative is $-c\cos t-s\sin t$. */

#include <array>
#include <cstddef>
#include <vector>

#include "sec5/circle.hpp"

namespace lattice {

/// c_0 + c_1 x + c_2 x^2 + c_3 x^3 for 0 <= x <= 1.
using Cubic = std::array<double, 4>;

/// The values of a cubic for all x of an interval.
Interval<double> value(const Cubic& c, const Interval<double>& x);
/// Those of its first derivative by x.
Interval<double> first_derivative(const Cubic& c, const Interval<double>& x);
/// Those of its second derivative.
Interval<double> second_derivative(const Cubic& c, const Interval<double>& x);

/// An even function. The number of cells on 2 pi is a power of two.
struct CubicLine {
  std::size_t per_turn;     ///< cells on 2 pi
  std::vector<Cubic> cell;  ///< from t = 0 on; zero behind the last

  /// The length h of a cell.
  Interval<double> step() const;
};

/**
Multiples of half a cell are angles of a table (circle.hpp). */
class Angles {
 public:
  /// For cells of length 2 pi / per_turn.
  explicit Angles(std::size_t per_turn) : table_(2 * per_turn) {}
  /// cos(j h / 2).
  Interval<double> cosine(std::size_t j) const;
  /// sin(j h / 2).
  Interval<double> sine(std::size_t j) const { return cosine(j + 3 * (table_.count() / 4)); }

 private:
  CosineTable table_;
};

/**
## The integrals of a cell

Where $d$ is certainly positive on a piece of length $\tau$, the trapezoidal rule with its first correction,
$$\int g\,dt = \tfrac\tau2(g_0+g_1)+\tfrac{\tau^2}{12}(g_0'-g_1')+\tfrac{\tau^5}{720}g''''(\xi),$$
has a remainder that is bounded from the derivatives of $d$ and of the power. Where $d$ may be zero the integrand is
between zero and its largest value. If neither is good enough, the piece is halved, and so pieces accumulate at
the instants at which a contact closes or opens. */
struct CellIntegrals {
  Interval<double> cosine{}, sine{};  ///< of f cos t and f sin t
  Interval<double> action{};          ///< of d_+^(5/2)
};

/// Bounds of the three integrals over one cell of the line.
CellIntegrals integrate(const CubicLine& d, std::size_t cell, const Angles& angles);

/// All cells together: C, S and the action from 0 to the beginning of each cell, and the convolution.
class ForceIntegrals {
 public:
  ForceIntegrals(const CubicLine& d, const Angles& angles);

  /// C between two nodes, 0 <= from <= to.
  Interval<double> cosine(std::size_t from, std::size_t to) const;
  /// S likewise.
  Interval<double> sine(std::size_t from, std::size_t to) const;
  /// The integral of d_+^(5/2) over the whole line.
  Interval<double> action() const;
  /// K * f at a node.
  Interval<double> image(std::size_t node) const;
  /// Its derivative there.
  Interval<double> image_slope(std::size_t node) const;

 private:
  using Wide = Interval<long double>;
  Wide at(const std::vector<Wide>& sums, long node, long sign) const;
  Interval<double> around(const std::vector<Wide>& sums, std::size_t node, long sign) const;

  std::size_t per_turn_;
  const Angles& angles_;
  std::vector<Wide> cosine_{}, sine_{};
  Wide action_{};
};

}  // namespace lattice
