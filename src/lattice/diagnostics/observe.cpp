#include "lattice/diagnostics/observe.hpp"

#include <algorithm>
#include <numeric>

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

}  // namespace lattice
