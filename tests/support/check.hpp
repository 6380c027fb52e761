#pragma once
// What all tests share: Catch2 in either major version, and a comparison that cannot be fooled by
// values that are not numbers; what is said of something that is refused.

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
#else
#include <catch2/catch.hpp>
#endif

#include <cmath>
#include <exception>
#include <string>

/// Passes if both numbers are finite and agree to `absolute` or, relatively, to `relative`.
inline void check_close(double value, double expected, double absolute, double relative = 0) {
  CAPTURE(value, expected, absolute, relative);
  REQUIRE(std::isfinite(value));
  REQUIRE(std::isfinite(expected));
  const double difference = std::abs(value - expected);
  CHECK((difference <= absolute || difference <= relative * std::abs(expected)));
}

/// How the residuals of a problem change with the unknown `k`, from a step `h` to either side.
template <class Problem, class Unknowns>
Unknowns slope_along(const Problem& problem, const Unknowns& x, long k, double h) {
  Unknowns up = x, down = x;
  up[k] += h, down[k] -= h;
  return (problem.evaluate(up, {}, false).residual - problem.evaluate(down, {}, false).residual) /
         (2 * h);
}

/// What is said when `make` is refused with such an error; nothing if it is not.
template <class Error = std::exception, class Make>
std::string refusal(Make make) {
  try {
    make();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// Passes if `text` is one line that has `part`.
inline void check_line(const std::string& text, const std::string& part) {
  CAPTURE(text, part);
  CHECK(text.find(part) != std::string::npos);
  CHECK(text.find('\n') == std::string::npos);
  CHECK(text.size() < 300);
}
