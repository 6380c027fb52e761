#pragma once
/**
# Momentum and action of a packet

What is conserved, or nearly, while a packet moves on its lattice? A shift of all beads by a site conserves nothing that
is a sum over beads, but a slowly changing pattern has two quantities that change slowly: a momentum, the generator of
shifts, and the action, the generator of the phase of the internal oscillation. Both are taken from the thirteen sites
around the strongest one. */

#include <cmath>
#include <complex>
#include <cstddef>
#include <deque>
#include <vector>

#include "sec34/wake.hpp"

namespace lattice {

/**
The *momentum* is that of the displacements, with a central difference,
$$P = -\sum_n \dot y_n\,\frac{y_{n+1}-y_{n-1}}2,$$
and its *current form* $-\frac12\sum_n(\dot y_ny_{n+1}-\dot y_{n+1}y_n)$ is the same sum in another order. As neighbours
oscillate almost in opposite phase, the slowly varying field is the *envelope* $(-1)^ny_n$. The momentum of that, with
the derivative of the band-limited function through its values, is
$$\Pi = \sum_n\dot y_n\sum_{m\ge1}\frac{y_{n+m}-y_{n-m}}m .$$
With the nearest neighbours alone, and half of their weight, it is $-P$.

The *action* is $J = \sum_n\langle\dot y_n^2\rangle/\Omega_n$. The frequency $\Omega_n$ of a bead comes from the angle
by which it turns in `cycle`, about one internal period, averaged over a stretch of time. For a breather it is
$\mathcal A/2\pi$. */
/// Half of that window.
inline constexpr std::size_t within = 6;

/// Means over one stretch of time.
struct Means {
  double t = 0, centre = 0;
  double speed = std::nan("");  ///< between the neighbouring stretches; nan for the first
  double energy = 0, action = 0, momentum = 0, current = 0, envelope = 0;
  double beads = 0;      ///< sum of the velocities
  double frequency = 0;  ///< mean over the beads, each with the share of its velocity squared
};
inline constexpr double cycle = 3.8;

/// Adds up what it sees, which is a state every so often, and takes the means of each stretch.
class Gauge {
 public:
  Gauge(const Chain& of, double time, std::size_t half = within);
  void operator()(const State<double>& now, const std::vector<double>& density, double centre);
  std::vector<Means> all{};

 private:
  std::size_t lag() const;
  void add_angle(const State<double>& now, std::size_t n);
  void close();

  std::size_t sites_, half_;
  double stretch_, looks_ = 0;
  Means sum_{};
  std::deque<State<double>> before_{};  // of one cycle
  std::vector<double> square_;
  std::vector<std::complex<double>> turned_;
};

/// The means along one run, over stretches of equal length; the last one is left out.
std::vector<Means> means_along(const WavesAbsorbed& impact, double step, double until,
                               std::size_t sites, double stretch, std::size_t half = within);

/**
How does $P$ change? Inserting Eq. (9), the terms of the velocities, of the linear part of the wells and half of those
of the contacts telescope to a flux through the two edges of the window. To the right it is
$$\Phi_n = \tfrac12\bigl(\dot y_{n-1}\dot y_n-y_{n-1}y_n-F_n\,(y_n-y_{n-1})\bigr),\qquad F_n = (y_{n-1}-y_n)_+^{3/2}.$$
What does not telescope are the terms by which a lattice differs from a homogeneous medium, with
$r_n = y_n-y_{n-1}$:
$$\sum_n s\,y_n^3\,\frac{y_{n+1}-y_{n-1}}2\quad\text{(wells)},\qquad
  \tfrac12\sum_n\bigl(F_{n+1}r_n-F_nr_{n+1}\bigr)\quad\text{(contacts)}.$$ */
struct Terms {
  double edges = 0, wells = 0, contacts = 0;
};

/// The momentum P of the sites from `first` to `last`, which have neighbours.
double momentum(const State<double>& now, std::size_t first, std::size_t last);
/// Its rate of change.
Terms rates(const Chain& chain, const State<double>& now, std::size_t first, std::size_t last);

/// The balance since a time: what the window has lost and gained, also by moving along.
struct Balance {
  double t = 0, change = 0, window = 0;
  Terms sum{};
  double residual() const { return change - window - sum.edges - sum.wells - sum.contacts; }
};

/// The site of the largest density.
std::size_t strongest(const std::vector<double>& density);

/// The balance from the time `from` on, every eight units of time.
std::vector<Balance> balance_along(const WavesAbsorbed& impact, double step, double from,
                                   double until, std::size_t sites);

}  // namespace lattice
