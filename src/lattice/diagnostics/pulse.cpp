#include "lattice/diagnostics/pulse.hpp"

#include "lattice/numerics/line_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace lattice {

std::vector<Top> maxima(const std::vector<double>& t, const std::vector<double>& x) {
  std::vector<Top> tops;
  for (std::size_t i = 1; i + 1 < x.size(); ++i) {
    if (!(x[i] > x[i - 1] && x[i] >= x[i + 1])) continue;
    const Parabola top(x[i - 1], x[i], x[i + 1]);
    tops.push_back({t[i] + top.vertex() * (t[i] - t[i - 1]), top.extremum()});
  }
  return tops;
}

double largest_modulus(const std::vector<double>& t, std::vector<double> x) {
  for (double& value : x) value = std::abs(value);
  double most = 0;
  for (const Top& top : maxima(t, x)) most = std::max(most, top.x);
  return most;
}

std::optional<Push> strongest_push(const std::vector<double>& t, const std::vector<double>& force) {
  const auto tops = maxima(t, force);
  const auto top = std::max_element(tops.begin(), tops.end(),
                                    [](const Top& a, const Top& b) { return a.x < b.x; });
  if (tops.size() < 3 || top == tops.begin() || top + 1 == tops.end()) return std::nullopt;
  return Push{top->t, top->x, (top[1].t - top[-1].t) / 2};
}

std::vector<double> upward_crossings(const std::vector<double>& t, const std::vector<double>& x,
                                     double level) {
  std::vector<double> times;
  for (std::size_t i = 0; i + 1 < x.size(); ++i)
    if (x[i] < level && x[i + 1] >= level)
      times.push_back(t[i] + (t[i + 1] - t[i]) * (level - x[i]) / (x[i + 1] - x[i]));
  return times;
}

double time_above(const std::vector<double>& t, const std::vector<double>& x, double level) {
  std::vector<double> minus(x);
  for (double& value : minus) value = -value;
  const auto up = upward_crossings(t, x, level), down = upward_crossings(t, minus, -level);
  return up.empty() || down.empty() ? 0 : down.back() - up.front();
}

}  // namespace lattice
