#pragma once
// What tests of estimates share.

#include "support/check.hpp"
#include "support/conditions.hpp"

/// Passes if value and error are the expected ones.
inline void check_estimate(const lattice::Estimate& e, double value, double error,
                           double relative = 1e-9) {
  check_close(e.value, value, 1e-13, relative);
  check_close(e.error, error, 1e-13, relative);
}
