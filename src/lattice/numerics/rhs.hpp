#pragma once
/**
# The right-hand side of an equation

All methods for ordinary differential equations that do not know of the chain ask for the same thing. */

#include <functional>

#include "lattice/numerics/ieee.hpp"

namespace lattice {

/// The right-hand side f of an equation: writes dx/dt into `dx`, given `t` and `x`.
using Rhs = std::function<void(double t, const double* x, double* dx)>;

}  // namespace lattice
