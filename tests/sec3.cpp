// Branches of breathers: where they begin.

#include "sec3/static_breathers.hpp"

#include "support/check.hpp"
#include "support/conditions.hpp"

using namespace lattice;

TEST_CASE("the larger and the smaller of two count their error bars", "[unit]") {
  const Estimate wide{1.0, 0.3}, sharp{1.1, 0.05}, narrow{1.0, 0.05}, blurred{1.1, 0.3};
  CHECK(larger(wide, sharp).value == 1.0);
  CHECK(larger(sharp, narrow).value == 1.1);
  CHECK(smaller(narrow, blurred).value == 1.1);
  CHECK(smaller(narrow, sharp).value == 1.0);
}

TEST_CASE("a family begins at rest only with the square of the detuning", "[unit]") {
  const auto at = [](double omega, double power, double rest) {
    Orbit<double> orbit;
    orbit.omega = omega;
    orbit.amplitude = rest + std::pow(omega - 1, power);
    return orbit;
  };
  const auto begins = [&](double power, double rest) {
    const auto exponent = [&](double omega) {
      return growth_exponent(at(omega, power, rest), at(1 + 2 * (omega - 1), power, rest));
    };
    return holds(within(with_error(exponent(1.001), exponent(1.0005)), 1.95, 2.05));
  };
  CHECK(begins(2, 0));
  CHECK_FALSE(begins(0.5, 0));
  CHECK_FALSE(begins(2, 1e-3));
}
