#pragma once
/**
# Integrations that take no notice of contact events

The force of a contact is not smooth where the contact opens or closes, and an integrator that steps across such an
event errs there. Two experiments of the article are repeated with such integrators: Newton's iteration for a
breather with an adaptive method, and a kick with fixed steps. */

#include <cstddef>

#include "sec33/kick_threshold.hpp"

namespace lattice {

/// The energy of the breather at which the iteration ends, and the residual that it leaves, relative to the amplitude.
struct UncorrectedEnd {
  double energy, residual;
};

/// Six iterations from the breather `start`, the period map by an adaptive Runge-Kutta method of order eight to
/// `tolerance`. The Jacobians are those of the exact breather, which affects only how fast the iteration converges.
UncorrectedEnd uncorrected_newton(const Shooting<double>& problem, const State<double>& start,
                                  double tolerance);

/// A kick of size `c`, followed with steps of a fixed length.
struct StepTrial {
  std::size_t which;       ///< of the breathers that are given
  double c, steps;         ///< size of the kick, and steps per period
  bool commensurate;       ///< whether that number is whole
  bool corrected = false;  /// for contact events, as in our own method of 14 stages

  /// The path of the energy centre up to `time`.
  Creep path(const RestingBreather& at, double time) const;
};

}  // namespace lattice
