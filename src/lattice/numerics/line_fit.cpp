#include "lattice/numerics/line_fit.hpp"

#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>

namespace lattice {

Line fit_line(const std::vector<double>& t, const std::vector<double>& x) {
  if (t.size() != x.size() || t.size() < 3)
    throw std::invalid_argument("a line fit needs at least three points");
  // Slope and intercept from sums about the mean
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
  // The standard error from what the line leaves
  for (std::size_t i = 0; i < t.size(); ++i) {
    const double off = x[i] - line.intercept - line.slope * t[i];
    rest += off * off;
  }
  line.slope_error = std::sqrt(rest / (n - 2) / tt);
  return line;
}

Estimate bend(const std::vector<double>& t, const std::vector<double>& x) {
  const auto half = std::ptrdiff_t(t.size() / 2);
  const auto part = [](auto from, auto to) { return std::vector<double>(from, to); };
  const Line all = fit_line(t, x);
  const Line first = fit_line(part(t.begin(), t.begin() + half), part(x.begin(), x.begin() + half));
  const Line second = fit_line(part(t.begin() + half, t.end()), part(x.begin() + half, x.end()));
  const double scale = std::abs(all.slope);
  return {(second.slope - first.slope) / scale, (first.slope_error + second.slope_error) / scale};
}

Estimate order_between(double large, const Estimate& a, double small, const Estimate& b) {
  const double ratio = std::log(large / small);
  return {std::log(a.value / b.value) / ratio, (a.error / a.value + b.error / b.value) / ratio};
}

Estimate limit_by_halving(const std::vector<Estimate>& values) {
  const auto from = [&](std::size_t last) {
    const Estimate &a = values[last - 1], &b = values[last];
    return Estimate{2 * b.value - a.value, 2 * b.error + a.error};
  };
  return with_error(from(values.size() - 2), from(values.size() - 1));
}

}  // namespace lattice
