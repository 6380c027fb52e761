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

double deviation_of_arc(const Path& smoothed, int arc) {
  const double reflected = find_turn(smoothed).rebound.time;
  if (arc == 1) return fit_parabola(smoothed, stretch(smoothed, 0, reflected)).deviation;
  // The turn after the first reflection
  Path rest;
  for (std::size_t i = stretch(smoothed, reflected, reflected).first; i < smoothed.t.size(); ++i)
    rest.add(smoothed.t[i], smoothed.centre[i]);
  const double again = find_turn(rest).rebound.time;
  return fit_parabola(smoothed, stretch(smoothed, reflected, again)).deviation;
}

static double speed_between(const Path& p, std::size_t from, std::size_t to) {
  return (p.centre[to] - p.centre[from]) / (p.t[to] - p.t[from]);
}

Estimate mean_speed(const Path& coarse, const Path& fine, double from, double to) {
  const auto speed = [&](const Path& path, double smoothing) {
    const Path p = smooth(path, smoothing);
    const Stretch of = stretch(p, from, to);
    return speed_between(p, of.first, of.last - 1);
  };
  Estimate e = compare(speed(coarse, path_smoothing), speed(fine, path_smoothing));
  e.error += std::abs(speed(fine, path_smoothing / 2) - e.value);
  return e;
}

double speed_in_quarter(const Path& smoothed, std::size_t quarter) {
  const std::size_t n = smoothed.t.size() / 4, from = (quarter - 1) * n;
  return speed_between(smoothed, from, std::min(from + n, smoothed.t.size() - 1));
}

double last_speed(const Path& smoothed, double duration) {
  const std::size_t end = smoothed.t.size() - 1;
  return speed_between(smoothed, end - std::size_t(std::lround(duration / path_sampling)), end);
}

double farthest_return(const Path& smoothed) {
  double farthest = smoothed.centre.at(0), back = 0;
  for (double x : smoothed.centre) {
    farthest = std::max(farthest, x);
    back = std::max(back, farthest - x);
  }
  return back;
}

// The samples of a part of the way
static Stretch samples_of(const Path& p, WayPart part) {
  if (part.kind == WayPart::Kind::times) return stretch(p, part.from, part.to);
  const Moment apex = find_turn(p).apex;
  if (!apex.found()) throw std::runtime_error("a packet that should turn does not");
  std::size_t rises = 0;
  while (p.centre[rises] < 0.9 * apex.site) ++rises;
  std::size_t falls = rises;
  while (p.t[falls] < apex.time || p.centre[falls] > 0.9 * apex.site) ++falls;
  if (part.kind == WayPart::Kind::turn) return {rises, falls};
  std::size_t end = falls;
  while (p.centre[end] > 0.3 * apex.site) ++end;
  return {falls, end};
}

namespace {
struct OnPart {
  double mean, mean_change;
};
}  // namespace

static OnPart on_part(const Path& path, double width, WayPart part) {
  const Path p = smooth(path, width);
  const Stretch all = samples_of(p, part);
  // Slopes over five units of time on either side
  const std::size_t five = std::size_t(std::lround(5 / path_sampling));
  const auto speed = [&](std::size_t i) {
    return (p.centre[i + five] - p.centre[i - five]) / (p.t[i + five] - p.t[i - five]);
  };
  const std::size_t last = all.last - 1;
  return {fit_parabola(p, all).acceleration,
          (speed(last) - speed(all.first)) / (p.t[last] - p.t[all.first])};
}

// Two steps and half the smoothing
Acceleration acceleration_of(const Path& coarse, const Path& fine, WayPart part) {
  const OnPart twice = on_part(coarse, path_smoothing, part),
               usual = on_part(fine, path_smoothing, part),
               less = on_part(fine, path_smoothing / 2, part);
  const auto with_error = [](double coarser, double value, double smoothed_less) {
    Estimate e = compare(coarser, value);
    e.error += std::abs(smoothed_less - value);
    return e;
  };
  return {with_error(twice.mean, usual.mean, less.mean),
          with_error(twice.mean_change, usual.mean_change, less.mean_change)};
}

}  // namespace lattice
