#include "lattice/diagnostics/path.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace lattice {

double window_sum(const std::vector<double>& e, std::size_t peak, std::size_t m) {
  const std::size_t lo = peak > m ? peak - m : 0, hi = std::min(e.size(), peak + m + 1);
  return std::accumulate(e.begin() + std::ptrdiff_t(lo), e.begin() + std::ptrdiff_t(hi), 0.0);
}

double energy_centre(const std::vector<double>& e, std::size_t peak, std::size_t m) {
  const std::size_t lo = peak > m ? peak - m : 0, hi = std::min(e.size(), peak + m + 1);
  double weight = 0, moment = 0;
  for (std::size_t n = lo; n < hi; ++n) {
    weight += e[n];
    moment += double(n + 1) * e[n];
  }
  return moment / weight;
}

std::optional<std::size_t> front_packet(const std::vector<double>& e, double share, std::size_t m) {
  // Ahead of a front there is nothing, and nothing need be summed
  std::size_t awake = e.size();
  while (awake > 0 && e[awake - 1] == 0) --awake;
  const double total = std::accumulate(e.begin(), e.begin() + std::ptrdiff_t(awake), 0.0);
  if (!(total > 0)) return std::nullopt;
  for (std::size_t n = awake; n-- > 0;) {
    if (e[n] * double(2 * m + 1) < share * total) continue;  // cannot be the largest of its window
    const std::size_t lo = n > m ? n - m : 0, hi = std::min(e.size(), n + m + 1);
    const auto largest =
        std::max_element(e.begin() + std::ptrdiff_t(lo), e.begin() + std::ptrdiff_t(hi));
    if (std::size_t(largest - e.begin()) == n && window_sum(e, n, m) >= share * total) return n;
  }
  return std::nullopt;
}

double participation(const std::vector<double>& e) {
  double sum = 0, squares = 0;
  for (double x : e) {
    sum += x;
    squares += x * x;
  }
  return sum * sum / squares;
}

std::optional<Line> Path::line(double from, double to) const {
  const auto [ts, xs] = between(from, to);
  if (ts.size() < 3) return std::nullopt;
  return fit_line(ts, xs);
}

Estimate Path::speed_during(double from, double to) const {
  std::vector<double> ts, xs;
  for (const PathSample& at : samples)
    if (at.t >= from && at.t <= to) ts.push_back(at.t), xs.push_back(at.centre);
  return fit_line(ts, xs).estimate();
}

double Path::energy_at(double site) const {
  const std::size_t i = count_before(site);
  if (i == 0 || i == size()) throw std::runtime_error("no packet passes the site asked for");
  const PathSample &before = samples[i - 1], &after = samples[i];
  const double part = (site - before.centre) / (after.centre - before.centre);
  return before.energy + part * (after.energy - before.energy);
}

/**
A maximum in time falls between two samples: the parabola through the highest one and its neighbours finds
its height, and where the centre is then. Only a maximum whose own centre lies in the stretch counts, not
the flank of one beyond its edge, which says more about the edge than about the packet. A parabola errs by a third at most
of what one through every second sample changes (or, where that has no top, of what it adds to its sample), and with
this error a lower maximum may be the largest. */
Estimate Path::largest_peak(double from, double to) const {
  double best = std::nan(""), bound = best;
  const auto peak = [&](std::size_t k) { return samples[k].peak; };
  for (std::size_t i = 1, end = count_before(to), all = size(); i <= end && i + 1 < all; ++i) {
    if (peak(i) < peak(i - 1)) continue;
    const Parabola top(peak(i - 1), peak(i), peak(i + 1));
    // After the last sample nobody sees the fall: there the parabola tells
    const bool falls = i + 2 == all && top.bend < 0 && top.vertex() <= 1;
    if (peak(i) < peak(i + 1) && !falls) continue;
    const bool flat = top.bend == 0;
    const double where = samples[i].centre + (flat ? 0 : top.vertex()) *
                                                 (samples[i + 1].centre - samples[i - 1].centre) /
                                                 2;
    if (!(where >= from && where <= to)) continue;
    const double height = flat ? peak(i) : top.extremum();
    double other = peak(i);
    if (i > 1 && i + 2 < all)
      if (const Parabola wide(peak(i - 2), peak(i), peak(i + 2));
          wide.bend < 0 && std::abs(wide.slope) <= -wide.bend)
        other = wide.extremum();
    best = std::fmax(best, height);
    bound = std::fmax(bound, height + std::abs(other - height) / 3);
  }
  return {best, bound - best};
}

Estimate packet_speed(const Path& path, double to) {
  const auto line = path.line(fit_from, to);
  if (!line) throw std::runtime_error("no packet passes site 20");
  return line->estimate();
}

Estimate speed_change(const Path& path, double to) {
  const auto [t, x] = path.between(fit_from, to);
  if (t.size() < 6) throw std::runtime_error("no packet passes site 20");
  return bend(t, x);
}

// Average the internal oscillation away with a raised cosine as wide as several of its periods
Path smooth(const Path& path, double width) {
  if (path.size() < 3) throw std::invalid_argument("a path needs at least three samples");
  const double sample = path[1].t - path[0].t;
  const auto reach = std::size_t(std::lround(width / 2 / sample));
  std::vector<double> weight(2 * reach + 1);
  for (std::size_t k = 0; k < weight.size(); ++k)
    weight[k] = 1 + std::cos(std::numbers::pi * (double(k) - double(reach)) / double(reach + 1));
  const double sum = std::accumulate(weight.begin(), weight.end(), 0.0);
  Path out;
  for (std::size_t i = reach; i + reach < path.size(); ++i) {
    const auto mean = [&](double PathSample::*quantity) {
      double all = 0;
      for (std::size_t k = 0; k < weight.size(); ++k)
        all += weight[k] * (path[i - reach + k].*quantity);
      return all / sum;
    };
    out.samples.push_back({path[i].t, mean(&PathSample::centre), mean(&PathSample::energy)});
  }
  return out;
}

// Locate an extremum between the samples, by the parabola through three of them
Moment vertex(const Path& path, std::size_t i) {
  const Moment here{path[i].centre, path[i].t};
  if (i == 0 || i + 1 >= path.size()) return here;
  const Parabola through(path[i - 1].centre, path[i].centre, path[i + 1].centre);
  if (through.bend == 0 || std::abs(through.slope) > std::abs(through.bend)) return here;
  return {through.extremum(), here.time + through.vertex() * (path[1].t - path[0].t)};
}

}  // namespace lattice
