#pragma once
/**
# The site-centred breather over the plane of frequency and anharmonicity

Each node of a grid in $\omega_b$ and $s$ gets the breather and $\kappa$ of its translational pair. First the breathers
of the linear well are followed in $\omega_b$; from each of them we go up and down in $s$ until the family ends, which
for soft wells is near its fold. */

#include <cmath>
#include <vector>

#include "sec3/exchange.hpp"

namespace lattice {

/// A place of the plane with its breather, if there is one.
struct Node {
  PlanePoint spot{};
  Orbit<double> orbit{};
  double kappa = std::nan(""), kappa_error = std::nan("");  ///< the symplectic error
  bool exists() const { return std::isfinite(kappa); }
};
using Nodes = std::vector<Node>;   ///< of one frequency, from s = -1 to 1
using Chart = std::vector<Nodes>;  ///< from the lowest frequency on

/**
On the grid a tolerance of $10^{-12}$ is enough, since $\kappa$ is of the order of $10^{-9}$ or more nearly everywhere.
Beyond the end of a family Newton's method goes off to large and costly motions, so it gets only eight iterations. An
amplitude that changes by more than 15 per cent from one well to the next betrays another family. In hard wells up to
$s = 1$ no family ends, but a large breather changes quickly; there a step that is too long is halved. */
NewtonRule<double> chart_rule();

/// 80 frequencies from 1.01 to 2 and 25 wells; a quick one ends at 1.2, after three pairs of exchanges. Throws
/// NewtonFailed if a breather of the linear well is not found.
Chart chart(bool quick);

}  // namespace lattice
