#include "sec34/decorrelation.hpp"

#include <cmath>

namespace lattice {

Estimate decorrelation_of(double coarse, double fine) {
  if (!std::isfinite(coarse) || !std::isfinite(fine)) return {std::nan(""), std::nan("")};
  Estimate when = compare(coarse, fine);
  when.error += comparison_interval;
  return when;
}

}  // namespace lattice
