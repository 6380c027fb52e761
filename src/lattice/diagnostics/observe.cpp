#include "lattice/diagnostics/observe.hpp"

#include "lattice/numerics/parabola.hpp"

#include <cmath>
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

/**
A speed needs at least three samples; an energy is interpolated between the two samples around the instant
that is asked for. */
std::optional<Line> Track::line(double from, double to) const {
  const auto [ts, xs] = between(from, to);
  if (ts.size() < 3) return std::nullopt;
  return fit_line(ts, xs);
}

double Track::energy_at(double x) const {
  const std::size_t i = until(x);
  if (i == 0 || i == centre.size()) throw std::runtime_error("no packet passes the site asked for");
  const double part = (x - centre[i - 1]) / (centre[i] - centre[i - 1]);
  return energy[i - 1] + part * (energy[i] - energy[i - 1]);
}

double Track::travelled(double site, double duration) const {
  // Both ends lie between two samples
  const std::size_t i = until(site);
  if (i == 0 || i == t.size()) throw std::runtime_error("no packet passes the site asked for");
  const double part = (site - centre[i - 1]) / (centre[i] - centre[i - 1]);
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
Estimate Track::largest_peak(double from, double to) const {
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

Estimate packet_speed(const Track& track, double to) {
  const auto line = track.line(fit_from, to);
  if (!line) throw std::runtime_error("no packet passes site 20");
  return line->estimate();
}

Estimate speed_change(const Track& track, double to) {
  const auto [t, x] = track.between(fit_from, to);
  if (t.size() < 6) throw std::runtime_error("no packet passes site 20");
  return bend(t, x);
}

}  // namespace lattice
