#pragma once
// What tests of estimates and of criteria share.

#include <functional>
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

/// `make(x)` holds a little on this side of `bound` and fails, by this name, on the other.
inline void bounded_by(double bound, bool below, const std::string& name,
                       const std::function<lattice::Criterion(double)>& make) {
  CAPTURE(bound, name);
  CHECK(failing(make(bound * (below ? 0.99 : 1.01))).empty());
  CHECK(failing(make(bound * (below ? 1.01 : 0.99))) == name);
}
