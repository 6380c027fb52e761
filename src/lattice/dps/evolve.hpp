#pragma once
/**
# The DpS equation in time

The right-hand side of the DpS equation (dps.hpp) is smooth except where two neighbours coincide, so GSL's
adaptive method of order eight can integrate it (reference.hpp).

Near a stationary state $v_n = u_ne^{i\mu t}$ (stationary.hpp) most of the work would go into turning with the frequency
$\mu$. With $v_n = w_ne^{i\mu t}$ the equation gains a term, $i\dot w_n = \mu w_n + \dots$, and the integrator has only the
perturbation left to follow: at equal tolerance it needs half the time and keeps the norm some hundred times better. */

#include <cstddef>
#include <functional>
#include <vector>

#include "lattice/diagnostics/path.hpp"
#include "lattice/gsl/reference.hpp"
#include "lattice/model/dps.hpp"
#include "lattice/numerics/observer.hpp"

namespace lattice {

/// The DpS equation in the frame that turns with e^{i mu t}, and at mu = 0 the equation itself.
struct RotatingDps {
  Dps dps;
  double mu;  ///< frequency of the frame, per unit of slow time

  /// Writes dw/dtau into `dw`, real and imaginary parts alternating as in Dps.
  void operator()(double tau, const double* w, double* dw) const;
};

/// Real and imaginary parts alternating, the form in which the integrator carries a field.
std::vector<double> interleaved(const Field& field);

/// Sees a run at its samples: the slow time and the field.
using DpsObserver = Observer<double, Field>;

/// Carries `field` over the slow time `duration` and calls `observe` at the start and after each of
/// `samples` equal intervals; returns the largest relative change of the norm. `equation` is a Dps or a
/// RotatingDps. Throws std::runtime_error if GSL cannot go on.
double evolve_dps(const Rhs& equation, Field& field, double duration, std::size_t samples,
                  const Tolerance& tolerance, const DpsObserver& observe = {});

/**
## An impact

That of impact.hpp in the limit of small amplitude, Eq. (25): $A_1(0) = -i$ and all others zero. The packet is followed
in the density $|A_n|^2$ and the slow time. */
/// The path of the packet, the field at the end, and how far the norm drifts on the way.
struct DpsOutcome {
  Path path;  ///< its energy is the norm in the window
  Field end;
  double norm_drift = 0;  ///< relative
  double far_end = 0;     ///< largest |A_n| of the last site that a sample saw
};

/// Follows the packet that leaves the struck field `start`; `watch` sees every sample. Throws
/// std::runtime_error if GSL cannot go on.
DpsOutcome follow_dps(const Dps& dps, const Field& start, double duration, std::size_t samples,
                      const Tolerance& tolerance, const DpsObserver& watch = {});

/// The largest maximum in time of |A_n|, which oscillates from site to site, while the centre moves over the last site of
/// its path, or over the last two if none falls on the last. Its error is what the samples leave; both are nan where
/// there is none at all.
Estimate packet_amplitude(const Path& path);

}  // namespace lattice
