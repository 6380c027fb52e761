#pragma once
/**
# The solitary wave of a chain without wells

Beads without wells that touch with the force $\delta^\alpha$, where $\delta = (y_{n-1}-y_n)_+$ is the
overlap, carry a solitary wave. In units in which mass and speed are one its overlap is a function
$\delta(\xi)$ of $\xi = n-t$ with
$$\delta''(\xi) = f(\xi+1)-2f(\xi)+f(\xi-1),\qquad f = \delta^\alpha,$$
and integrating twice gives an equation without derivatives,
$$\delta(\xi) = \int_{-1}^1(1-|s|)\,f(\xi-s)\,ds .$$
The equation is solved on a periodic grid, where the kernel multiplies the Fourier coefficient of the wave
number $k$ by $(\sin\frac k2/\frac k2)^2$. The solution is smooth and falls off double-exponentially, so that
sixteen points for each site and six sites on either side give twelve digits.

Iterated as it stands the equation drives every guess to zero or to infinity, since it is homogeneous of degree
$\alpha$. Petviashvili's factor removes this: each iterate is multiplied by
$(\langle\delta,\delta\rangle/\langle\delta,\delta_{\rm new}\rangle)^{\alpha/(\alpha-1)}$. */

#include <cstddef>
#include <vector>

namespace lattice {

/// The wave of speed one on a grid, and the integrals that other authors print. Its other speeds follow from
/// the scaling of the equation.
struct SolitaryWave {
  double h = 0;                    ///< distance of two points, in sites
  std::vector<double> overlap{};   ///< from the crest on, to the end of the window
  std::vector<double> velocity{};  ///< of a bead, from the crest on
  double shift = 0;                ///< of every bead, from before the wave to after it
  double kinetic = 0;              ///< kinetic energy, averaged over a site
  double potential = 0;            ///< energy of the contacts, averaged over a site

  /// Share of the kinetic energy.
  double kinetic_share() const { return kinetic / (kinetic + potential); }
  /// The whole width, in sites, where the velocity is the fraction `level` of its largest value.
  double width(double level) const;
};

/// The wave for the exponent `alpha` > 1 with `points` for each site and `half_width` sites on either side. Throws
/// std::runtime_error if the iteration does not converge.
SolitaryWave solitary_wave(double alpha, std::size_t points, std::size_t half_width);

}  // namespace lattice
