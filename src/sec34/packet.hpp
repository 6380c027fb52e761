#pragma once
/**
# What is measured of a packet

How much energy it keeps on its way, what it leaves behind, how wide it is, and whether it stands out of the waves
around it. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lattice/diagnostics/path.hpp"
#include "lattice/numerics/estimate.hpp"

namespace lattice {

/// Relative change of the mean of `series`, one entry a sample, from the first half of the packet's way to the second;
/// the means remove its pulsation. Throws std::runtime_error if fewer than six samples lie beyond `fit_from`.
double change_between_halves(const Path& path, const std::vector<double>& series);
/// That of the packet's energy.
double energy_change(const Path& path);

/// The largest energy in a window behind the packet, at least one width clear of it, over that of the packet around
/// `peak`.
double residue(const std::vector<double>& e, std::size_t peak);

/**
Ahead of a compact packet nothing has moved yet, and the amplitude falls super-exponentially. We look at the *largest*
amplitude that a site reaches at a given distance ahead, relative to the peak. For the width the distance is counted
from the peak's site, and for the decay from the centre $X$, since the peak jumps from site to site and the centre does
not. */
class Front {
 public:
  /// Takes the density `e` of a packet whose largest site is `peak`.
  void add(const std::vector<double>& e, std::size_t peak) {
    const double X = energy_centre(e, peak);
    seven_ = std::min(seven_, window_sum(e, peak, 3) / window_sum(e, peak));
    for (std::size_t n = peak; n < e.size(); ++n) {
      const double distance = double(n + 1) - X;
      const long k = std::lround(distance);
      if (k >= 0 && k < long(from_centre_.size()) && std::abs(distance - double(k)) < 0.25)
        from_centre_[std::size_t(k)] = std::max(from_centre_[std::size_t(k)], e[n]);
    }
    for (std::size_t k = 0; k < largest_.size() && peak + k < e.size(); ++k)
      largest_[k] = std::max(largest_[k], e[peak + k]);
    for (std::size_t k = packet_half_width + 1; k <= 3 * packet_half_width && k <= peak; ++k)
      behind_ = std::max(behind_, e[peak - k]);
  }
  /// Amplitude `distance` sites ahead of the peak, relative to the peak.
  double amplitude(std::size_t distance) const {
    return std::sqrt(largest_.at(distance) / largest_[0]);
  }
  /// Amplitude at this distance ahead of the centre, to a quarter of a site, relative to the peak.
  double from_centre(std::size_t distance) const {
    return std::sqrt(from_centre_.at(distance) / largest_[0]);
  }
  /// Fraction of the energy of eleven sites that is on seven of them, at least.
  double seven() const { return seven_; }
  /// Sites of the packet, if it is as wide behind its peak as ahead of it: those above a hundredth.
  std::size_t width() const {
    std::size_t k = 0;
    while (k + 1 < largest_.size() && amplitude(k + 1) > 0.01) ++k;
    return 2 * k + 1;
  }
  /// Largest amplitude on the ten sites behind the packet's window, relative to the peak.
  double tail() const { return std::sqrt(behind_ / largest_[0]); }

 private:
  std::vector<double> largest_ = std::vector<double>(2 * packet_half_width, 0.0),
                      from_centre_ = std::vector<double>(8, 0.0);
  double behind_ = 0, seven_ = 1;
};

/// The oscillation of one bead, sample by sample: the times at which it passes zero upwards, and its largest
/// displacement.
class Oscillation {
 public:
  void add(double t, double y, double v);
  /// Mean frequency between the first and the last passage. Throws std::runtime_error if there are less than two.
  double frequency() const;
  double amplitude() const { return amplitude_; }

 private:
  std::vector<double> passages_{};
  double amplitude_ = 0, last_ = 0;
};

/// Frequency of a free bead in the well y^2/2 + s y^4/4, s <= 0, that oscillates between -A and A: with the complete
/// elliptic integral K, it is pi q / (2 K(k)), where q^2 = 1 + s A^2/2 and k^2 = -s A^2/(2 q^2).
double free_frequency(double s, double A);

/// The height of the lower of two excitations, on the first five sites and about `peak`, over the highest wave in
/// between: both are visible if it exceeds one.
double prominence(const std::vector<double>& v, std::size_t peak);

}  // namespace lattice
