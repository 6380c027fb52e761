#pragma once
/**
# Breathers at rest, and what moves them

A packet is compared with breathers at rest, which Newton's method finds, and forces on it are tried on them: contacts
that become stiffer along the chain, and waves on one side. */

#include <cstddef>
#include <vector>

#include "lattice/numerics/estimate.hpp"
#include "lattice/orbits/breather.hpp"

namespace lattice {

/// The bond-centred breathers of one well, at frequencies from 1.26 to 1.70.
struct AtRest {
  std::vector<Orbit<double>> orbits{};
  explicit AtRest(double s);
  double action(std::size_t k) const;
  /// Energy and frequency of the breather with the action J. Along the branch dE = omega dJ, so a parabola passes
  /// between two of them; the error is from every second one.
  Estimate energy(double J) const;
  Estimate frequency(double J) const;
};

/// What becomes of a breather by t = 200.
struct Exposed {
  double moved =
      0;  ///< displacement of its centre, from the first four internal periods to the last four
  double passed = 0;  ///< energy more than eight sites to its right
};

/// A bond-centred breather, or none, on contacts whose stiffness grows by the part `slope` from one to the next. With a
/// `seed` that is not zero, forty sites on its left, from the sixth neighbour of the bond on, oscillate with the
/// amplitude 0.15 and random phases.
Exposed exposed(const Orbit<double>* orbit, double s, double slope, unsigned long seed,
                double step);

}  // namespace lattice
