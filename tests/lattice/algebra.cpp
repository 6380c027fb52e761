// Dense matrices.

#include "lattice/algebra/dense.hpp"

#include "support/check.hpp"

using namespace lattice;

TEST_CASE("the singular values of a matrix with more rows than columns, by hand",
          "[unit][formulas]") {
  Matrix<double> tall(3, 2);
  tall << 3, 0, 4, 0, 0, 0.5;
  const Softness soft = condition_of(tall);
  check_close(soft.condition, 10, 1e-14, 1e-14);
  check_close(std::abs(soft.softest[1]), 1, 1e-14);
  check_close(soft.softest[0], 0, 1e-14);
}

TEST_CASE("products of large matrices are cut in the same way on every processor", "[unit]") {
  // Eigen would ask the processor for its caches, and would sum in another order where they are larger
#if defined(__x86_64__)
  CHECK(Eigen::l1CacheSize() == 32 << 10);
  CHECK(Eigen::l2CacheSize() == 256 << 10);
  CHECK(Eigen::l3CacheSize() == 2 << 20);
#endif
}
