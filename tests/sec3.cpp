// Branches of breathers: what increases along them, as a whole or at every step, and where they begin.

#include "sec3/branches.hpp"

#include "support/estimates.hpp"

using namespace lattice;

TEST_CASE("the larger and the smaller of two count their error bars", "[unit]") {
  const Estimate wide{1.0, 0.3}, sharp{1.1, 0.05}, narrow{1.0, 0.05}, blurred{1.1, 0.3};
  CHECK(larger(wide, sharp).value == 1.0);
  CHECK(larger(sharp, narrow).value == 1.1);
  CHECK(smaller(narrow, blurred).value == 1.1);
  CHECK(smaller(narrow, sharp).value == 1.0);
}

TEST_CASE("what increases does so at every step, beyond its errors", "[unit]") {
  const auto increases = [](const std::vector<Estimate>& values) {
    return above("", least_ratio(values), 1).holds();
  };
  CHECK(increases({{1, 1e-3}, {2, 1e-3}, {2.1, 1e-3}}));
  CHECK_FALSE(increases({{1, 1e-3}, {3, 1e-3}, {2, 1e-3}, {4, 1e-3}}));
  CHECK_FALSE(increases({{1, 0.05}, {1.01, 0.05}}));
  CHECK_FALSE(increases({{1, 0}, {std::nan(""), 0}, {3, 0}}));
  CHECK_FALSE(increases({{1, 0}}));
  // A barrier that vanishes between two of its values, although its modulus grows from each to the next.
  CHECK(increases({{-1, 1e-3}, {-3, 1e-3}, {-9, 1e-3}}));
  CHECK_FALSE(increases({{-1, 1e-3}, {3, 1e-3}, {9, 1e-3}}));
}

TEST_CASE("a curve increases as a whole if its arches do", "[unit]") {
  const auto whole = [](std::vector<double> values) {
    std::vector<Estimate> curve;
    for (double v : values) curve.push_back({v, 1e-3});
    return above("arches", least_growth_of_arches(curve), 1).holds();
  };
  CHECK(whole({1, 2, -3, -5, -2, 4, 8, 6, -9, -20}));
  CHECK(whole({1, 2, 3}));
  CHECK_FALSE(whole({1, 3, 2}));           // one arch, not growing
  CHECK_FALSE(whole({20, 9, -6, -8, 4}));  // reversed
  CHECK_FALSE(whole({1, 2, -5, -4, 3, 6, -4, -7, 5}));
  CHECK_FALSE(whole({1, -1.0005, 3, 4}));  // within the errors
}

TEST_CASE("the size of a curve is the mean of its moduli, known from every second", "[unit]") {
  check_estimate(mean_size({{1, 0}, {2, 0}, {-3, 0}, {4, 0}}), 2.5, 0.5);
  check_estimate(mean_size({{1, 1}, {1, 1}}), 1, 1);
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
    return holds(within(compare(exponent(1.001), exponent(1.0005)), 1.95, 2.05));
  };
  CHECK(begins(2, 0));
  CHECK_FALSE(begins(0.5, 0));
  CHECK_FALSE(begins(2, 1e-3));
}
