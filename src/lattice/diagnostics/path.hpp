#pragma once
/**
# The path of a packet

A travelling breather is a packet of energy, some seven sites wide, that moves along the chain while its
beads oscillate. This file turns snapshots of the energy density $e_n$ (Eq. (23), chain.hpp) into the
quantities that the article quotes: where the packet is,
$$X = \frac{\sum_{|n-c|\le m} n\,e_n}{\sum_{|n-c|\le m} e_n} \qquad\text{(Eq. (24))},$$
with $c$ the site of its largest density and $m = 5$, how fast it moves, and how much energy it carries. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "lattice/numerics/estimate.hpp"
#include "lattice/numerics/line_fit.hpp"

namespace lattice {

/// Half of the window of 2m + 1 sites that belongs to a packet; m = 5 is the article's choice, below Eq. (24).
inline constexpr std::size_t packet_half_width = 5;

/// Sum of `e` over the sites within `m` of `peak`.
double window_sum(const std::vector<double>& e, std::size_t peak,
                  std::size_t m = packet_half_width);

/// Energy centre X around the index `peak`, Eq. (24), in the article's counting (first site = 1).
double energy_centre(const std::vector<double>& e, std::size_t peak,
                     std::size_t m = packet_half_width);

/**
An impact may launch several packets and leave a vibration at the struck end, and any of these can carry
more energy than the breather that travels ahead. So the tracker looks from the far end. Without precompression nothing
runs ahead of the first packet but its own super-exponentially small tail, so `share` matters only where a weak packet
runs ahead of a strong one, as in hard wells. */
/// The first site, from the far end, that is the largest of its window and whose window holds at least `share` of the
/// energy; nothing if there is none.
std::optional<std::size_t> front_packet(const std::vector<double>& e, double share = 0.01,
                                        std::size_t m = packet_half_width);

/// How many sites share the energy, (sum e_n)^2 / sum e_n^2: one if a single site has all of it, N if all have the same.
double participation(const std::vector<double>& e);

/// What is seen of a packet at one instant. Of a path of centres alone energy and peak are not known.
struct PathSample {
  double t = 0, centre = 0;                                  ///< time, centre X (sites, from one)
  double energy = std::numeric_limits<double>::quiet_NaN(),  ///< of the window
      peak = std::numeric_limits<double>::quiet_NaN();       ///< largest density
};

/// The article fits the centre only where the packet is far from the end where it was launched, and gives no number; so
/// the stretch `from <= X <= to` is an argument here and is stated with every result.
struct Path {
  std::vector<PathSample> samples{};

  std::size_t size() const { return samples.size(); }
  bool empty() const { return samples.empty(); }
  const PathSample& operator[](std::size_t i) const { return samples[i]; }
  const PathSample& back() const { return samples.back(); }
  auto begin() const { return samples.begin(); }
  auto end() const { return samples.end(); }
  /// One quantity of all samples, as in `all(&PathSample::energy)`.
  std::vector<double> all(double PathSample::*quantity) const {
    std::vector<double> out;
    for (const PathSample& at : samples) out.push_back(at.*quantity);
    return out;
  }

  /// Appends the packet around `peak_site` of the density `e` at time `time`.
  void add(double time, const std::vector<double>& e, std::size_t peak_site) {
    samples.push_back({time, energy_centre(e, peak_site), window_sum(e, peak_site), e[peak_site]});
  }
  /// The same around the strongest site.
  void add(double time, const std::vector<double>& e) {
    add(time, e, std::size_t(std::max_element(e.begin(), e.end()) - e.begin()));
  }
  /// Appends a centre.
  void add(double time, double x) { samples.push_back({time, x}); }

  /// How many samples count: those before the first centre beyond `site`, even if a later one is back within.
  std::size_t count_before(double site) const {
    return std::size_t(
        std::find_if(begin(), end(), [site](const PathSample& at) { return at.centre > site; }) -
        begin());
  }

  /// Times and centres of the samples between `from` and `to`.
  std::pair<std::vector<double>, std::vector<double>> between(double from, double to) const {
    std::pair<std::vector<double>, std::vector<double>> points;
    for (std::size_t i = 0, end = count_before(to); i < end; ++i)
      if (samples[i].centre >= from) {
        points.first.push_back(samples[i].t);
        points.second.push_back(samples[i].centre);
      }
    return points;
  }

  /// Line through the centres between `from` and `to`; nothing if fewer than three lie there.
  std::optional<Line> line(double from, double to) const;
  /// Speed between two times, with the error of the fit. Throws std::invalid_argument if fewer than three samples lie
  /// there.
  Estimate speed_during(double from, double to) const;
  /// Energy of the packet at the instant when the centre first passes `site`, between two samples. Throws
  /// std::runtime_error if it never does.
  double energy_at(double site) const;
  /// Largest maximum in time of the packet's energy density while its centre is between `from` and `to`, with the error
  /// that samples leave; nan if it has none there.
  Estimate largest_peak(double from, double to) const;
};

/// Where the stretch begins, our choice: twice the packet's window away from the struck end.
inline constexpr double fit_from = 20;
/// Where no packet ever is: the end of a stretch that has none.
inline constexpr double far_away = std::numeric_limits<double>::infinity();

/// The speed of a packet between `fit_from` and `to`, in sites per unit of time, with the error of the fit. Throws
/// std::runtime_error if no packet came so far.
Estimate packet_speed(const Path& path, double to = far_away);

/// Change of the speed from the first to the second half of the stretch, relative to the speed: small if
/// the packet moves at a constant speed, which a good fit alone does not show.
Estimate speed_change(const Path& path, double to = far_away);

/**
The centre trembles with the internal oscillation, so that its velocity vanishes twice per period, and a turning point has
a meaning only for a smoothed path: the mean with the weight $1+\cos(2\pi t/\text{width})$. This weight and its slope fall
to zero at the ends of the window, so that an oscillation with more than a few periods per window is strongly suppressed. At
the ends of a path, where no window fits, the smoothed path has no values. */
/// The weighted mean of a path over windows of the given width in time, shorter by one width.
/// Throws std::invalid_argument for fewer than three samples.
Path smooth(const Path& path, double width);

/// A site and a time, `nan` where there are none.
struct Moment {
  double site = std::numeric_limits<double>::quiet_NaN(),
         time = std::numeric_limits<double>::quiet_NaN();
  /// Whether there is one.
  bool found() const { return !std::isnan(time); }
};

/// The extremum of the parabola through sample `i` and its neighbours, so that its time is not limited by the sampling; the
/// sample itself where the three do not enclose one.
Moment vertex(const Path& path, std::size_t i);

}  // namespace lattice
