#include "sec34/force.hpp"

#include <algorithm>
#include <cmath>

#include "lattice/numerics/line_fit.hpp"

namespace lattice {

namespace {

// A line through the velocities between two samples of the smoothed path
Force force_on(const Path& smoothed, std::size_t first, std::size_t last) {
  std::vector<double> ts, vs;
  const std::size_t half = std::size_t(std::lround(5 / sampling));
  for (std::size_t i = std::max(first, half); i < std::min(last, smoothed.t.size()) - half;
       i += half) {
    ts.push_back(smoothed.t[i]);
    vs.push_back((smoothed.centre[i + half] - smoothed.centre[i - half]) / (2 * half * sampling));
  }
  return {fit_line(ts, vs).estimate(), bend(ts, vs)};
}

// Times bound the way out, sites the way back, which begins at another time for each impact
Force force_of(const Voyage& seen, double width, Stretch stretch) {
  const Path p = smooth(seen.path, width);
  std::size_t first = 0, last = 0;
  if (stretch != Stretch::out) {
    const double apex = find_turn(p).apex.time;
    while (p.t[first] < apex || p.centre[first] > 18) ++first;
    for (last = first; p.centre[last] > 6;) ++last;
  }
  if (stretch == Stretch::between) last = first;
  if (stretch != Stretch::back)
    for (first = 0; p.t[first] < (stretch == Stretch::out ? 100 : 220);) ++first;
  if (stretch == Stretch::out) last = first + std::size_t(120 / sampling);
  return force_on(p, first, last);
}

}  // namespace

// Two steps and half the smoothing
Force force_of(const Voyage& coarse, const Voyage& fine, Stretch stretch) {
  const Force a = force_of(coarse, smoothing, stretch), b = force_of(fine, smoothing, stretch),
              c = force_of(fine, smoothing / 2, stretch);
  Force out{compare(a.force, b.force), b.bend};
  out.force.error += std::abs(c.force.value - b.force.value);
  return out;
}

// The largest fall beyond the errors, and the rise from the first to the last
Criterion rises(const std::vector<Estimate>& forces) {
  double fall = -1;
  for (std::size_t i = 0; i < forces.size(); ++i)
    for (std::size_t j = i + 1; j < forces.size(); ++j) {
      const double errors = forces[i].error + forces[j].error;
      fall = std::max(fall, std::abs(forces[i].value) - std::abs(forces[j].value) - errors);
    }
  const Estimate ratio = quotient(forces.back(), forces.front());
  return {below("largest_fall", exact(fall), 0),
          above("last_over_first", {std::abs(ratio.value), ratio.error}, 1)};
}

}  // namespace lattice
