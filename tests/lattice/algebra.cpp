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
