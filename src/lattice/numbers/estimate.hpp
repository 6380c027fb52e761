#pragma once
/**
# A value with its error

Every number that leaves a program carries the difference of two computations of it. */

#include <cmath>

namespace lattice {

/// A value with the error from two resolutions.
struct Estimate {
  double value = 0, error = 0;
};

/// The finer of two results, with their difference as its error.
inline Estimate compare(double coarse, double fine) {
  return {fine, std::abs(fine - coarse)};
}

}  // namespace lattice
