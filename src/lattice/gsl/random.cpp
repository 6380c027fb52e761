#include "lattice/gsl/random.hpp"

namespace lattice {

Random::Random(unsigned long seed) : source_(gsl_rng_alloc(gsl_rng_mt19937)) {
  gsl_rng_set(source_.get(), seed);
}

double Random::uniform(double lo, double hi) {
  return lo + (hi - lo) * gsl_rng_uniform(source_.get());
}

std::vector<double> shaken(std::vector<double> x, double relative, unsigned long seed) {
  Random random(seed);
  for (double& value : x) value *= 1 + random.uniform(-relative, relative);
  return x;
}

}  // namespace lattice
