#pragma once
/**
# A packet passes

Seen from a fixed contact, a travelling breather is a train of pushes: the contact closes once in each
internal period, harder and harder and then less and less. From such a train, sampled a fraction of a
period apart, this file reads what an experiment would report: the strongest push and its time, the
period, and how long the train lasts. Maxima are those of parabolas through three samples, crossings
those of straight lines through two. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace lattice {

/// A local maximum: when, and how high.
struct Top {
  double t, x;
};

/// The local maxima of equidistant samples, each from the parabola through a sample and its neighbours.
inline std::vector<Top> maxima(const std::vector<double>& t, const std::vector<double>& x) {
  std::vector<Top> tops;
  for (std::size_t i = 1; i + 1 < x.size(); ++i) {
    if (!(x[i] > x[i - 1] && x[i] >= x[i + 1])) continue;
    const double rise = (x[i + 1] - x[i - 1]) / 2, bend = x[i + 1] - 2 * x[i] + x[i - 1];
    tops.push_back({t[i] - rise / bend * (t[i] - t[i - 1]), x[i] - rise * rise / (2 * bend)});
  }
  return tops;
}

/**
A velocity or deflection is largest in either direction: `largest_modulus` is the highest local maximum of
the modulus of `x`, or zero if there is none. */
inline double largest_modulus(const std::vector<double>& t, std::vector<double> x) {
  for (double& value : x) value = std::abs(value);
  double most = 0;
  for (const Top& top : maxima(t, x)) most = std::max(most, top.x);
  return most;
}

/// The strongest push of a train, and half the time between the one before and the one after it.
struct Push {
  double t, force, period;
};

/// The strongest push of the samples `force`; nothing if it is the first or the last one, because the
/// packet has then not passed.
inline std::optional<Push> strongest_push(const std::vector<double>& t,
                                          const std::vector<double>& force) {
  const auto tops = maxima(t, force);
  const auto top = std::max_element(tops.begin(), tops.end(),
                                    [](const Top& a, const Top& b) { return a.x < b.x; });
  if (tops.size() < 3 || top == tops.begin() || top + 1 == tops.end()) return std::nullopt;
  return Push{top->t, top->x, (top[1].t - top[-1].t) / 2};
}

/**
Periods and durations follow from crossings. Here are the times at which `x` passes `level` upwards, linear
between the samples. */
inline std::vector<double> upward_crossings(const std::vector<double>& t,
                                            const std::vector<double>& x, double level = 0) {
  std::vector<double> times;
  for (std::size_t i = 0; i + 1 < x.size(); ++i)
    if (x[i] < level && x[i + 1] >= level)
      times.push_back(t[i] + (t[i + 1] - t[i]) * (level - x[i]) / (x[i + 1] - x[i]));
  return times;
}

/// Time from the first upward to the last downward passage of `level`; zero if there is none.
inline double time_above(const std::vector<double>& t, const std::vector<double>& x, double level) {
  std::vector<double> minus(x);
  for (double& value : minus) value = -value;
  const auto up = upward_crossings(t, x, level), down = upward_crossings(t, minus, -level);
  return up.empty() || down.empty() ? 0 : down.back() - up.front();
}

}  // namespace lattice
