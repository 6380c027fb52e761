#pragma once
/**
# Envelopes

Under precompression a packet is a wave, the carrier, with a slowly varying amplitude, its envelope. If the
motion is nearly harmonic with frequency $\omega$, velocity and acceleration are a quarter of a period
apart, and
$$a_n = \sqrt{v_n^2 + (\ddot y_n/\omega)^2}, \qquad
  \omega^2 = \sum \ddot y_n^2 \Big/ \sum v_n^2$$
is the amplitude of the velocity at site $n$, free of the carrier. A soliton of the NLS equation (nls.hpp)
has the envelope $a\,\mathrm{sech}((n-n_0)/w)$, Eq. (38). How far a packet is from that form is seen from
the residual of a least-squares fit. */

#include <cmath>
#include <cstddef>
#include <vector>

#include "lattice/model/chain.hpp"

namespace lattice {

/// The sites within `half_width` of `peak`.
Window around(std::size_t peak, std::size_t half_width, std::size_t sites);

/**
Among phonons the largest single density need not belong to the packet. So we look for the site around
which all sites within `half_width` together hold the most energy. */
std::size_t richest(const std::vector<double>& e, std::size_t half_width);

/**
The frequency of the carrier is that of the packet and not of the waves behind it, so it is taken from the
sites of `range`; with it the amplitude of the velocity is computed everywhere. */
struct Envelope {
  double omega = 0;                 ///< of the carrier
  std::vector<double> amplitude{};  ///< of the velocity, one entry per site
};

/// Frequency of the carrier in `range` and amplitudes of all sites.
Envelope envelope(const Chain& chain, const State<double>& state, Window range);

/**
The soliton's form has three parameters: height, centre (sites counted from one) and width. What it does
not explain of an envelope is the `residual`, the root mean square deviation relative to the height. */
struct Sech {
  double height = 0, centre = 0, width = 0, residual = 0;
  /// Its value at site n, counted from one.
  double at(double n) const { return height / std::cosh((n - centre) / width); }
};

/**
The three parameters follow by the Gauss–Newton method. With $\nabla f$ the derivatives of the sech $f$
with respect to height, centre and width, its matrix $m$ is the sum of $\nabla f\,\nabla f^T$ over the
sites, its right-hand side $g$ that of $\nabla f\,(a_n - f)$. The matrix has three rows, so Cramer's rule
will do.

`fit_sech` returns the sech that fits the values `a` in `range` best. The iteration starts at their maximum
with the given `width`. A step that does not lessen the misfit is halved; if no part of it does, we have
arrived. */
Sech fit_sech(const std::vector<double>& a, Window range, double width);

}  // namespace lattice
