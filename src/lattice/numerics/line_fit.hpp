#pragma once
/**
# Straight lines

Speeds and orders of convergence are slopes of lines $x = a + b\,t$ through measured points. The standard
error of a slope says how well it is known if the points follow a line; whether they do is another
question, which `bend` answers. */

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

/**
Do the points lie on a line? If they do, the slopes of their first and second half agree. */
/// By how much the slope of the second half exceeds that of the first, relative to the slope of all
/// points, with the sum of both standard errors. Throws std::invalid_argument if there are fewer than
/// six points.
Estimate bend(const std::vector<double>& t, const std::vector<double>& x);

/// The order of a power law, from its values `a` and `b` at two sizes: the slope on logarithmic axes, with the relative
/// errors of both added.
Estimate order_between(double large, const Estimate& a, double small, const Estimate& b);

}  // namespace lattice
