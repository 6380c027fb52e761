#pragma once
/**
# The soliton of the NLS equation, in the chain

The article's ansatz, Eq. (35), says that near $y_n = \epsilon A[\epsilon^2t, \epsilon(n-ct)]\,e^{i(qn-\omega t)} +
c.c.$ there is a solution of the chain for times up to $O(\epsilon^{-2})$, with an error $O(\epsilon^{3/2})$. In which
norm? Nothing is said. The natural norm is that of the energy, $\ell^2$ of displacements and velocities together, and
there the power is no accident: what the ansatz omits, above all the second harmonic, is of size $\epsilon^2$ on $O(1/\epsilon)$ sites, and
$$\Bigl(\epsilon^{-1}\,\epsilon^4\Bigr)^{1/2} = \epsilon^{3/2}.$$
The largest error of any bead should then go like $\epsilon^2$.

To see this we need an exact solution of Eq. (36), and take the soliton of Eq. (38): where $\Phi > 0$,
$$A = M\,\mathrm{sech}(\xi)\,e^{i\omega''\tau/2}, \qquad M^2 = -\omega''/h. $$ */

#include <cstddef>

#include "lattice/model/chain.hpp"
#include "sec4/instability.hpp"

namespace lattice {

/**
It runs on a ring with a whole number of wavelengths, $28/\epsilon$ sites or a little more, so that at the far side
$\mathrm{sech}\,\xi$ is below $2\cdot10^{-6}$. */
struct Soliton {
  PhaseOfWave phonon;        ///< its carrier
  double eps;                ///< of the ansatz
  Coefficients<double> nls;  ///< of Eq. (36) for this carrier
  std::size_t sites;         ///< of the ring
  /// The soliton of Eq. (38); `wavelength` is that of the carrier in sites.
  Soliton(const PhaseOfWave& of, std::size_t wavelength, double epsilon);

  /// The ring.
  Chain ring() const {
    return {sites, Quartic{phonon.s}, CompressedHertz{phonon.d}, Ends::periodic};
  }
  /// Displacements and velocities of the ansatz at time `t`.
  State<double> at(double t) const;
};

/// The largest distance of the chain from the ansatz, with which it starts, on its way.
struct AnsatzError {
  double l2 = 0;       ///< of displacements and velocities together
  double largest = 0;  ///< of any displacement or velocity
};

/// Up to the time `tau` / eps^2, in steps of at most `step`, looked at so often.
AnsatzError ansatz_error(const Soliton& soliton, double tau, double step, std::size_t looks);

}  // namespace lattice
