#pragma once
/**
# Looking at a run

A travelling breather is a packet of energy, some seven sites wide, that moves along the chain while its
beads oscillate. This file turns snapshots of the energy density $e_n$ (Eq. (23), chain.hpp) into the
quantities that the article quotes: where the packet is,
$$X = \frac{\sum_{|n-c|\le m} n\,e_n}{\sum_{|n-c|\le m} e_n} \qquad\text{(Eq. (24))},$$
with $c$ the site of its largest density and $m = 5$, how fast it moves, and how much energy it carries. */

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "lattice/numerics/estimate.hpp"
#include "lattice/numerics/line_fit.hpp"

namespace lattice {

/**
Whatever belongs to a packet is summed over a window of $2m+1$ sites around its peak; $m = 5$ is the
article's choice, below Eq. (24). */
inline constexpr std::size_t packet_half_width = 5;

/// Sum of `e` over the sites within `m` of `peak`.
double window_sum(const std::vector<double>& e, std::size_t peak,
                  std::size_t m = packet_half_width);

/// Energy centre X around the index `peak`, Eq. (24), in the article's counting (first site = 1).
double energy_centre(const std::vector<double>& e, std::size_t peak,
                     std::size_t m = packet_half_width);

/**
An impact may launch several packets and leave a vibration at the struck end, and any of these can carry
more energy than the breather that travels ahead. The tracker therefore looks from the far end: the packet
is at the first site, coming from there, that is the largest of its window and whose window holds at least
`share` of the total energy. Without precompression nothing runs ahead of the first packet but its own
super-exponentially small tail, so `share` matters only where a weak packet runs ahead of a strong one, as
in hard wells. Returns the index of the site, or nothing if there is no such site. */
std::optional<std::size_t> front_packet(const std::vector<double>& e, double share = 0.01,
                                        std::size_t m = packet_half_width);

/**
Localized or spread out? The participation number $(\sum e_n)^2/\sum e_n^2$ says how many sites share the
energy: one if a single site has all of it, $N$ if all have the same. */
double participation(const std::vector<double>& e);

/**
A track collects what the packet does from sample to sample. Its speed is the slope of the centre $X(t)$.
The article fits it only where the packet is far from the end where it was launched, and gives no number;
so the stretch `from <= X <= to` is an argument here and is stated with every result. */
struct Track {
  /// One entry per sample: time, centre X (sites, from one), energy of the window, largest density.
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
  /// How many samples count.
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
  /// Sites by which the centre moves on in `duration` after it has passed `site`. Throws
  /// std::runtime_error if the track ends before.
  double travelled(double site, double duration) const;
  /// Largest maximum in time of the packet's energy density while its centre is between `from` and `to`, with the error
  /// that samples leave; nan if it has none there.
  Estimate largest_peak(double from, double to) const;
};

/// The observer of a run that is followed for its packet alone.
struct Unwatched {
  template <class S, class D>
  void operator()(const S&, const D&) const {}
};

/**
Where does the stretch begin? Our choice is site 20, twice the packet's window away from the struck end.
The front-most packet is followed, because a second and slower one can carry as much energy (as it does
at $s = -1/6$). */
inline constexpr double fit_from = 20;
/// Where no packet ever is: the end of a stretch that has none.
inline constexpr double far_away = std::numeric_limits<double>::infinity();

/**
`packet_speed` is the speed of a packet between `fit_from` and `to`, in sites per unit of time, with the
error of the fit. Throws std::runtime_error if no packet came so far. */
Estimate packet_speed(const Track& track, double to = far_away);

/// Change of the speed from the first to the second half of the stretch, relative to the speed: small if
/// the packet moves at a constant speed, which a good fit alone does not show.
Estimate speed_change(const Track& track, double to = far_away);

}  // namespace lattice
