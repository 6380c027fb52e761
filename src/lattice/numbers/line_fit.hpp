#pragma once
/**
# Straight lines

Speeds and orders of convergence are slopes of lines $x = a + b\,t$ through measured points. The standard
error of a slope says how well it is known if the points follow a line; whether they do is another
question, which `bend` answers. */

#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "lattice/numbers/estimate.hpp"

namespace lattice {

/// A straight line through points: slope b, value a at t = 0, standard error of the slope.
struct Line {
  double slope = 0, intercept = 0, slope_error = 0;

  /// The slope with the error of the fit.
  Estimate estimate() const { return {slope, slope_error}; }
};

/**
The line of least squares. Throws std::invalid_argument if there are fewer than three points, or not as
many `x` as `t`. */
inline Line fit_line(const std::vector<double>& t, const std::vector<double>& x) {
  if (t.size() != x.size() || t.size() < 3)
    throw std::invalid_argument("a line fit needs at least three points");
  const double n = double(t.size());
  const double tm = std::accumulate(t.begin(), t.end(), 0.0) / n;
  const double xm = std::accumulate(x.begin(), x.end(), 0.0) / n;
  double tt = 0, tx = 0, rest = 0;
  for (std::size_t i = 0; i < t.size(); ++i) {
    tt += (t[i] - tm) * (t[i] - tm);
    tx += (t[i] - tm) * (x[i] - xm);
  }
  Line line{tx / tt, 0, 0};
  line.intercept = xm - line.slope * tm;
  for (std::size_t i = 0; i < t.size(); ++i)
    rest += std::pow(x[i] - line.intercept - line.slope * t[i], 2);
  line.slope_error = std::sqrt(rest / (n - 2) / tt);
  return line;
}

/**
Do the points lie on a line? `bend` returns by how much the slopes of their first and second half differ,
relative to the slope of all of them, with the sum of both standard errors. Throws std::invalid_argument
if there are fewer than six points. */
inline Estimate bend(const std::vector<double>& t, const std::vector<double>& x) {
  const auto half = std::ptrdiff_t(t.size() / 2);
  const auto part = [](auto from, auto to) { return std::vector<double>(from, to); };
  const Line all = fit_line(t, x);
  const Line first = fit_line(part(t.begin(), t.begin() + half), part(x.begin(), x.begin() + half));
  const Line second = fit_line(part(t.begin() + half, t.end()), part(x.begin() + half, x.end()));
  const double scale = std::abs(all.slope);
  return {(second.slope - first.slope) / scale, (first.slope_error + second.slope_error) / scale};
}

}  // namespace lattice
