#include "sec2/mean_force.hpp"

namespace lattice {

MeanForces averages(const std::vector<double>& x, std::size_t n, double duration) {
  const auto part = [&](std::size_t first, std::size_t count) {
    return std::vector<double>(x.begin() + std::ptrdiff_t(first),
                               x.begin() + std::ptrdiff_t(first + count));
  };
  MeanForces means{part(2 * n, n + 1), part(3 * n + 1, n), State<double>(n)};
  for (auto* all : {&means.contact, &means.well})
    for (double& value : *all) value /= duration;
  means.end.y = part(0, n);
  means.end.v = part(n, n);
  return means;
}

}  // namespace lattice
