#pragma once
/**
# One travelling breather of the DpS equation with your own parameters

`sec5_travelling_packets orbit --alpha 2` computes a travelling breather of the DpS equation (dps_travelling.hpp),
$A_n(\tau+T) = e^{i\varphi}A_{n-1}(\tau)$, for contacts whose force has the exponent $\alpha$. With the angle
$\varphi = 0$ it is exact. With any other angle one equation is left out and missed by $V\sin(\varphi/2)$, which
vanishes where $\sum_nA_n = iV$ does: the command tells by how much such a member misses itself and what it leaves
behind, and fails where it misses itself by more than a hundredth of its amplitude. The shift time $T$ only scales the
field. It prints amplitude, norm, energy, the sum, the tail and the residual, all dimensionless and at $\tau = 0$. The
error is the difference from a member that was found at ten times the tolerance in a window with two sites less on
either side. */

#include <utility>

#include "report/program.hpp"
#include "sec5/dps_travelling.hpp"

namespace lattice {

/// The command: which member, in two windows, its tables.
struct DpsOrbit {
  static constexpr Title title{"orbit", "one travelling breather of the DpS equation"};
  double alpha = 1.5;                       ///< exponent of the contact force
  double phase = 0;                         ///< varphi, from site to site
  double time = DpsTravelling::shift_time;  ///< from site to site
  bool as_profile = false;                  ///< whether `table` is the profile

  /// Declares them.
  void parameters(Parameters& p);

  /// A member with the shift time 2 pi and its problem.
  using Member = std::pair<DpsTravelling, DpsMember>;
  struct Found {
    Member coarse, fine;
  };
  /// Both windows. Throws NewtonFailed, and std::runtime_error if the field is no travelling breather.
  Found find() const;
  /// Rows `quantity,value,error,unit,kind,meaning,reason`.
  Table quantities(const Found& found) const;
  /// The field at tau = 0, site by site.
  Table profile(const Found& found) const;
  /// What the program prints.
  Table table() const;

 private:
  double scale() const;
};

}  // namespace lattice
