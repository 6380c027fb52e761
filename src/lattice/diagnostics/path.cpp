#include "lattice/diagnostics/path.hpp"

#include <numbers>
#include <numeric>
#include <stdexcept>

namespace lattice {

std::optional<Line> Path::line(double from, double to) const {
  const auto [ts, xs] = between(from, to);
  if (ts.size() < 3) return std::nullopt;
  return fit_line(ts, xs);
}

Estimate Path::speed_during(double from, double to) const {
  std::vector<double> ts, xs;
  for (std::size_t k = 0; k < t.size(); ++k)
    if (t[k] >= from && t[k] <= to) ts.push_back(t[k]), xs.push_back(centre[k]);
  return fit_line(ts, xs).estimate();
}

// The first sample beyond x, and the share of the interval before it after which the centre passes x
static std::pair<std::size_t, double> passage(const Path& path, double x) {
  const std::size_t i = path.until(x);
  if (i == 0 || i == path.centre.size())
    throw std::runtime_error("no packet passes the site asked for");
  return {i, (x - path.centre[i - 1]) / (path.centre[i] - path.centre[i - 1])};
}

double Path::when_at(double x, const std::vector<double>& series) const {
  const auto [i, part] = passage(*this, x);
  return series.at(i - 1) + part * (series.at(i) - series.at(i - 1));
}

double Path::travelled(double site, double duration) const {
  // Both ends lie between two samples
  const auto [i, part] = passage(*this, site);
  const double end = t[i - 1] + part * (t[i] - t[i - 1]) + duration;
  const auto k = std::size_t(std::lower_bound(t.begin(), t.end(), end) - t.begin());
  if (k == t.size()) throw std::runtime_error("the packet is not followed long enough");
  const double rest = (end - t[k - 1]) / (t[k] - t[k - 1]);
  return centre[k - 1] + rest * (centre[k] - centre[k - 1]) - site;
}

/**
A maximum in time falls between two samples: the parabola through the highest one and its neighbours finds
its height, and where the centre is then. Only a maximum whose own centre lies in the stretch counts, not
the flank of one beyond its edge, which says more about the edge than about the packet. A parabola errs by a third at most
of what one through every second sample changes (or, where that has no top, of what it adds to its sample), and with
this error a lower maximum may be the largest. */
Estimate Path::largest_peak(double from, double to) const {
  double best = std::nan(""), bound = best;
  for (std::size_t i = 1, end = until(to); i <= end && i + 1 < t.size(); ++i) {
    if (peak[i] < peak[i - 1]) continue;
    const Parabola top(peak[i - 1], peak[i], peak[i + 1]);
    // After the last sample nobody sees the fall: there the parabola tells
    const bool falls = i + 2 == t.size() && top.bend < 0 && top.vertex() <= 1;
    if (peak[i] < peak[i + 1] && !falls) continue;
    const bool flat = top.bend == 0;
    const double where =
        centre[i] + (flat ? 0 : top.vertex()) * (centre[i + 1] - centre[i - 1]) / 2;
    if (!(where >= from && where <= to)) continue;
    const double height = flat ? peak[i] : top.extremum();
    double other = peak[i];
    if (i > 1 && i + 2 < t.size())
      if (const Parabola wide(peak[i - 2], peak[i], peak[i + 2]);
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
  if (path.t.size() < 3) throw std::invalid_argument("a path needs at least three samples");
  const double sample = path.t[1] - path.t[0];
  const auto reach = std::size_t(std::lround(width / 2 / sample));
  std::vector<double> weight(2 * reach + 1);
  for (std::size_t k = 0; k < weight.size(); ++k)
    weight[k] = 1 + std::cos(std::numbers::pi * (double(k) - double(reach)) / double(reach + 1));
  const double sum = std::accumulate(weight.begin(), weight.end(), 0.0);
  Path out;
  for (std::size_t i = reach; i + reach < path.t.size(); ++i) {
    const auto mean = [&](const std::vector<double>& x) {
      return std::inner_product(weight.begin(), weight.end(), x.begin() + std::ptrdiff_t(i - reach),
                                0.0) /
             sum;
    };
    out.t.push_back(path.t[i]);
    out.centre.push_back(mean(path.centre));
    out.energy.push_back(mean(path.energy));
  }
  return out;
}

// Locate an extremum between the samples, by the parabola through three of them
Moment vertex(const Path& path, std::size_t i) {
  if (i == 0 || i + 1 >= path.t.size()) return {path.centre[i], path.t[i]};
  const Parabola through(path.centre[i - 1], path.centre[i], path.centre[i + 1]);
  if (through.bend == 0 || std::abs(through.slope) > std::abs(through.bend))
    return {path.centre[i], path.t[i]};
  return {through.extremum(), path.t[i] + through.vertex() * (path.t[1] - path.t[0])};
}

}  // namespace lattice
