#pragma once
/**
# Random numbers

Some runs begin with a randomly perturbed state. The perturbations are drawn from GSL's Mersenne twister,
whose seed is recorded with every result: the same seed gives the same numbers on every machine, which the
distributions of the C++ library do not promise. */

#include <gsl/gsl_rng.h>

#include <memory>
#include <vector>

#include "lattice/numerics/ieee.hpp"

namespace lattice {

/// A source of random numbers with a recorded seed.
class Random {
 public:
  /// Equal seeds give equal numbers.
  explicit Random(unsigned long seed);
  /// Uniformly distributed in [lo, hi).
  double uniform(double lo, double hi);

 private:
  struct Free {
    void operator()(gsl_rng* source) const { gsl_rng_free(source); }
  };
  std::unique_ptr<gsl_rng, Free> source_;
};

/// `x` with each entry changed by a random share of itself, at most `relative`.
std::vector<double> shaken(std::vector<double> x, double relative, unsigned long seed);

}  // namespace lattice
