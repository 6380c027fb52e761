#pragma once
/**
# Mean forces

The argument of section 2 is an average. Integrate the equation of motion of bead $n$ over a time $T$ and
divide by $T$:
$$\frac{\mu_n}{T}\bigl[\dot y_n\bigr]_0^T = \bar F_{n-1} - \bar F_n - \overline{W'(y_n)},\qquad
  \bar F_n = \frac1T\int_0^T f_n\,dt,$$
with the push $f_n \ge 0$ of bead $n$ on bead $n+1$. In a periodic motion the left side vanishes over a
period. The means are integrated along with the motion, by the adaptive integrator of GSL: a route that shares
nothing with the one by which our orbits are found. */

#include <algorithm>
#include <cstddef>
#include <vector>

#include "lattice/gsl/gsl_ode.hpp"
#include "lattice/model/chain.hpp"

namespace lattice {

/// Time averages over a run, and where it ended.
struct MeanForces {
  std::vector<double> contact;  ///< sites + 1 entries, as the contacts of boundary.hpp
  std::vector<double> well;     ///< of W'(y_n), one entry per site
  State<double> end;

  /// Difference of the largest and the least of the contacts from `first` to `last`.
  double spread(std::size_t first, std::size_t last) const {
    const auto [least, most] = std::minmax_element(contact.begin() + std::ptrdiff_t(first),
                                                   contact.begin() + std::ptrdiff_t(last) + 1);
    return *most - *least;
  }
  /// Largest violation of F_(n-1) - F_n = W_n over all beads.
  double imbalance() const {
    double most = 0;
    for (std::size_t n = 0; n < well.size(); ++n)
      most = std::max(most, std::abs(contact[n] - contact[n + 1] - well[n]));
    return most;
  }
};

/**
The integrals are further unknowns of the same system of equations, $4N+1$ in all: positions, velocities, integrals
of the pushes and of the forces of the wells. Throws std::runtime_error if GSL cannot go on. */
/// Averages over `duration`; `chain` has `sites`, `well`, `mass_of(n)`, `contact_push(chain, y, i)`.
template <class AnyChain>
MeanForces mean_forces(const AnyChain& chain, const State<double>& start, double duration,
                       const Tolerance& tolerance) {
  const std::size_t n = chain.sites;
  std::vector<double> x(4 * n + 1, 0);
  std::copy(start.y.begin(), start.y.end(), x.begin());
  std::copy(start.v.begin(), start.v.end(), x.begin() + std::ptrdiff_t(n));
  const auto rhs = [&](double, const double* z, double* dz) {
    for (std::size_t i = 0; i <= n; ++i) dz[2 * n + i] = contact_push(chain, z, i);
    for (std::size_t i = 0; i < n; ++i) {
      const double pull = -chain.well.force(z[i]);
      dz[3 * n + 1 + i] = pull;
      dz[i] = z[n + i];
      dz[n + i] = (dz[2 * n + i] - dz[2 * n + i + 1] - pull) / chain.mass_of(i);
    }
  };
  Reference reference(rhs, x.size(), tolerance);
  double t = 0;
  reference.advance(t, duration, x);
  const auto part = [&](std::size_t first, std::size_t count, double over) {
    std::vector<double> out(x.begin() + std::ptrdiff_t(first),
                            x.begin() + std::ptrdiff_t(first + count));
    for (double& value : out) value /= over;
    return out;
  };
  MeanForces means{part(2 * n, n + 1, duration), part(3 * n + 1, n, duration), State<double>(n)};
  means.end.y = part(0, n, 1);
  means.end.v = part(n, n, 1);
  means.end.t = start.t + duration;
  return means;
}

}  // namespace lattice
