#include "sec34/acceleration.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace lattice {

Stretch stretch(const Path& path, double from, double to) {
  const auto at = [&](double t) {
    return std::size_t(std::lower_bound(path.t.begin(), path.t.end(), t - 1e-9) - path.t.begin());
  };
  return {at(from), std::min(at(to) + 1, path.t.size())};
}

// Samples at equal times: constant, line and parabola are orthogonal around the middle
PathFit fit_parabola(const Path& smoothed, Stretch of) {
  const auto n = double(of.last - of.first);
  const double middle = (smoothed.t[of.first] + smoothed.t[of.last - 1]) / 2;
  double mean = 0, square = 0;
  for (std::size_t i = of.first; i < of.last; ++i)
    mean += smoothed.centre[i] / n, square += std::pow(smoothed.t[i] - middle, 2) / n;
  double xu = 0, uu = 0, xq = 0, qq = 0;
  for (std::size_t i = of.first; i < of.last; ++i) {
    const double u = smoothed.t[i] - middle, q = u * u - square, x = smoothed.centre[i] - mean;
    xu += x * u, uu += u * u, xq += x * q, qq += q * q;
  }
  double off = 0, low = smoothed.centre[of.first], high = low;
  for (std::size_t i = of.first; i < of.last; ++i) {
    const double u = smoothed.t[i] - middle, x = smoothed.centre[i];
    off += std::pow(x - mean - xu / uu * u - xq / qq * (u * u - square), 2) / n;
    low = std::min(low, x), high = std::max(high, x);
  }
  return {2 * xq / qq, std::sqrt(off) / (high - low)};
}

// The samples of a leg
static Stretch samples_of(const Path& p, Leg leg) {
  if (leg.kind == Leg::Kind::out) return stretch(p, leg.from, leg.to);
  const Moment apex = find_turn(p).apex;
  if (!apex.found()) throw std::runtime_error("a packet that should turn does not");
  std::size_t rises = 0;
  while (p.centre[rises] < 0.9 * apex.site) ++rises;
  std::size_t falls = rises;
  while (p.t[falls] < apex.time || p.centre[falls] > 0.9 * apex.site) ++falls;
  if (leg.kind == Leg::Kind::between) return {rises, falls};
  std::size_t end = falls;
  while (p.centre[end] > 0.3 * apex.site) ++end;
  return {falls, end};
}

namespace {
struct OnLeg {
  double mean, change, lost;
};
}  // namespace

static OnLeg on_leg(const Path& path, double width, Leg leg) {
  const Path p = smooth(path, width);
  const Stretch all = samples_of(p, leg);
  const std::size_t half = (all.first + all.last) / 2;
  const double mean = fit_parabola(p, all).acceleration,
               first = fit_parabola(p, {all.first, half}).acceleration,
               second = fit_parabola(p, {half, all.last}).acceleration;
  // Slopes over five units of time on either side
  const std::size_t five = std::size_t(std::lround(5 / path_sampling));
  const auto speed = [&](std::size_t i) {
    return (p.centre[i + five] - p.centre[i - five]) / (p.t[i + five] - p.t[i - five]);
  };
  const std::size_t last = all.last - 1;
  return {mean, (second - first) / mean,
          (speed(last) - speed(all.first)) / (p.t[last] - p.t[all.first])};
}

// Two steps and half the smoothing
Acceleration acceleration_of(const Path& coarse, const Path& fine, Leg leg) {
  const OnLeg a = on_leg(coarse, path_smoothing, leg), b = on_leg(fine, path_smoothing, leg),
              c = on_leg(fine, path_smoothing / 2, leg);
  const auto both = [&](double OnLeg::*of) {
    Estimate e = compare(a.*of, b.*of);
    e.error += std::abs(c.*of - b.*of);
    return e;
  };
  return {both(&OnLeg::mean), both(&OnLeg::change), both(&OnLeg::lost)};
}

}  // namespace lattice
