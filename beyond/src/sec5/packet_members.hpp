#pragma once
/**
# A packet from site to site

How does one recognize a travelling breather? In the frame that turns with a free bead,
$z_n = e^{it}(y_n+i\dot y_n)$, it repeats itself one site further on after the shift time $T$ but for a phase,
$$z_n(t+T) = e^{-i\varphi}z_{n-1}(t).$$
In the DpS limit (dps_travelling.hpp) $T$ and $\varphi$ may be chosen freely, and on the family that we know
they fix energy and width. In the chain the breathers of the family that begins at $T = 2\pi k$
(travelling.hpp) have $\varphi = 2\pi k-T$. This file measures $T$, $\varphi$, energy and width of any packet, and tells
what energy and width a breather between these families has with the same $T$ and $\varphi$. */

#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

#include "lattice/numerics/estimate.hpp"
#include "sec5/driven_chain.hpp"

namespace lattice {

/// What a packet is on a stretch of its way: means of shift time and phase from site to site, means in time of
/// the energy, the geometric one, and of the participation number, on the seven sites about its peak.
struct Traveller {
  double shift_time = 0, phase = 0, energy = 0, width = 0;
};

/**
Packets of a train follow each other at a distance of six sites or more in our runs, and losses let the later ones
catch up. So a packet is what lies within three sites of its peak, and the peak is followed from sample to sample.
A packet comes to a site when the largest energy density nearby moves up to that site from two sites before.
Whenever the centre passes a bead we keep the time and the seven $z$ about it; interpolation between two samples
is linear, because $z$ changes slowly. */
/// Follows the packet number `which` to come to bead `from` until it has passed bead `to`; beads count from 1.
/// Throws std::invalid_argument if there is no room for it.
class TravellerWatch {
 public:
  TravellerWatch(const Chain& chain, std::size_t from, std::size_t to, std::size_t which = 1);
  /// Sees one sample; false if the packet has passed.
  bool look(const State<double>& now);
  /// Throws std::runtime_error if the packet has not passed.
  Traveller traveller() const;

 private:
  static constexpr std::size_t half_width = 3;  ///< sites of a packet on either side of its peak
  struct Crossing {
    double t;
    std::vector<std::complex<double>> z;
  };
  bool arrives(const std::vector<double>& density);
  Crossing seen(const State<double>& now) const;

  const Chain& chain_;
  std::size_t from_, to_, which_, wanted_, peak_ = 0, next_ = 0;
  bool before_ = false;
  double centre_ = 0, log_energy_ = 0, width_ = 0, samples_ = 0;
  State<double> last_{};
  std::vector<Crossing> crossings_{};
};

/// The beads between which a packet is watched, and which packet it is.
struct WatchedBeads {
  std::size_t from = 12, to = 28, which = 1;
};

/// Runs a chain from `start` until the packet has passed. Throws std::runtime_error if it has not within `duration`.
Traveller traveller_on(const DrivenChain& driven, State<double> start, double duration, double step,
                       const WatchedBeads& stretch);

/**
The oscillation within a packet makes all means fluctuate, and a packet changes on its way. So it is looked at on the
whole stretch, on another one with coarser steps, and on either half of the stretch. */
struct Looks {
  Traveller fine, coarse, before, after;

  /// A function of the packet; its error is the change from the coarser look, or half of that from half to half.
  template <class Of>
  Estimate operator()(Of of) const {
    Estimate e = compare(of(coarse), of(fine));
    const double halves = std::abs(of(after) - of(before)) / 2;
    if (std::isnan(halves) || halves > e.error) e.error = halves;
    return e;
  }
};

/**
## Breathers of the same shift time and phase

The families have members at $T+\varphi = 2\pi k$ only, a packet has any $T$. But the scaled energy $ET^4$ and the
width, which in the DpS limit depend on $\varphi$ alone, change smoothly with $1/T$. So a grid of members, for some $k$
and some $\varphi$, and polynomials in $1/T$ and then in $\varphi$ tell what lies between them. Four digits are
enough here, so Newton's method may stop early. */
struct MemberGrid {
  std::vector<double> phases{};
  std::vector<std::vector<Traveller>> members{};  ///< one row a phase, one entry a family
};

/// The members with these phases, which ascend and contain 0, of the families from `slowest` down to `fastest`; each
/// is seen while it moves on by two sites. Throws NewtonFailed.
MemberGrid member_grid(std::size_t fastest, std::size_t slowest, const std::vector<double>& phases);

/// The breather with shift time and phase of `p`; the `left_out` farthest points of each polynomial are not used.
Traveller member_like(const MemberGrid& grid, const Traveller& p, std::size_t left_out = 0);

/// (T + phi) / 2 pi, whole for a breather that repeats itself one site further on.
double family_of(const Traveller& p);

/// Families 2 to 5 with six phases; between them no ratio is nan.
struct Families {
  MemberGrid grid = member_grid(2, 5, {-0.4, -0.2, 0, 0.25, 0.5, 0.75});

  /// Energy or width of a packet over that of the breather with its shift time and phase.
  double over(const Traveller& p, double Traveller::*of, std::size_t left_out = 0) const;
  /// From four looks; the change that leaving out the farthest members makes is added to the error.
  Estimate ratio(const Looks& looks, double Traveller::*of) const;
};

}  // namespace lattice
