#pragma once
/**
# Looking at a run

A travelling breather is a packet of energy, some seven sites wide, that moves along the chain while its
beads oscillate. This file turns snapshots of the energy density $e_n$ (Eq. (23), chain.hpp) into the
quantities that the article quotes: where the packet is,
$$X = \frac{\sum_{|n-c|\le m} n\,e_n}{\sum_{|n-c|\le m} e_n} \qquad\text{(Eq. (24))},$$
with $c$ the site of its largest density and $m = 5$, how fast it moves, and how much energy it carries. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "lattice/numbers/estimate.hpp"
#include "lattice/numbers/line_fit.hpp"

namespace lattice {

/**
Whatever belongs to a packet is summed over a window of $2m+1$ sites around its peak; $m = 5$ is the
article's choice, below Eq. (24). */
inline constexpr std::size_t packet_half_width = 5;

/// Sum of `e` over the sites within `m` of `peak`.
inline double window_sum(const std::vector<double>& e, std::size_t peak,
                         std::size_t m = packet_half_width) {
  const std::size_t lo = peak > m ? peak - m : 0, hi = std::min(e.size(), peak + m + 1);
  return std::accumulate(e.begin() + std::ptrdiff_t(lo), e.begin() + std::ptrdiff_t(hi), 0.0);
}

/// Energy centre X around the index `peak`, Eq. (24), in the article's counting (first site = 1).
inline double energy_centre(const std::vector<double>& e, std::size_t peak,
                            std::size_t m = packet_half_width) {
  const std::size_t lo = peak > m ? peak - m : 0, hi = std::min(e.size(), peak + m + 1);
  double weight = 0, moment = 0;
  for (std::size_t n = lo; n < hi; ++n) {
    weight += e[n];
    moment += double(n + 1) * e[n];
  }
  return moment / weight;
}

/**
An impact may launch several packets and leave a vibration at the struck end, and any of these can carry
more energy than the breather that travels ahead. The tracker therefore looks from the far end: the packet
is at the first site, coming from there, that is the largest of its window and whose window holds at least
`share` of the total energy. Without precompression nothing runs ahead of the packet but its own
super-exponentially small tail, so the result does not depend on `share`. Returns the index of the site, or
nothing if there is no such site. */
inline std::optional<std::size_t> front_packet(const std::vector<double>& e, double share = 0.01,
                                               std::size_t m = packet_half_width) {
  const double total = std::accumulate(e.begin(), e.end(), 0.0);
  if (!(total > 0)) return std::nullopt;
  for (std::size_t n = e.size(); n-- > 0;) {
    if (e[n] * double(2 * m + 1) < share * total) continue;  // cannot be the largest of its window
    const std::size_t lo = n > m ? n - m : 0, hi = std::min(e.size(), n + m + 1);
    const auto largest =
        std::max_element(e.begin() + std::ptrdiff_t(lo), e.begin() + std::ptrdiff_t(hi));
    if (std::size_t(largest - e.begin()) == n && window_sum(e, n, m) >= share * total) return n;
  }
  return std::nullopt;
}

/**
Localized or spread out? The participation number $(\sum e_n)^2/\sum e_n^2$ says how many sites share the
energy: one if a single site has all of it, $N$ if all have the same. */
inline double participation(const std::vector<double>& e) {
  double sum = 0, squares = 0;
  for (double x : e) {
    sum += x;
    squares += x * x;
  }
  return sum * sum / squares;
}

/**
A track collects what the packet does from sample to sample. Its speed is the slope of the centre $X(t)$.
The article fits it only where the packet is far from the end where it was launched, and gives no number;
so the stretch `from <= X <= to` is an argument here and is stated with every result. */
struct Track {
  std::vector<double> t, centre, energy, peak;

  /// Appends the packet around `peak_site` of the density `e` at time `time`.
  void add(double time, const std::vector<double>& e, std::size_t peak_site) {
    t.push_back(time);
    centre.push_back(energy_centre(e, peak_site));
    energy.push_back(window_sum(e, peak_site));
    peak.push_back(e[peak_site]);
  }

  /**
  What happens to a packet after it has left the stretch, a reflection for example, does not count. So
  samples count up to the first one whose centre lies beyond `to`, even if a later one is back within. */
  std::size_t until(double to) const {
    return std::size_t(
        std::find_if(centre.begin(), centre.end(), [to](double x) { return x > to; }) -
        centre.begin());
  }

  /// Times and centres of the samples between `from` and `to`.
  std::pair<std::vector<double>, std::vector<double>> between(double from, double to) const {
    std::pair<std::vector<double>, std::vector<double>> points;
    for (std::size_t i = 0, end = until(to); i < end; ++i)
      if (centre[i] >= from) {
        points.first.push_back(t[i]);
        points.second.push_back(centre[i]);
      }
    return points;
  }

  /// Line through the centres between `from` and `to`; nothing if fewer than three lie there.
  std::optional<Line> line(double from, double to) const;
  /// Energy of the packet at the instant when its centre first passes `x`, between two samples.
  /// Throws std::runtime_error if it never does.
  double energy_at(double x) const;
  /// Largest energy density of the packet while its centre is between `from` and `to`, or zero.
  double largest_peak(double from, double to) const;
};

/**
A speed needs at least three samples; an energy is interpolated between the two samples around the instant
that is asked for. */
inline std::optional<Line> Track::line(double from, double to) const {
  const auto [ts, xs] = between(from, to);
  if (ts.size() < 3) return std::nullopt;
  return fit_line(ts, xs);
}

inline double Track::energy_at(double x) const {
  const std::size_t i = until(x);
  if (i == 0 || i == centre.size()) throw std::runtime_error("no packet passes the site asked for");
  const double part = (x - centre[i - 1]) / (centre[i] - centre[i - 1]);
  return energy[i - 1] + part * (energy[i] - energy[i - 1]);
}

/**
A maximum in time falls between two samples: the parabola through the highest one and its neighbours finds
its height, and where the centre is then. Only a maximum whose own centre lies in the stretch counts, not
the flank of one beyond its edge. If there is no maximum at all, the highest sample stands in for it. */
inline double Track::largest_peak(double from, double to) const {
  double best = 0, highest = 0;
  const std::size_t end = std::min(until(to), t.size());
  for (std::size_t i = 0; i < end; ++i) {
    if (centre[i] >= from) highest = std::max(highest, peak[i]);
    if (i == 0 || i + 1 >= t.size() || peak[i] < peak[i - 1] || peak[i] < peak[i + 1]) continue;
    const double rise = (peak[i + 1] - peak[i - 1]) / 2;
    const double bend = peak[i + 1] - 2 * peak[i] + peak[i - 1];
    const double shift = bend < 0 ? -rise / bend : 0;  // of the vertex, in samples
    const double where = centre[i] + shift * (centre[i + 1] - centre[i - 1]) / 2;
    if (where >= from && where <= to) best = std::max(best, peak[i] + rise * shift / 2);
  }
  return best > 0 ? best : highest;
}

/// The observer of a run that is followed for its packet alone.
struct Unwatched {
  template <class S, class D>
  void operator()(const S&, const D&) const {}
};

/**
Where does the stretch begin? Our choice is site 20, twice the packet's window away from the struck end.
The front-most packet is followed, because a second and slower one can carry as much energy (as it does
at $s = -1/6$). */
inline constexpr double fit_from = 20, far_away = 1e9;

/**
`packet_speed` is the speed of a packet between `fit_from` and `to`, in sites per unit of time, with the
error of the fit. Throws std::runtime_error if no packet came so far. */
inline Estimate packet_speed(const Track& track, double to = far_away) {
  const auto line = track.line(fit_from, to);
  if (!line) throw std::runtime_error("no packet passes site 20");
  return line->estimate();
}

/// Change of the speed from the first to the second half of the stretch, relative to the speed: small if
/// the packet moves at a constant speed, which a good fit alone does not show.
inline Estimate speed_change(const Track& track, double to = far_away) {
  const auto [t, x] = track.between(fit_from, to);
  if (t.size() < 6) throw std::runtime_error("no packet passes site 20");
  return bend(t, x);
}

/// The least number of neighbouring sites about `peak`, equally many on either side, that hold
/// `share` of the window's energy.
inline std::size_t support(const std::vector<double>& e, std::size_t peak, double share,
                           std::size_t m = packet_half_width) {
  const double all = window_sum(e, peak, m);
  for (std::size_t k = 0; k < m; ++k)
    if (window_sum(e, peak, k) >= share * all) return 2 * k + 1;
  return 2 * m + 1;
}

}  // namespace lattice
