#pragma once
// What tests of estimates and of criteria share.

#include <string>

#include "check.hpp"
#include "lattice/numerics/criterion.hpp"

/// Passes if value and error are the expected ones.
inline void check_estimate(const lattice::Estimate& e, double value, double error,
                           double relative = 1e-9) {
  check_close(e.value, value, 1e-13, relative);
  check_close(e.error, error, 1e-13, relative);
}

/// The names of the conditions that fail.
inline std::string failing(const lattice::Criterion& criterion) {
  std::string names;
  for (const lattice::Condition& c : criterion)
    if (!c.holds()) names += (names.empty() ? "" : " ") + c.name;
  return names;
}
