#pragma once
/**
# From the chain to the array

Experiments count in milliseconds, hertz and micrometres. These are the conversions for the homogeneous array
of section 3.6 (cantilever.hpp), whose chain is measured in units of $\xi$ and $\tau_c$. */

#include <numbers>

#include "lattice/model/cantilever.hpp"

namespace lattice {

/// Conversions between SI units and those of the chain.
struct ArrayUnits {
  Scales scales = CantileverArray{}.scales();

  /// Milliseconds to units of tau_c.
  double time(double ms) const { return ms * 1e-3 / scales.tau_c(); }
  /// Units of tau_c to milliseconds.
  double milliseconds(double t) const { return t * scales.tau_c() * 1e3; }
  /// Metres per second to units of the chain.
  double velocity(double si) const { return si / scales.unit_velocity(); }
  /// A displacement of the chain in micrometres.
  double micrometres(double y) const { return y * scales.xi() * 1e6; }
  /// A rate of the chain in 1/s.
  double per_second(double rate) const { return rate / scales.tau_c(); }
  /// A power of the chain in watts.
  double watts(double power) const { return scales.unit_energy() * per_second(power); }
  /// A frequency in hertz as an angular one of the chain.
  double omega(double hertz) const { return 2 * std::numbers::pi * hertz * scales.tau_c(); }
  /// An angular frequency of the chain in hertz.
  double hertz(double omega) const { return omega / (2 * std::numbers::pi * scales.tau_c()); }
  /// The damping rate nu for a lifetime of the energy in ms; zero means no damping.
  double rate(double lifetime) const { return lifetime > 0 ? 1 / time(lifetime) : 0; }
};

}  // namespace lattice
