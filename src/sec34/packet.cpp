#include "sec34/packet.hpp"

#include <numbers>
#include <stdexcept>

namespace lattice {

double change_between_halves(const Path& path, const std::vector<double>& series) {
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
double energy_change(const Path& path) {
  return change_between_halves(path, path.all(&PathSample::energy));
}

// The strongest window behind the packet, at least one width clear of it
double residue(const std::vector<double>& e, std::size_t peak) {
  const std::size_t m = packet_half_width;
  double most = 0;
  for (std::size_t n = m; n + 4 * m < peak; ++n) most = std::max(most, window_sum(e, n));
  return most / window_sum(e, peak);
}

// With the velocity v the bead was at zero the time y/v ago
void Oscillation::add(double t, double y, double v) {
  if (y >= 0 && last_ < 0) passages_.push_back(t - y / v);
  amplitude_ = std::max(amplitude_, std::abs(y));
  last_ = y;
}

double Oscillation::frequency() const {
  if (passages_.size() < 2) throw std::runtime_error("a bead that does not oscillate");
  const double periods = double(passages_.size()) - 1;
  return 2 * std::numbers::pi * periods / (passages_.back() - passages_.front());
}

double free_frequency(double s, double A) {
  const double q = std::sqrt(1 + s * A * A / 2), k = std::sqrt(-s / 2) * A / q;
  return std::numbers::pi * q / (2 * std::comp_ellint_1(k));
}

// The lower of two peaks, at the end and around the packet, over the highest wave in between
double prominence(const std::vector<double>& v, std::size_t peak) {
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
