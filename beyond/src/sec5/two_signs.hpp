#pragma once
/**
# Two waves of one exponent, and which of them has the larger quotient

A wave of type I is computed on two grids, whose difference is its error. At $k = 1$ the waves of both signs differ so
little at small exponents that they need denser grids than each of them by itself: unless $2\alpha$ is an integer the
force is not analytic on the panels. The error of the difference of their quotients is that of the grids, but at least
the rounding of two quotients. Beside it we put $\kappa$ of the internal phase of both, negative where the phase is
pinned. It follows from the multipliers of the lattice's flow (travelling.hpp). Unless $2\alpha$ is an integer the force
is not analytic in the root of the time since a contact has closed either, and the flow has to be content with a larger
tolerance.

Where the difference, or $\kappa$, changes its sign between two exponents its zero is found on both grids. */

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "lattice/numerics/estimate.hpp"
#include "sec5/kernel_wave.hpp"

namespace lattice {

/// A coarse and a fine grid.
using TwoGrids = std::array<WaveGrid, 2>;
constexpr TwoGrids usual_grids{WaveGrid{16, 0.5}, {20, 0.4}},
    dense_grids{WaveGrid{24, 0.5}, {32, 0.4}};

/// A wave of type I on both.
struct TwoGridWave {
  std::size_t k;
  int sign;
  double alpha;
  std::array<KernelWave, 2> grids;  ///< coarse and fine

  /// A function or a member of the wave, with its error.
  template <class Of>
  Estimate operator()(Of of) const {
    return with_error(double(std::invoke(of, grids[0])), double(std::invoke(of, grids[1])));
  }
  const KernelWave& fine() const { return grids[1]; }
};

/// The wave with k oscillations a site, the sign of the central velocity and the exponent of the contacts.
TwoGridWave wave_on_two_grids(std::size_t k, int sign, double alpha,
                              const TwoGrids& grids = usual_grids);

/// Both signs at k = 1 and one exponent.
struct TwoSigns {
  double alpha;
  TwoGridWave plus, minus;
  Estimate kappa_plus, kappa_minus;  ///< nan below alpha = 3/2, where they are rounding

  /// Relative difference of the quotients, plus minus minus.
  Estimate difference() const;
};

/// Both signs at each of these exponents.
std::vector<TwoSigns> compare_signs(const std::vector<double>& alphas);

/// The neighbours, from large exponents to small, between which the quotients exchange their order, each difference being
/// ten times its error.
std::vector<std::size_t> exchanges_among(const std::vector<TwoSigns>& all);

/// The exponent between two of the list at which the quotients exchange their order.
Estimate exchange_of_quotients(const TwoSigns& low, const TwoSigns& high);

/// That at which kappa of one sign changes its own.
Estimate exchange_of_stability(const TwoSigns& low, const TwoSigns& high, int sign);

}  // namespace lattice
