#pragma once
// What all tests share: Catch2 in either major version, and a comparison that cannot be fooled by
// values that are not numbers.

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
#else
#include <catch2/catch.hpp>
#endif

#include <cmath>

/// Passes if both numbers are finite and agree to `absolute` or, relatively, to `relative`.
inline void check_close(double value, double expected, double absolute, double relative = 0) {
  CAPTURE(value, expected, absolute, relative);
  REQUIRE(std::isfinite(value));
  REQUIRE(std::isfinite(expected));
  const double difference = std::abs(value - expected);
  CHECK((difference <= absolute || difference <= relative * std::abs(expected)));
}
