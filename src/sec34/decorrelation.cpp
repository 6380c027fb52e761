#include "sec34/decorrelation.hpp"

#include <algorithm>
#include <cmath>

namespace lattice {

Estimate decorrelation_of(double coarse, double fine) {
  if (!std::isfinite(coarse) || !std::isfinite(fine)) return {std::nan(""), std::nan("")};
  Estimate when = compare(coarse, fine);
  when.error += comparison_interval;
  return when;
}

// As often as any refinement halves its step (refinement.hpp)
std::optional<Estimate> decorrelation_to(const EventCorrected& largest, double velocity,
                                         double delta, const Chain& chain, double time) {
  const auto parted = [&](int one, int other) {
    EventCorrected first = largest, second = largest;
    first.halvings += one, first.finer += one;
    second.halvings += other, second.finer += other;
    return decorrelation_of_impacts(first, velocity, second, velocity * (1 + delta), chain, time);
  };
  double coarse = parted(0, 0);
  for (int k = 0; k < usual_halvings; ++k) {
    const double fine = parted(k + 1, k + 1);
    const auto [least, most] = std::minmax({coarse, parted(k, k + 1), fine});
    const double spread = least == most ? 0 : most - least;
    if (spread <= 1.01 * comparison_interval) return Estimate{fine, spread + comparison_interval};
    coarse = fine;
  }
  return {};
}

}  // namespace lattice
