#pragma once
/**
# What is measured of a packet

How much energy it keeps on its way, what it leaves behind, how wide it is, and whether it stands out of the waves
around it. */

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "lattice/diagnostics/path.hpp"
#include "lattice/numerics/estimate.hpp"

namespace lattice {

/// Relative change of the mean of `series`, one entry a sample, from the first half of the packet's way to the second;
/// the means remove its pulsation. Throws std::runtime_error if fewer than six samples lie beyond `fit_from`.
inline double change_between_halves(const Path& path, const std::vector<double>& series) {
  const std::size_t end = path.size();
  std::size_t begin = 0;
  while (begin < end && path[begin].centre < fit_from) ++begin;
  if (end < begin + 6) throw std::runtime_error("no packet passes site 20");
  const std::size_t half = (begin + end) / 2;
  const auto mean = [&](std::size_t from, std::size_t until) {
    double sum = 0;
    for (std::size_t i = from; i < until; ++i) sum += series[i];
    return sum / double(until - from);
  };
  return mean(half, end) / mean(begin, half) - 1;
}
/// That of the packet's energy.
inline double energy_change(const Path& path) {
  return change_between_halves(path, path.all(&PathSample::energy));
}

/// The largest energy in a window behind the packet, at least one width clear of it, over that around `peak`.
inline double residue(const std::vector<double>& e, std::size_t peak) {
  const std::size_t m = packet_half_width;
  double most = 0;
  for (std::size_t n = m; n + 4 * m < peak; ++n) most = std::max(most, window_sum(e, n));
  return most / window_sum(e, peak);
}

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

/// The oscillation of one bead: the times at which it passes zero upwards, and its largest displacement.
class Oscillation {
 public:
  void add(double t, double y, double v) {
    if (y >= 0 && last_ < 0) passages_.push_back(t - y / v);  // at zero the time y/v ago
    amplitude_ = std::max(amplitude_, std::abs(y));
    last_ = y;
  }
  /// Mean frequency between the first and the last passage. Throws std::runtime_error if there are less than two.
  double frequency() const {
    if (passages_.size() < 2) throw std::runtime_error("a bead that does not oscillate");
    const double periods = double(passages_.size()) - 1;
    return 2 * std::numbers::pi * periods / (passages_.back() - passages_.front());
  }
  double amplitude() const { return amplitude_; }

 private:
  std::vector<double> passages_{};
  double amplitude_ = 0, last_ = 0;
};

/// Frequency of a free bead in the well y^2/2 + s y^4/4, s <= 0, that oscillates between -A and A: with the complete
/// elliptic integral K, it is pi q / (2 K(k)), where q^2 = 1 + s A^2/2 and k^2 = -s A^2/(2 q^2).
inline double free_frequency(double s, double A) {
  const double q = std::sqrt(1 + s * A * A / 2), k = std::sqrt(-s / 2) * A / q;
  return std::numbers::pi * q / (2 * std::comp_ellint_1(k));
}

/// The height of the lower of two excitations, on the first five sites and about `peak`, over the highest wave in
/// between: both are visible if it exceeds one.
inline double prominence(const std::vector<double>& v, std::size_t peak) {
  const auto height = [&](std::size_t from, std::size_t to) {
    double most = 0;
    for (std::size_t n = from; n < std::min(to, v.size()); ++n)
      most = std::max(most, std::abs(v[n]));
    return most;
  };
  const std::size_t near = 5, m = packet_half_width, behind = peak > m ? peak - m : 0;
  const double between = height(near + m, behind), packet = height(behind, peak + m + 1);
  return std::min(height(0, near), packet) / between;
}

}  // namespace lattice
