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

namespace lattice {

/// Relative change of the packet's mean energy from the first half of its way to the second; the means remove its
/// pulsation. Throws std::runtime_error if fewer than six samples lie beyond `fit_from`.
double energy_change(const Path& path);

/// The largest energy in a window behind the packet, at least one width clear of it, over that of the packet around
/// `peak`.
double residue(const std::vector<double>& e, std::size_t peak);

/**
Ahead of a compact packet nothing has moved yet, and the amplitude falls super-exponentially, from site to site by a factor of two, then six, then thirty. We therefore look at the *largest* amplitude that a site reaches at a given
distance ahead of the peak, relative to the peak. */
class Front {
 public:
  /// Takes the density `e` of a packet whose largest site is `peak`.
  void add(const std::vector<double>& e, std::size_t peak) {
    for (std::size_t k = 0; k < largest_.size() && peak + k < e.size(); ++k)
      largest_[k] = std::max(largest_[k], e[peak + k]);
    for (std::size_t k = packet_half_width + 1; k <= 3 * packet_half_width && k <= peak; ++k)
      behind_ = std::max(behind_, e[peak - k]);
  }
  /// Amplitude `distance` sites ahead of the peak, relative to the peak.
  double amplitude(std::size_t distance) const {
    return std::sqrt(largest_.at(distance) / largest_[0]);
  }
  /// Sites of the packet, if it is as wide behind its peak as ahead of it: those above a hundredth.
  std::size_t width() const {
    std::size_t k = 0;
    while (k + 1 < largest_.size() && amplitude(k + 1) > 0.01) ++k;
    return 2 * k + 1;
  }
  /// Largest amplitude on the ten sites behind the packet's window, relative to the peak.
  double tail() const { return std::sqrt(behind_ / largest_[0]); }

 private:
  std::vector<double> largest_ = std::vector<double>(2 * packet_half_width, 0.0);
  double behind_ = 0;
};

/// The height of the lower of two excitations, on the first five sites and about `peak`, over the highest wave in
/// between: both are visible if it exceeds one.
double prominence(const std::vector<double>& v, std::size_t peak);

}  // namespace lattice
