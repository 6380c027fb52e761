#pragma once
/**
# What errors of the monodromy matrix do to the multipliers next to +1

In an inaccurate matrix $M$ one cannot say which of the four eigenvalues next to $+1$ belong together. But a symmetric
function of the four gives $\kappa$ of the pinning pair without an assignment, since the other pair is $+1$ twice:
$$\kappa \simeq \frac18\sum_{k=1}^4\frac{(\lambda_k-1)^2}{\lambda_k}.$$ */

#include "lattice/orbits/floquet.hpp"
#include "report/table.hpp"

namespace lattice {

/// How far the four multipliers are from where they belong.
struct Displaced {
  double multipliers = 0;  ///< the farthest of them, from the nearest of +1 and the pinning pair
  double modulus = 0;      ///< their largest distance from the circle
  double kappa = 0;        ///< error of kappa from the symmetric function
};

/// Of the matrix M of a breather whose pinning pair has this `kappa`.
Displaced displaced(const Matrix<double>& M, double kappa);

/// The rows of a table: the same after uniform noise of three sizes is added to M, the geometric means over eight draws,
/// of the modulus the largest; `slope` is that of kappa in s. The errors are differences from a coarser M.
void add_noise(Table& table, const Shooting<double>& problem, const Orbit<double>& breather,
               const Estimate& slope);

}  // namespace lattice
