#pragma once
/**
# Lines and parabolas through samples

Speeds and orders of convergence are slopes of lines $x = a + b\,t$ through measured points. The parabola through a sample
and its two neighbours finds what lies between samples: an instant to second order in their distance, a largest value to
third. */

#include <vector>

#include "lattice/numerics/estimate.hpp"

namespace lattice {

/// A straight line through points: slope b, value a at t = 0, standard error of the slope.
struct Line {
  double slope = 0, intercept = 0, slope_error = 0;

  /// The slope with the error of the fit.
  Estimate estimate() const { return {slope, slope_error}; }
};

/// The line of least squares. Throws std::invalid_argument if there are fewer than three points, or not
/// as many `x` as `t`.
Line fit_line(const std::vector<double>& t, const std::vector<double>& x);

/// By how much the slope of the second half exceeds that of the first, relative to the slope of all points, with the sum
/// of both standard errors: whether the points follow a line at all. Throws std::invalid_argument if there are fewer than
/// six points.
Estimate bend(const std::vector<double>& t, const std::vector<double>& x);

/// The order of a power law, from its values `a` and `b` at two sizes: the slope on logarithmic axes, with the relative
/// errors of both added.
Estimate order_between(double large, const Estimate& a, double small, const Estimate& b);

/// The limit of at least three values whose distance from it is halved from each to the next, by the last two; its error is
/// the change without the last one, and what the errors of the values contribute.
Estimate limit_by_halving(const std::vector<Estimate>& values);

/// The parabola through three values at -1, 0 and 1, in units of the distance between samples.
struct Parabola {
  double middle;  ///< value at 0
  double slope;   ///< derivative at 0
  double bend;    ///< second derivative

  Parabola(double before, double here, double after)
      : middle(here), slope((after - before) / 2), bend(after - 2 * here + before) {}

  /// Where the vertex lies; there is none where `bend` is zero.
  double vertex() const { return -slope / bend; }
  /// The value at the vertex.
  double extremum() const { return middle + slope * vertex() / 2; }
};

}  // namespace lattice
