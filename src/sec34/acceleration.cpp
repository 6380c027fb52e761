#include "sec34/acceleration.hpp"

#include <algorithm>
#include <cmath>

#include "lattice/numerics/line_fit.hpp"

namespace lattice {

// Slopes over five units of time on either side
Velocities velocities(const Path& smoothed, std::size_t first, std::size_t last, double look) {
  Velocities out;
  const std::size_t half = std::size_t(std::lround(5 / look));
  for (std::size_t i = std::max(first, half); i < std::min(last, smoothed.t.size()) - half;
       i += half) {
    out.t.push_back(smoothed.t[i]);
    out.v.push_back((smoothed.centre[i + half] - smoothed.centre[i - half]) / (2 * half * look));
  }
  return out;
}

// Times bound the way out, sites the way back, which begins at another time for each impact
static Acceleration on_leg(const Path& path, double width, Leg leg) {
  const Path p = smooth(path, width);
  std::size_t first = 0, last = 0;
  if (leg != Leg::out) {
    const double apex = find_turn(p).apex.time;
    while (p.t[first] < apex || p.centre[first] > 18) ++first;
    for (last = first; p.centre[last] > 6;) ++last;
  }
  if (leg == Leg::between) last = first;
  if (leg != Leg::back)
    for (first = 0; p.t[first] < (leg == Leg::out ? 100 : 220);) ++first;
  if (leg == Leg::out) last = first + std::size_t(120 / path_sampling);
  const auto [t, v] = velocities(p, first, last, path_sampling);
  return {fit_line(t, v).estimate(), bend(t, v)};
}

// Two steps and half the smoothing
Acceleration acceleration_of(const Path& coarse, const Path& fine, Leg leg) {
  const Acceleration a = on_leg(coarse, path_smoothing, leg), b = on_leg(fine, path_smoothing, leg),
                     c = on_leg(fine, path_smoothing / 2, leg);
  Acceleration out{compare(a.mean, b.mean), b.bend};
  out.mean.error += std::abs(c.mean.value - b.mean.value);
  return out;
}

}  // namespace lattice
