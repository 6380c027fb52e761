#pragma once
/**
# Random numbers

GSL's Mersenne twister, whose seed is recorded with every result: the same seed gives the same numbers on every machine,
which the distributions of the C++ library do not promise. */

#include <gsl/gsl_rng.h>

#include <memory>
#include <vector>

#include "lattice/numerics/ieee.hpp"

namespace lattice {

/// A source of random numbers with a recorded seed.
class Random {
 public:
  /// Equal seeds give equal numbers.
  explicit Random(unsigned long seed) : source_(gsl_rng_alloc(gsl_rng_mt19937)) {
    gsl_rng_set(source_.get(), seed);
  }
  /// Uniformly distributed in [lo, hi).
  double uniform(double lo, double hi) { return lo + (hi - lo) * gsl_rng_uniform(source_.get()); }

 private:
  struct Free {
    void operator()(gsl_rng* source) const { gsl_rng_free(source); }
  };
  std::unique_ptr<gsl_rng, Free> source_;
};

/// `x` with each entry changed by a random share of itself, at most `relative`.
inline std::vector<double> perturbed(std::vector<double> x, double relative, unsigned long seed) {
  Random random(seed);
  for (double& value : x) value *= 1 + random.uniform(-relative, relative);
  return x;
}

}  // namespace lattice
